#version 450 core
// Openness and bend as the volume's sweeps give them (sweep/ordinates/light_sweeps.h).
#include "screen/harness.glsl"
#include "march/light_at.glsl"
#include "screen/swept.glsl"

// As of bent.glsl, in the axes of the grid already.
vec4 estimate(Shaded shaded) {
  LightPlace at = sweptPlace();
  float fields[kSweptFields];
  for (int i = 0; i < kSweptFields; ++i) fields[i] = lightAt(sweptTextures[i], at);
  vec3 mean = 2.0f * vec3(fields[1], fields[2], fields[3]) - 1.0f;
  return vec4(fields[0] * (mean - 0.5f * gridDirection(shaded.normal)), fields[0]);
}

#include "screen/main.glsl"
