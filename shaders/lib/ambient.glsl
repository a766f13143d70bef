// A = sum_s V_s G_s(N) / pi, the openness of a surface point ([Singh10] Eq. 3 and 4, normalised: an open point gives 1).

// Where the geometry terms of a unit normal stand in the two tables of size x size texels (sweep/geometry_terms.h):
// texture coordinates of r = N.xy / sqrt(1 + |N.z|), |r|^2 = 1 - |N.z|, with r = -1 and 1 at the centres of the first and
// last texel; and whether the tables change places (N.z < 0).
struct GeometryAddress {
  vec2 uv;
  bool swapped;
};

GeometryAddress geometryAddress(vec3 normal, float size) {
  float stretch = 0.5f * (size - 1.0f) / size / sqrt(1.0f + abs(normal.z));
  return GeometryAddress(vec2(0.5f + normal.x * stretch, 0.5f + normal.y * stretch), normal.z < 0.0f);
}

const float kInversePi = 0.318309886184f;

// Octants 0 to 3 and 4 to 7. Rounded tables and 8-bit octants may exceed 1 by a rounding error.
float ambientOpenness(vec4 visibility0, vec4 visibility1, vec4 geometry0, vec4 geometry1) {
  return clamp((dot(visibility0, geometry0) + dot(visibility1, geometry1)) * kInversePi, 0.0f, 1.0f);
}
