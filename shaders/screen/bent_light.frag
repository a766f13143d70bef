#version 450 core
// From openness and bend to light, by the convolved sky; where nothing is seen, 1.
#include "screen/block.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D lightTexture;
layout(binding = 8) uniform samplerCubeArray coneTexture;
layout(location = 0) out vec4 outLight;

// Of a texture that holds the widest cone alone OpenGL takes that one for every layer.
vec3 coneLight(vec3 direction, float layer) { return textureLod(coneTexture, vec4(direction, layer), 0.0f).rgb; }

#include "screen/bent_light.glsl"

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bool seen = texelFetch(depthTexture, pixel, 0).r < kNothingSeen;
  vec4 stored = texelFetch(lightTexture, pixel, 0);
  vec3 normal = texelFetch(normalTexture, pixel, 0).xyz;
  outLight = seen ? vec4(bentLight(screen.march.w & 3, (screen.march.w & 4) != 0, normal, stored), stored.w) : vec4(1.0f);
}
