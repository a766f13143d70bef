#version 450 core
// The picture: albedo times light^(1 / gamma) where something is seen.
#include "screen/block.glsl"
#include "shared/frame_uniforms.h"

layout(std140, binding = 0) uniform FrameBlock { FrameUniforms frame; };
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 2) uniform sampler2D lightTexture;
layout(location = 0) out vec4 outColor;  // linear, premultiplied

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool seen = texelFetch(depthTexture, pixel, 0).r < kNothingSeen;
  vec3 light = texelFetch(lightTexture, pixel, 0).rgb;
  outColor = seen ? vec4(frame.albedo.rgb * pow(light, vec3(frame.albedo.w)), 1.0f) : frame.background;
}
