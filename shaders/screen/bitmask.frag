#version 450 core
// Sectors that what is seen closes.
#include "screen/harness.glsl"
#include "screen/horizon.glsl"
#include "screen/bitmask.glsl"

float estimate(Shaded shaded) { return bitmaskOpenness(shaded); }

#include "screen/main.glsl"
