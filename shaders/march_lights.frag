#version 450 core
// Light as sweeps give it, at the samples around the hit (sweep/ordinates), times its colour.
#include "lib/disc_light.glsl"
#include "march/light_counts.glsl"
#include "march/light_at.glsl"
#include "march/scene.glsl"
#include "shared/light_uniforms.h"
#include "march/suns.glsl"

layout(std140, binding = 1) uniform LightBlock { LightUniforms lights; };
layout(binding = 8) uniform sampler2DArray lightTextures[max(kLightFields, 1)];

vec3 hitLight(vec3 hit, vec3 normal, vec3 viewer) {
  vec3 low = min(floor(hit), vec3(frame.gridSize.xyz - 2));
  vec2 centre = (low.xy + 1.0f) / vec2(frame.gridSize.xy);
  vec3 sum = lights.head.rgb * abs(dot(normal, viewer));
  for (int i = 0; i < kLightFields; ++i) {
    float light = lightAt(lightTextures[i], centre, low.z, hit - low);
    if ((kDiscs >> i & 1) != 0) light *= discCosine(dot(normal, lights.disc[i].xyz), lights.disc[i].w);
    sum += light * lights.color[i].rgb;
  }
  return sum + sunLight(lights, hit, normal);
}

#include "march/main.glsl"
