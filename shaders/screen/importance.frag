#version 450 core
// Directions drawn where the sky is bright.
#include "screen/harness.glsl"

layout(binding = 8) uniform samplerCubeArray coneTexture;  // the widest cone alone
layout(binding = 14) uniform sampler2D drawTexture;

vec4 skyTexel(int cell, int i) { return texelFetch(drawTexture, ivec2(i, cell), 0); }
vec3 openLight(vec3 normal) { return textureLod(coneTexture, vec4(normal, float(kConeAngles - 1)), 0.0f).rgb; }
vec3 frameDirection(vec3 v) { return inAxes(place.axes, cameraFromGrid(v)); }

#include "screen/march_to.glsl"
#include "screen/importance.glsl"

vec4 estimate(Shaded shaded) { return importanceLight(shaded); }

#include "screen/main.glsl"
