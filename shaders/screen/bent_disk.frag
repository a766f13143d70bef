#version 450 core
// Bent normals by points of the disk in the tangent plane.
#include "screen/harness.glsl"
#include "screen/bent.glsl"
#include "screen/march_to.glsl"
#include "screen/bent_points.glsl"

vec4 estimate(Shaded shaded) { return storedBend(diskBent(shaded)); }

#include "screen/main.glsl"
