#version 450 core
// Areas of the disk, whose depths are known by two moments; one ball, or two (line.frag says why).
#include "screen/harness.glsl"

layout(binding = 5) uniform sampler2D momentTexture;  // mean depth, mean squared depth; each level a quarter of the texels

// The level whose texels are as large as the circle; between levels, and between texels, interpolated.
DepthSpread depthSpread(vec2 at, float share) {
  SeenPixel seen = seenPixel(screen.picture, place.position + alongAxes(place.axes, vec3(at, 0.0f)));
  const float kPi = 3.141592654f;
  float radius = 1.0f / (screen.picture.z * (1.0f + place.position.z * screen.picture.w));
  float level = 0.5f * log2(kPi * radius * radius * share);
  vec2 moments = textureLod(momentTexture, seen.pixel / vec2(screen.size.xy), max(level, 0.0f)).rg;
  float deviation = sqrt(max(moments.y - moments.x * moments.x, 0.0f));
  // Along the ray a depth is longer than along the view.
  return DepthSpread((moments.x - place.position.z) / place.axes.z.z, deviation / place.axes.z.z);
}

#include "screen/ball_line.glsl"
#include "screen/area.glsl"

float estimate(Shaded shaded) {
  float openness = areaOpenness(shaded, 1.0f);
  return screen.toY.w > 0.0f ? openness * areaOpenness(shaded, screen.toY.w) : openness;
}

#include "screen/main.glsl"
