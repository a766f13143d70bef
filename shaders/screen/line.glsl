// Volumetric obscurance by lines: the share of the unit ball that lies outside, each line standing for the Voronoi region
// of its point of the disk ([Loos10] Sec. 4.1, 4.5). The samples hold that point, half the line's length, and the
// region's share of the ball over the line's length. Clamped to the tangent plane (Sec. 4.4), the ball becomes half a
// ball. Normalised by the samples, the sum is divided by that of the same lines in the open.
// `scale` is the radius of the ball in radii.
float lineOpenness(Shaded shaded, float scale) {
  float open = 0.0f;
  float whole = 0.0f;
  for (int i = 0; i < sampleCount(); ++i) {
    vec4 each = sampleAt(i);
    vec2 at = scale * turnedBy(shaded.turn, each.x, each.y);
    vec2 line = ballLine(shaded, at, scale * each.z);
    open += each.w * outerLength(outerParts(at, line.x, line.y));
    whole += each.w * (line.y - line.x);
  }
  return shareOfBall(open, whole, scale);
}
