#version 450 core
// Openness as the ordinates give it, at the samples around the hit (sweep/ordinates/openness_sweep.h).
#include "march/scene.glsl"

layout(binding = 3) uniform sampler2DArray opennessTexture;

// Trilinear, weighed by hand: filters round their weights to 8 bits. All corners of a cell that the surface crosses hold
// a value, and so do all solid samples on the border, where caps are hit.
float hitLight(vec3 hit, vec3 normal, vec3 viewer) {
  vec3 low = min(floor(hit), vec3(frame.gridSize.xyz - 2));
  vec3 weight = hit - low;
  vec2 centre = (low.xy + 1.0f) / vec2(frame.gridSize.xy);
  vec4 sides[2];
  for (int z = 0; z < 2; ++z) sides[z] = textureGather(opennessTexture, vec3(centre, low.z + float(z))).wzxy;
  vec4 texels = mix(sides[0], sides[1], weight.z);
  vec2 alongX = mix(texels.xz, texels.yw, weight.x);
  return mix(alongX.x, alongX.y, weight.y);
}

#include "march/main.glsl"
