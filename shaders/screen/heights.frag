#version 450 core
// The upper envelope of the solid along the grid's z axis, one column per pixel: the height field of characteristic.glsl.
#include "shared/frame_uniforms.h"

layout(std140, binding = 0) uniform FrameBlock { FrameUniforms frame; };
layout(binding = 3) uniform sampler2DArray levelTexture;
layout(location = 0) out float outHeight;  // index space; -1 where the column has no solid

void main() {
  ivec2 column = ivec2(gl_FragCoord.xy);
  int top = frame.gridSize.z - 1;
  float above = texelFetch(levelTexture, ivec3(column, top), 0).r;
  outHeight = above > 0.0f ? float(top) : -1.0f;
  for (int z = top - 1; z >= 0 && outHeight < 0.0f; --z) {
    float level = texelFetch(levelTexture, ivec3(column, z), 0).r;
    if (level > 0.0f) outHeight = float(z) + level / (level - above);
    above = level;
  }
}
