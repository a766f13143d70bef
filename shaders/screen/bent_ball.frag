#version 450 core
// Bent normals by points of the half ball.
#include "screen/harness.glsl"
#include "screen/bent.glsl"
#include "screen/march_to.glsl"
#include "screen/bent_points.glsl"

vec4 estimate(Shaded shaded) { return storedBend(ballBent(shaded)); }

#include "screen/main.glsl"
