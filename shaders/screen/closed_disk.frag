#version 450 core
// The openness of bent_disk.frag alone.
#include "screen/harness.glsl"
#include "screen/bent.glsl"
#include "screen/march_to.glsl"
#include "screen/bent_points.glsl"

float estimate(Shaded shaded) { return diskBent(shaded).share; }

#include "screen/main.glsl"
