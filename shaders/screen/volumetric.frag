#version 450 core
// Pipes through the tangent sphere.
#include "screen/harness.glsl"
#include "screen/volumetric.glsl"

float estimate(Shaded shaded) { return volumetricOpenness(shaded); }

#include "screen/main.glsl"
