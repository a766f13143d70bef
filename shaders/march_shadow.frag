#version 450 core
// A light infinitely far away, with its hard shadow: N . w where it arrives.
#include "march/scene.glsl"
#include "march/shadow.glsl"

layout(location = 1) uniform vec3 towardsLight;  // unit, grid axes

vec3 hitLight(vec3 hit, vec3 normal, vec3 viewer) {
  return vec3(dot(normal, towardsLight) * lightVisibility(hit, normal, towardsLight / frame.scale.xyz));
}

#include "march/main.glsl"
