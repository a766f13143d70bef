#version 450 core
// A head light: N . V.
#include "march/scene.glsl"

float hitLight(vec3 hit, vec3 normal, vec3 viewer) { return abs(dot(normal, viewer)); }

#include "march/main.glsl"
