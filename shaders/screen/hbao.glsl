// Horizon-based ambient occlusion ([Bavoil08]): O = 1 - (1 / 2 pi) sum over directions of W (sin h - sin t), the solid
// angle between the tangent plane (elevation t) and the horizon h, both from the plane across the view. Each sample that
// raises the horizon adds its own part, times W = 1 - r of its distance. There is no cosine of the normal: O approximates
// the mean over all directions of min(D, 1).

// Of the sine of an elevation: what rounding may raise a point of the tangent plane by.
const float kHorizonTolerance = 1e-3f;

float hbaoOpenness(Shaded shaded) {
  ivec2 counts = marchCounts();
  float occluded = 0.0f;
  for (int i = 0; i < counts.x; ++i) {
    vec2 along = marchDirection(shaded.turn, i, counts.x, kTurn);
    float rise = -tangentDepth(shaded.normal, along.x, along.y);
    float horizon = rise * inversesqrt(1.0f + rise * rise);
    for (int j = 0; j < counts.y; ++j) {
      float reach = marchReach(shaded.jitter, j, counts.y);
      vec3 seen = seenPoint(vec3(reach * along.x, reach * along.y, 0.0f));
      float distance = length(seen);
      float elevation = -seen.z / max(distance, kSmallestDistance);
      if (distance > kSmallestDistance && distance < 1.0f && elevation > horizon + kHorizonTolerance) {
        occluded += (1.0f - distance) * (elevation - horizon);
        horizon = elevation;
      }
    }
  }
  return clamp(1.0f - occluded / float(counts.x), 0.0f, 1.0f);
}
