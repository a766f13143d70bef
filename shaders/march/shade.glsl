// Normal and openness at a hit.

// Difference quotient of a field one voxel to each side, one-sided at the border, per smallest spacing. The samples are
// the trilinear interpolant, so the gradient is continuous from cell to cell. Both taps have the same fraction of a
// voxel, so the 8-bit weights of hardware filters shift the point by at most 1/512 voxel and add no noise. The factor
// keeps differences of levels near the end of float finite.
const float kOverflowGuard = 0.25f;

// Trilinear: two bilinear taps, one per layer.
float fieldAt(sampler2DArray field, vec3 position) {
  vec3 size = vec3(frame.gridSize.xyz);
  vec2 at = (position.xy + 0.5f) / size.xy;
  float layer = min(floor(position.z), size.z - 2.0f);
  return kOverflowGuard *
         mix(texture(field, vec3(at, layer)).r, texture(field, vec3(at, layer + 1.0f)).r, position.z - layer);
}

vec3 gradientAt(sampler2DArray field, vec3 position) {
  vec3 before = max(position - 1.0f, vec3(0.0f));
  vec3 after = min(position + 1.0f, vec3(frame.gridSize.xyz - 1));
  vec3 difference = vec3(fieldAt(field, vec3(after.x, position.yz)) - fieldAt(field, vec3(before.x, position.yz)),
                         fieldAt(field, vec3(position.x, after.y, position.z)) -
                             fieldAt(field, vec3(position.x, before.y, position.z)),
                         fieldAt(field, vec3(position.xy, after.z)) - fieldAt(field, vec3(position.xy, before.z)));
  return difference / ((after - before) * frame.scale.xyz);
}

// Just below the end of float.
const float kLargestGradient = 3e38f;

// Unit, in grid axes, out of the solid. No gradient (a flat spot), or levels so large that their interpolation overflows:
// towards the viewer.
vec3 hitNormal(Hit hit, vec3 viewer) {
  if (hit.capAxis >= 0) {
    vec3 face = vec3(0.0f);
    face[hit.capAxis] = hit.position[hit.capAxis] > 0.5f ? 1.0f : -1.0f;
    return face;
  }
  vec3 gradient = frame.modes.y == 0 ? -gradientAt(levelTexture, hit.position) : gradientAt(distanceTexture, hit.position);
  float magnitude = abs(gradient.x) + abs(gradient.y) + abs(gradient.z);
  if (!(magnitude > kSmallestLevel && magnitude < kLargestGradient)) return viewer;
  return normalize(gradient / magnitude);
}

// Trilinear interpolation by hand: filters round their weights to 8 bits, and llvmpipe even the result for RGBA8, which
// would show as steps in dark places.
vec4 octantsAt(sampler3D octants, vec3 position) {
  ivec3 low = min(ivec3(position), frame.gridSize.xyz - 2);
  vec3 weight = position - vec3(low);
  vec4 sum[2];
  for (int z = 0; z < 2; ++z) {
    vec4 near = mix(texelFetch(octants, low + ivec3(0, 0, z), 0), texelFetch(octants, low + ivec3(1, 0, z), 0), weight.x);
    vec4 far = mix(texelFetch(octants, low + ivec3(0, 1, z), 0), texelFetch(octants, low + ivec3(1, 1, z), 0), weight.x);
    sum[z] = mix(near, far, weight.y);
  }
  return mix(sum[0], sum[1], weight.z);
}

// The octants are read frame.scale.w voxels above the surface along the normal: 0 is [Singh10]. Next to the surface Eq. 7
// makes it occlude itself by an amount that depends on where it cuts the voxels, which shows as stripes.
float hitAmbient(vec3 hit, vec3 normal) {
  vec3 above = hit + frame.scale.w * normal;
  vec3 position = clamp(above, vec3(0.0f), vec3(frame.gridSize.xyz - 1));
  GeometryAddress address = geometryAddress(normal, float(textureSize(geometry0Texture, 0).x));
  vec4 geometry0 = texture(geometry0Texture, address.uv);
  vec4 geometry1 = texture(geometry1Texture, address.uv);
  vec4 visibility0 = openBeyondBorder(octantsAt(octants0Texture, position), above - position, -1.0f);
  vec4 visibility1 = openBeyondBorder(octantsAt(octants1Texture, position), above - position, 1.0f);
  return address.swapped ? ambientOpenness(visibility0, visibility1, geometry1, geometry0)
                         : ambientOpenness(visibility0, visibility1, geometry0, geometry1);
}
