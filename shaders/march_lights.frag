#version 450 core
// Light as sweeps give it, at the samples around the hit (sweep/ordinates), times its colour.
#include "lib/disc_light.glsl"
#include "march/light_counts.glsl"
#include "march/light_at.glsl"
#include "march/scene.glsl"
#include "march/agreement.glsl"
#include "shared/light_uniforms.h"
#include "march/suns.glsl"

layout(std140, binding = 1) uniform LightBlock { LightUniforms lights; };
layout(binding = 8) uniform sampler2DArray lightTextures[max(kLightFields, 1)];

vec3 hitLight(SurfacePoint point, vec3 viewer) {
  LightPlace within = lightPlace(point.position, point.capAxis, vec3(frame.gridSize.xyz));
  LightPlace place = within;
  if (point.capAxis < 0) weighByAgreement(place, point);
  vec3 sum = lights.head.rgb * abs(dot(point.normal, viewer));
  for (int i = 0; i < kLightFields; ++i) {
    bool everywhere = (kVolumes >> i & 1) != 0;
    float light = everywhere ? lightAt(lightTextures[i], within) : lightAt(lightTextures[i], place);
    if ((kDiscs >> i & 1) != 0) light *= discCosine(dot(point.normal, lights.disc[i].xyz), lights.disc[i].w);
    sum += light * lights.color[i].rgb;
  }
  return sum + sunLight(lights, point.position, point.normal);
}

#include "march/main.glsl"
