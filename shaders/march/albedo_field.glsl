// The colour of the surface by a field on a grid of its own: interpolated between the known values of the eight samples
// around the hit. Where these weigh less than half, or beyond half a voxel outside the grid, none is known. Weighed by
// hand: filters round their weights to 8 bits, which is a step of colour.
#include "shared/color_block.h"

layout(std140, binding = 3) uniform ColorBlock { ColorUniforms colors; };
layout(binding = 16) uniform sampler3D colorField;  // places along the colours; kUnknown and above: none is known
layout(binding = 17) uniform sampler2D colorMap;    // linear

const float kUnknown = 1e38f;

// Sum of the known places by their weights, and of these.
vec2 colorPlaceAt(vec3 at) {
  ivec3 last = colors.size.xyz - 1;
  vec3 inside = clamp(at, vec3(0.0f), vec3(last));
  ivec3 low = min(ivec3(inside), max(last - 1, ivec3(0)));
  vec3 share = inside - vec3(low);
  vec2 sum = vec2(0.0f);
  for (int i = 0; i < 8; ++i) {
    ivec3 side = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 each = mix(1.0f - share, share, vec3(side));
    float place = texelFetch(colorField, min(low + side, last), 0).r;
    float weight = place < kUnknown ? each.x * each.y * each.z : 0.0f;
    sum += weight * vec2(place, 1.0f);
  }
  return sum;
}

vec3 albedoAt(vec3 hit) {
  vec4 h = vec4(hit, 1.0f);
  vec3 at = vec3(dot(colors.toX, h), dot(colors.toY, h), dot(colors.toZ, h));
  vec2 place = colorPlaceAt(at);
  vec3 beyond = max(-at, at - vec3(colors.size.xyz - 1));
  if (place.y < 0.5f || max(beyond.x, max(beyond.y, beyond.z)) > 0.5f) return colors.unknown.rgb;
  float along = clamp(place.x / place.y, 0.0f, 1.0f) * float(colors.size.w - 1);
  int first = min(int(along), colors.size.w - 2);
  return mix(texelFetch(colorMap, ivec2(first, 0), 0).rgb, texelFetch(colorMap, ivec2(first + 1, 0), 0).rgb,
             along - float(first));
}
