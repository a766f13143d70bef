// Horizon-based ambient occlusion ([Bavoil08]): O = 1 - (1 / 2 pi) sum over directions of W (sin h - sin t), the solid
// angle between the tangent plane (elevation t) and the horizon h, both from the plane across the view. Each sample that
// raises the horizon adds its own part, times W = 1 - r of its distance. There is no cosine of the normal: O approximates
// the mean over all directions of min(D, 1).
//
// What a part closes has its mean direction in closed form, for bent normals ([Klehm11]): in the plane of the direction
// `along` and the view, integral of (cos e along, sin e to the eye) cos e de = ((e + sin e cos e) along / 2,
// sin^2 e / 2).

// Of the sine of an elevation: what rounding may raise a point of the tangent plane by.
const float kHorizonTolerance = 1e-3f;

// That integral from 0 to e, of which the sine is given: along the direction, and towards the eye.
vec2 wedgeBelow(float sine) {
  return vec2(0.5f * (asin(sine) + sine * sqrt(max(1.0f - sine * sine, 0.0f))), 0.5f * sine * sine);
}

// Means over the hemisphere about the normal, weighed by W.
struct Closed {
  vec3 direction;
  float share;
};

Closed hbaoClosed(Shaded shaded) {
  ivec2 counts = marchCounts();
  vec3 direction = vec3(0.0f);
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
        vec2 wedge = (1.0f - distance) * (wedgeBelow(elevation) - wedgeBelow(horizon));
        direction += vec3(wedge.x * along.x, wedge.x * along.y, -wedge.y);
        occluded += (1.0f - distance) * (elevation - horizon);
        horizon = elevation;
      }
    }
  }
  return Closed(direction / float(counts.x), occluded / float(counts.x));
}

float hbaoOpenness(Shaded shaded) { return clamp(1.0f - hbaoClosed(shaded).share, 0.0f, 1.0f); }

// share N_b = N / 2 - what is closed.
Bent hbaoBent(Shaded shaded) {
  Closed closed = hbaoClosed(shaded);
  return Bent(0.5f * closed.share * shaded.normal - closed.direction, clamp(1.0f - closed.share, 0.0f, 1.0f));
}
