#version 450 core
// Bent normals by horizons with distance falloff.
#include "screen/harness.glsl"
#include "screen/horizon.glsl"
#include "screen/bent.glsl"
#include "screen/hbao.glsl"

vec4 estimate(Shaded shaded) { return storedBend(hbaoBent(shaded)); }

#include "screen/main.glsl"
