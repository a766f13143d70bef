// Normal at a hit.

// Difference quotient of a field one voxel to each side, one-sided at the border, per smallest spacing. The samples are
// the trilinear interpolant, so the gradient is continuous from cell to cell. Weighed by hand: filters round their
// weights to 8 bits. Ten lookups of four texels each are the 32 samples around a cell; they clamp to the edge, which
// makes the difference one-sided there. The factor keeps differences of levels near the end of float finite.
const float kOverflowGuard = 0.25f;

// Four texels around the common corner `at` of a layer: x, y of the lower row in xy, of the upper one in zw.
vec4 texelsAround(sampler2DArray field, vec2 at, float layer) {
  return kOverflowGuard * textureGather(field, vec3(at, layer)).wzxy;
}

vec3 gradientAt(sampler2DArray field, vec3 position) {
  vec3 size = vec3(frame.gridSize.xyz);
  vec3 low = min(floor(position), size - 2.0f);
  vec3 weight = position - low;
  vec2 texel = 1.0f / size.xy;
  vec2 centre = (low.xy + 1.0f) * texel;
  vec2 stepX = vec2(texel.x, 0.0f);
  vec2 stepY = vec2(0.0f, texel.y);
  vec2 across[2];   // differences along x and y in the two layers of the cell
  float middle[2];  // and the value between
  for (int z = 0; z < 2; ++z) {
    float layer = low.z + float(z);
    vec4 left = texelsAround(field, centre - stepX, layer);
    vec4 right = texelsAround(field, centre + stepX, layer);
    vec4 down = texelsAround(field, centre - stepY, layer);
    vec4 up = texelsAround(field, centre + stepY, layer);
    vec2 leftOfY = mix(left.xy, left.zw, weight.y);
    vec2 rightOfY = mix(right.xy, right.zw, weight.y);
    vec2 downOfX = mix(down.xz, down.yw, weight.x);
    vec2 upOfX = mix(up.xz, up.yw, weight.x);
    across[z] = vec2(mix(rightOfY.x, rightOfY.y, weight.x) - mix(leftOfY.x, leftOfY.y, weight.x),
                     mix(upOfX.x, upOfX.y, weight.y) - mix(downOfX.x, downOfX.y, weight.y));
    middle[z] = mix(leftOfY.y, rightOfY.x, weight.x);
  }
  vec4 below = texelsAround(field, centre, max(low.z - 1.0f, 0.0f));
  vec4 above = texelsAround(field, centre, min(low.z + 2.0f, size.z - 1.0f));
  vec2 belowOfX = mix(below.xz, below.yw, weight.x);
  vec2 aboveOfX = mix(above.xz, above.yw, weight.x);
  float along = mix(middle[1], mix(aboveOfX.x, aboveOfX.y, weight.y), weight.z) -
                mix(mix(belowOfX.x, belowOfX.y, weight.y), middle[0], weight.z);
  vec3 before = max(position - 1.0f, vec3(0.0f));
  vec3 after = min(position + 1.0f, size - 1.0f);
  return vec3(mix(across[0], across[1], weight.z), along) / ((after - before) * frame.scale.xyz);
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
  vec3 gradient = frame.modes.x == 0 ? -gradientAt(levelTexture, hit.position) : gradientAt(distanceTexture, hit.position);
  float magnitude = abs(gradient.x) + abs(gradient.y) + abs(gradient.z);
  if (!(magnitude > kSmallestLevel && magnitude < kLargestGradient)) return viewer;
  return normalize(gradient / magnitude);
}
