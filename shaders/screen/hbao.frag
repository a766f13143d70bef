#version 450 core
// Horizons with distance falloff.
#include "screen/harness.glsl"
#include "screen/horizon.glsl"
#include "screen/bent.glsl"
#include "screen/hbao.glsl"

float estimate(Shaded shaded) { return hbaoOpenness(shaded); }

#include "screen/main.glsl"
