#version 450 core
// The light of eight octants through the tables of their geometry terms: sum I_s V_s G_s(N) / pi ([Singh10] Eq. 4).
#include "shared/octant_lights.h"
#include "lib/ambient.glsl"
#include "march/scene.glsl"

layout(std140, binding = 2) uniform OctantBlock { OctantLights octants; };
layout(binding = 3) uniform sampler3D octants0Texture;
layout(binding = 4) uniform sampler3D octants1Texture;
layout(binding = 5) uniform sampler2D geometry0Texture;
layout(binding = 6) uniform sampler2D geometry1Texture;

// Trilinear interpolation by hand: filters round their weights to 8 bits, and llvmpipe even the result for RGBA8, which
// would show as steps in dark places.
vec4 octantsAt(sampler3D field, vec3 position) {
  ivec3 low = min(ivec3(position), frame.gridSize.xyz - 2);
  vec3 weight = position - vec3(low);
  vec4 sum[2];
  for (int z = 0; z < 2; ++z) {
    vec4 near = mix(texelFetch(field, low + ivec3(0, 0, z), 0), texelFetch(field, low + ivec3(1, 0, z), 0), weight.x);
    vec4 far = mix(texelFetch(field, low + ivec3(0, 1, z), 0), texelFetch(field, low + ivec3(1, 1, z), 0), weight.x);
    sum[z] = mix(near, far, weight.y);
  }
  return mix(sum[0], sum[1], weight.z);
}

// The octants are read frame.scale.w voxels above the surface along the normal: 0 is [Singh10]. Next to the surface Eq. 7
// makes it occlude itself by an amount that depends on where it cuts the voxels, which shows as stripes.
vec3 hitLight(SurfacePoint point, vec3 viewer) {
  vec3 above = point.position + frame.scale.w * point.normal;
  vec3 position = clamp(above, vec3(0.0f), vec3(frame.gridSize.xyz - 1));
  GeometryAddress address = geometryAddress(point.normal, float(textureSize(geometry0Texture, 0).x));
  vec4 geometry0 = texture(geometry0Texture, address.uv);
  vec4 geometry1 = texture(geometry1Texture, address.uv);
  vec4 visibility0 = openBeyondBorder(octantsAt(octants0Texture, position), above - position, -1.0f);
  vec4 visibility1 = openBeyondBorder(octantsAt(octants1Texture, position), above - position, 1.0f);
  return address.swapped ? octantLight(octants, visibility0, visibility1, geometry1, geometry0)
                         : octantLight(octants, visibility0, visibility1, geometry0, geometry1);
}

#include "march/main.glsl"
