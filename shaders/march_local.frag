#version 450 core
// A head light: N . V.
#include "march/scene.glsl"

vec3 hitLight(vec3 hit, vec3 normal, vec3 viewer) { return vec3(abs(dot(normal, viewer))); }

#include "march/main.glsl"
