#version 450 core
// Horizons with the cosine of the normal.
#include "screen/harness.glsl"
#include "screen/horizon.glsl"
#include "screen/gtao.glsl"

float estimate(Shaded shaded) { return gtaoOpenness(shaded); }

#include "screen/main.glsl"
