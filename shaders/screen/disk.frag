#version 450 core
// Pipes on the disk across the view.
#include "screen/harness.glsl"
#include "screen/disk.glsl"

float estimate(Shaded shaded) { return diskOpenness(shaded); }

#include "screen/main.glsl"
