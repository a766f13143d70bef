#version 450 core
// Openness and mean open direction as the volume's sweeps give them (sweep/ordinates/light_sweeps.h), at the hit: openness,
// and the components of the direction along the grid's axes, where 0 and 1 stand for -1 and 1.
#include "screen/harness.glsl"
#include "march/light_at.glsl"

const int kSweptFields = 4;
layout(binding = 9) uniform sampler2DArray sweptTextures[kSweptFields];

// As of bent.glsl; the estimate of one place, in the axes of the grid already.
vec4 estimate(Shaded shaded) {
  vec3 index = clamp(gridIndex(vec3(0.0f)), vec3(0.0f), vec3(frame.gridSize.xyz - 1));
  vec3 low = min(floor(index), vec3(frame.gridSize.xyz - 2));
  vec2 centre = (low.xy + 1.0f) / vec2(frame.gridSize.xy);
  float fields[kSweptFields];
  for (int i = 0; i < kSweptFields; ++i) fields[i] = lightAt(sweptTextures[i], centre, low.z, index - low);
  vec3 mean = 2.0f * vec3(fields[1], fields[2], fields[3]) - 1.0f;
  return vec4(fields[0] * (mean - 0.5f * gridDirection(shaded.normal)), fields[0]);
}

#include "screen/main.glsl"
