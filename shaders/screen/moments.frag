#version 450 core
// Depth and its square, whose means over an area tell mean and deviation. Pixels that show nothing count as the far side
// of the grid: farther ones would drown everything that shares an area with them.
#include "screen/block.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(location = 0) out vec2 outMoments;

void main() {
  float depth = min(texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r, screen.depthRow.w);
  outMoments = vec2(depth, depth * depth);
}
