// What a point receives of the sky by its openness O, its normal N and its mean open direction N_b ([Klehm11] Sec. 3).
// The includer provides
//   vec3 coneLight(vec3 direction, float layer)  L_c about a direction, of the layer's angle (layer + 1) / kConeAngles of
//                                                pi / 2 (raymarch/screen/sky_convolution.h)
// All give O under an even sky but the geometric term.

// Values of BentLight.
const int kByNormal = 0;
const int kByBentNormal = 1;
const int kByBentCone = 2;

const float kRightAngle = 1.570796327f;

// Half-angles from the mean open direction; a whole hemisphere, of mean length 1/2, gives pi / 2. The paper's is linear in
// the length (Sec. 3.2). A cap of half-angle C has a mean of length (1 + cos C) / 2, which the other one inverts: it is
// wider, 66 degrees in place of 53 in a right-angled edge.
float bentCone(vec3 mean) { return (1.0f - clamp(2.0f * length(mean) - 1.0f, 0.0f, 1.0f)) * kRightAngle; }
float bentCap(vec3 mean) { return acos(clamp(2.0f * length(mean) - 1.0f, 0.0f, 1.0f)); }

// L_p: the cone of pi / 2.
vec3 openLight(vec3 direction) { return coneLight(direction, float(kConeAngles - 1)); }

// Between the layers whose angles enclose it; narrower cones than the first take that one.
vec3 lightWithin(vec3 direction, float cone) {
  float place = clamp(cone / kRightAngle * float(kConeAngles) - 1.0f, 0.0f, float(kConeAngles - 1));
  float below = min(floor(place), float(kConeAngles - 2));
  return mix(coneLight(direction, below), coneLight(direction, below + 1.0f), place - below);
}

// (w . N) ~ (w . N_b) (N_b . N), with unit N_b (Sec. 3.4), and the paper's t = 1 / (1 - cos C) in place of 1 / sin^2 C:
// the openness has no cosine, so the cone stands for a solid angle.
float geometricTerm(vec3 bent, vec3 normal, float cone) { return max(dot(bent, normal), 0.0f) * (1.0f + cos(cone)); }

// `stored` as in bent.glsl, with the axes of the normal. Nothing open: dark. `term`: of cones.
vec3 bentLight(int by, bool term, vec3 normal, vec4 stored) {
  if (by == kByNormal) return stored.w * openLight(normal);
  if (stored.w <= 0.0f) return vec3(0.0f);
  vec3 mean = 0.5f * normal + vec3(stored.x, stored.y, stored.z) / stored.w;
  // A mean of 0 has no direction: as open as the normal's.
  vec3 bent = length(mean) > 0.0f ? normalize(mean) : normal;
  if (by == kByBentNormal) return stored.w * openLight(bent);
  float cone = by == kByBentCone ? bentCone(mean) : bentCap(mean);
  vec3 light = stored.w * lightWithin(bent, cone);
  return term ? geometricTerm(bent, normal, cone) * light : light;
}
