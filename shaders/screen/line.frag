#version 450 core
// Lines through the ball, or through two balls: the product keeps features of both sizes ([Loos10] Sec. 6).
#include "screen/harness.glsl"
#include "screen/ball_line.glsl"
#include "screen/line.glsl"

float estimate(Shaded shaded) {
  float openness = lineOpenness(shaded, 1.0f);
  return screen.toY.w > 0.0f ? openness * lineOpenness(shaded, screen.toY.w) : openness;
}

#include "screen/main.glsl"
