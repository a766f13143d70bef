#version 450 core
// Weighed points in the ball, or in two balls (line.frag says why).
#include "screen/harness.glsl"
#include "screen/points.glsl"

float estimate(Shaded shaded) {
  float openness = pointsOpenness(shaded, 1.0f);
  return screen.toY.w > 0.0f ? openness * pointsOpenness(shaded, screen.toY.w) : openness;
}

#include "screen/main.glsl"
