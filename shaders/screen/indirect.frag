#version 450 core
// Light from the neighbourhood ([SzirmayGpu] Sec. 2, 3.1): the mean radiance of the surface around the shaded point,
// over samples of the disk across the view. A sample counts if what it sees lies within the radius, faces the shaded
// point, and is faced by it; its radiance is albedo times its openness. No such sample: 0.
#include "screen/harness.glsl"
#include "screen/albedo.glsl"

layout(binding = 2) uniform sampler2D lightTexture;
layout(location = 0) out vec4 outRadiance;

vec3 radianceAround(Shaded shaded) {
  vec3 normal = alongAxes(place.axes, place.normal);
  vec3 sum = vec3(0.0f);
  float count = 0.0f;
  for (int i = 0; i < sampleCount(); ++i) {
    vec4 each = sampleAt(i);
    vec3 at = place.position + alongAxes(place.axes, vec3(turnedBy(shaded.turn, each.x, each.y), 0.0f));
    SeenPixel seen = seenPixel(screen.picture, at);
    ivec2 pixel = ivec2(floor(seen.pixel));
    float depth = seen.found ? depthOf(pixel) : kNothingSeen;
    if (depth >= kNothingSeen) continue;
    vec3 point = cameraPoint(screen.picture, vec2(pixel) + 0.5f, depth);
    vec3 other = cameraFromGrid(texelFetch(normalTexture, pixel, 0).xyz);
    vec3 offset = point - place.position;
    bool facing = dot(normal, offset) > kSurfaceTolerance && dot(other, offset) < -kSurfaceTolerance;
    if (dot(offset, offset) < 1.0f && facing) {
      sum += albedoOf(pixel) * texelFetch(lightTexture, pixel, 0).a;
      count += 1.0f;
    }
  }
  return count > 0.0f ? sum / count : vec3(0.0f);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depthTexture, pixel, 0).r;
  outRadiance = vec4(0.0f);
  if (depth >= kNothingSeen) return;
  place = placeOf(pixel, depth);
  outRadiance = vec4(radianceAround(shadedAt(pixel)), 1.0f);
}
