// Volumetric obscurance by areas: lines as in line.glsl, but instead of one depth each knows mean and deviation of the
// depths of its Voronoi region, taken for evenly spread: what is visible falls from 1 to 0 between mean - deviation and
// mean + deviation ([Loos10] Sec. 4.2; its coefficients a, b give that function with the sign turned).
// On a plane across the view it gives what lines give; on a tilted one less, by a quarter of the deviation per line.

// Radii: a plane across the view has none, and the slope of visibility shall stay finite.
const float kLeastDeviation = 1e-4f;

// integral of visibility over [near, far].
float visibleLength(DepthSpread spread, float near, float far) {
  float deviation = max(spread.deviation, kLeastDeviation);
  float low = clamp(spread.mean - deviation, near, far);
  float high = clamp(spread.mean + deviation, near, far);
  float visibleInside = (spread.mean + deviation - 0.5f * (low + high)) / (2.0f * deviation);
  return low - near + visibleInside * (high - low);
}

float areaOpenness(Shaded shaded, float scale) {
  float open = 0.0f;
  float whole = 0.0f;
  for (int i = 0; i < sampleCount(); ++i) {
    vec4 each = sampleAt(i);
    vec2 at = scale * turnedBy(shaded.turn, each.x, each.y);
    vec2 line = ballLine(shaded, at, scale * each.z);
    DepthSpread front = depthSpread(at, scale * scale / float(sampleCount()));
    // Behind the thickness it is open again: 1 - visibility, moved back ([Loos10] Sec. 4.3).
    DepthSpread back = DepthSpread(front.mean + seenThickness(), front.deviation);
    float visible = visibleLength(front, line.x, line.y);
    open += each.w * (visible + line.y - line.x - visibleLength(back, line.x, line.y));
    whole += each.w * (line.y - line.x);
  }
  return shareOfBall(open, whole, scale);
}
