#version 450 core
// A head light: N . V.
#include "march/scene.glsl"

vec3 hitLight(SurfacePoint point, vec3 viewer) { return vec3(abs(dot(point.normal, viewer))); }

#include "march/main.glsl"
