// Volumetric ambient occlusion: the share of the tangent sphere (radius 1/2 about N / 2) that lies outside, in pipes
// along the view: V = sum_i w_i dz_i ([Szirmay10] Eq. 7). The samples hold a point of the unit disk, its half chord
// sqrt(1 - x^2 - y^2), and w_i = 1 / F.
float volumetricOpenness(Shaded shaded) {
  vec3 centre = 0.5f * shaded.normal;
  float sum = 0.0f;
  for (int i = 0; i < sampleCount(); ++i) {
    vec4 each = sampleAt(i);
    vec2 turned = turnedBy(shaded.turn, each.x, each.y);
    vec2 at = vec2(centre.x + 0.5f * turned.x, centre.y + 0.5f * turned.y);
    sum += each.w * outerLength(outerParts(at, centre.z - 0.5f * each.z, centre.z + 0.5f * each.z));
  }
  return clamp(sum, 0.0f, 1.0f);
}
