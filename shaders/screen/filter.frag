#version 450 core
// The box filter over the interleaving pattern ([Keller01]): the mean over as many pixels as the pattern has, of which
// only those count that lie near the tangent plane of this one and face its way.
#include "screen/block.glsl"
#include "screen/view.glsl"

layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(binding = 2) uniform sampler2D lightTexture;
layout(location = 0) out vec4 outLight;

// Radii, from the tangent plane: what is farther belongs to another surface, or to another part of a curved one.
const float kPlaneTolerance = 0.05f;
// Cosine between the normals, 37 degrees.
const float kFacingTolerance = 0.8f;

vec3 cameraFromGrid(vec3 v) { return vec3(dot(screen.toX.xyz, v), dot(screen.toY.xyz, v), dot(screen.toZ.xyz, v)); }

vec3 pointAt(ivec2 pixel, float depth) { return cameraPoint(screen.picture, vec2(pixel) + 0.5f, depth); }

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depthTexture, pixel, 0).r;
  if (depth >= kNothingSeen) {
    outLight = vec4(1.0f);
    return;
  }
  vec3 gridNormal = texelFetch(normalTexture, pixel, 0).xyz;
  vec3 normal = cameraFromGrid(gridNormal);
  vec3 point = pointAt(pixel, depth);
  vec4 sum = vec4(0.0f);
  float count = 0.0f;
  ivec2 first = max(pixel - screen.size.w / 2, ivec2(0));
  ivec2 last = min(pixel - screen.size.w / 2 + screen.size.w, screen.size.xy);
  for (int y = first.y; y < last.y; ++y) {
    for (int x = first.x; x < last.x; ++x) {
      ivec2 other = ivec2(x, y);
      float otherDepth = texelFetch(depthTexture, other, 0).r;
      bool near = abs(dot(pointAt(other, otherDepth) - point, normal)) < kPlaneTolerance;
      if (near && dot(texelFetch(normalTexture, other, 0).xyz, gridNormal) > kFacingTolerance) {
        sum += texelFetch(lightTexture, other, 0);
        count += 1.0f;
      }
    }
  }
  // The pixel itself counts always, unless its normal is 0.
  outLight = count > 0.0f ? sum / count : texelFetch(lightTexture, pixel, 0);
}
