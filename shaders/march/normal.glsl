// Normal at a hit.

// What hitNormal reads of the samples around a hit: differences of a field to both sides along x, y and z at the corners
// of its cell, x fastest, then y, in the two layers. The factor keeps those of levels near the end of float finite.
struct CornerSlopes {
  vec4 x[2];
  vec4 y[2];
  vec4 z[2];
};
const float kOverflowGuard = 0.25f;

// Four texels around the common corner `at` of a layer: x, y of the lower row in xy, of the upper one in zw.
vec4 texelsAround(sampler2DArray field, vec2 at, float layer) {
  return kOverflowGuard * textureGather(field, vec3(at, layer)).wzxy;
}

// Ten lookups of four texels each are the 32 samples around a cell; they clamp to the edge, which makes the difference
// one-sided there.
CornerSlopes cornerSlopes(sampler2DArray field, vec3 position) {
  vec3 size = vec3(frame.gridSize.xyz);
  vec3 low = min(floor(position), size - 2.0f);
  vec2 texel = 1.0f / size.xy;
  vec2 centre = (low.xy + 1.0f) * texel;
  vec2 stepX = vec2(texel.x, 0.0f);
  vec2 stepY = vec2(0.0f, texel.y);
  CornerSlopes slopes;
  vec4 middle[2];  // the corners themselves
  for (int z = 0; z < 2; ++z) {
    float layer = low.z + float(z);
    vec4 left = texelsAround(field, centre - stepX, layer);
    vec4 right = texelsAround(field, centre + stepX, layer);
    slopes.x[z] = right - left;
    slopes.y[z] = texelsAround(field, centre + stepY, layer) - texelsAround(field, centre - stepY, layer);
    middle[z] = vec4(left.y, right.x, left.w, right.z);
  }
  slopes.z[0] = middle[1] - texelsAround(field, centre, max(low.z - 1.0f, 0.0f));
  slopes.z[1] = texelsAround(field, centre, min(low.z + 2.0f, size.z - 1.0f)) - middle[0];
  return slopes;
}

float mixCorners(vec4 corners[2], vec3 weight) {
  vec4 layer = mix(corners[0], corners[1], weight.z);
  vec2 row = mix(layer.xy, layer.zw, weight.y);
  return mix(row.x, row.y, weight.x);
}

// Difference quotient of the trilinear interpolant one voxel to each side, one-sided at the border, per smallest spacing:
// continuous from cell to cell. Weighed by hand: filters round their weights to 8 bits.
vec3 gradientOf(CornerSlopes slopes, vec3 position) {
  vec3 size = vec3(frame.gridSize.xyz);
  vec3 weight = position - min(floor(position), size - 2.0f);
  vec3 before = max(position - 1.0f, vec3(0.0f));
  vec3 after = min(position + 1.0f, size - 1.0f);
  return vec3(mixCorners(slopes.x, weight), mixCorners(slopes.y, weight), mixCorners(slopes.z, weight)) /
         ((after - before) * frame.scale.xyz);
}

// Just below the end of float.
const float kLargestGradient = 3e38f;

// A point of the surface as it is shaded.
struct SurfacePoint {
  vec3 position;        // index space
  int capAxis;          // as of Hit
  vec3 normal;          // unit, in grid axes, out of the solid
  CornerSlopes slopes;  // around it, rising out of the solid; of a cap: 0
};

// No gradient (a flat spot), or levels so large that their interpolation overflows: towards the viewer.
SurfacePoint surfacePoint(Hit hit, vec3 viewer) {
  SurfacePoint point;
  point.position = hit.position;
  point.capAxis = hit.capAxis;
  if (hit.capAxis >= 0) {
    point.normal = vec3(0.0f);
    point.normal[hit.capAxis] = hit.position[hit.capAxis] > 0.5f ? 1.0f : -1.0f;
    for (int z = 0; z < 2; ++z) point.slopes.x[z] = point.slopes.y[z] = point.slopes.z[z] = vec4(0.0f);
    return point;
  }
  bool ofLevel = frame.modes.x == 0;
  if (ofLevel)
    point.slopes = cornerSlopes(levelTexture, hit.position);
  else
    point.slopes = cornerSlopes(distanceTexture, hit.position);
  float outwards = ofLevel ? -1.0f : 1.0f;
  for (int z = 0; z < 2; ++z) {
    point.slopes.x[z] *= outwards;
    point.slopes.y[z] *= outwards;
    point.slopes.z[z] *= outwards;
  }
  vec3 gradient = gradientOf(point.slopes, hit.position);
  float magnitude = abs(gradient.x) + abs(gradient.y) + abs(gradient.z);
  bool slopes = magnitude > kSmallestLevel && magnitude < kLargestGradient;
  point.normal = slopes ? normalize(gradient / magnitude) : viewer;
  return point;
}
