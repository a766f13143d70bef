#version 450 core
// The picture: albedo times light^(1 / gamma) where something is seen. With light from the neighbourhood, what is not
// open to the sky receives its mean radiance: light = O + L (1 - O) ([SzirmayGpu] Sec. 2).
#include "screen/block.glsl"
#include "shared/frame_uniforms.h"

layout(std140, binding = 0) uniform FrameBlock { FrameUniforms frame; };
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 2) uniform sampler2D lightTexture;
layout(binding = 6) uniform sampler2D radianceTexture;
#include "screen/albedo.glsl"

layout(location = 0) out vec4 outColor;  // linear, premultiplied

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool seen = texelFetch(depthTexture, pixel, 0).r < kNothingSeen;
  vec4 light = texelFetch(lightTexture, pixel, 0);
  if (screen.modes.w != 0) light.rgb += (1.0f - light.a) * texelFetch(radianceTexture, pixel, 0).rgb;
  outColor = seen ? vec4(albedoOf(pixel) * pow(light.rgb, vec3(frame.albedo.w)), 1.0f) : frame.background;
}
