#version 450 core
// Radiance of the sky from where it is open.
#include "screen/harness.glsl"

layout(binding = 13) uniform samplerCube radianceTexture;

vec3 skyRadiance(vec3 direction) { return textureLod(radianceTexture, direction, 0.0f).rgb; }

#include "screen/ssdo.glsl"

vec4 estimate(Shaded shaded) { return ssdoLight(shaded); }

#include "screen/main.glsl"
