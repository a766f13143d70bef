// Pipes on the disk across the view, with mu(r) = r^4: O = (1 / n) sum_i h_i with
//   h = integral of 4 (p . N) dz over the part of the pipe in the unit ball, above the tangent plane and outside,
// which is a polynomial of z ([SzirmayGpu] Sec. 4.5). The samples hold a point of the unit disk and its half chord.
// Normalised by the samples, the sum is divided by that of the same pipes in the open.

const float kMembershipDegree = 4.0f;

float diskIntegral(float across, float normalZ, vec2 part) {
  float length = part.y - part.x;
  return kMembershipDegree * length * (across + 0.5f * normalZ * (part.x + part.y));
}

float diskOpenness(Shaded shaded) {
  float open = 0.0f;
  float whole = 0.0f;
  for (int i = 0; i < sampleCount(); ++i) {
    vec4 each = sampleAt(i);
    vec2 at = turnedBy(shaded.turn, each.x, each.y);
    float across = at.x * shaded.normal.x + at.y * shaded.normal.y;
    vec2 pipe = aboveTangent(shaded.normal, tangentDepth(shaded.normal, at.x, at.y), -each.z, each.z);
    OuterParts outer = outerParts(at, pipe.x, pipe.y);
    open += diskIntegral(across, shaded.normal.z, outer.front) + diskIntegral(across, shaded.normal.z, outer.back);
    whole += diskIntegral(across, shaded.normal.z, pipe);
  }
  float divisor = normalisedBySamples() ? whole : float(sampleCount());
  return divisor > 0.0f ? clamp(open / divisor, 0.0f, 1.0f) : 1.0f;
}
