// E / pi = sum_s I_s V_s G_s(N) / pi, the light of the octants at a surface point ([Singh10] Eq. 3 and 4, normalised: an
// open point under octants of light 1 gives 1, and this is its openness).

// Where the geometry terms of a unit normal stand in the two tables of size x size texels
// (sweep/octants/geometry_terms.h): texture coordinates of r = N.xy / sqrt(1 + |N.z|), |r|^2 = 1 - |N.z|, with r = -1
// and 1 at the centres of the first and last texel; and whether the tables change places (N.z < 0).
struct GeometryAddress {
  vec2 uv;
  bool swapped;
};

GeometryAddress geometryAddress(vec3 normal, float size) {
  float stretch = 0.5f * (size - 1.0f) / size / sqrt(1.0f + abs(normal.z));
  return GeometryAddress(vec2(0.5f + normal.x * stretch, 0.5f + normal.y * stretch), normal.z < 0.0f);
}

const float kInversePi = 0.318309886184f;

// Octants 0 to 3 and 4 to 7. Rounded tables and 8-bit octants may exceed an open point by a rounding error.
vec3 octantLight(OctantLights lights, vec4 visibility0, vec4 visibility1, vec4 geometry0, vec4 geometry1) {
  vec4 through0 = visibility0 * geometry0;
  vec4 through1 = visibility1 * geometry1;
  vec3 light = vec3(dot(through0, lights.low[0]) + dot(through1, lights.high[0]),
                    dot(through0, lights.low[1]) + dot(through1, lights.high[1]),
                    dot(through0, lights.low[2]) + dot(through1, lights.high[2]));
  return min(light * kInversePi, vec3(lights.most.x, lights.most.y, lights.most.z));
}

// Visibility of four octants with the same sign of z (zSign: towards their light; channel order of sweep/octants.h) at a
// point that lies `beyond` the border of the grid, from that at the border: within a voxel it opens to the light that
// enters there.
vec4 openBeyondBorder(vec4 visibility, vec3 beyond, float zSign) {
  float x = clamp(beyond.x, -1.0f, 1.0f);
  float y = clamp(beyond.y, -1.0f, 1.0f);
  float z = clamp(beyond.z * zSign, 0.0f, 1.0f);
  vec4 fromX = x > 0.0f ? vec4(0.0f, x, 0.0f, x) : vec4(-x, 0.0f, -x, 0.0f);
  vec4 fromY = y > 0.0f ? vec4(0.0f, 0.0f, y, y) : vec4(-y, -y, 0.0f, 0.0f);
  return mix(visibility, vec4(1.0f), max(max(fromX, fromY), vec4(z)));
}
