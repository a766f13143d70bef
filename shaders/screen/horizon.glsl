// What the estimators that march over the picture have in common.

const float kTurn = 6.283185307f;
const float kQuarterTurn = 1.570796327f;

// Radii: nearer points are the shaded point itself, and rounding decides where they lie.
const float kSmallestDistance = 1e-4f;

// Direction i of `count` in the plane across the view, spread over `circle` (a turn, or half of one).
vec2 marchDirection(vec2 turn, int i, int count, float circle) {
  float angle = circle * float(i) / float(count);
  return turnedBy(turn, cos(angle), sin(angle));
}

// How far step j of `count` reaches: evenly, the last one at most to the end.
float marchReach(float jitter, int j, int count) { return (float(j) + 1.0f - jitter) / float(count); }

// A plane through the line of sight: the angle of the normal in it, from the direction to the eye towards the plane's
// direction, and the length of the normal's part in it.
struct Slice {
  vec2 along;
  float normal;
  float weight;
};

Slice sliceAlong(vec3 normal, vec2 along) {
  float across = dot(vec2(normal), along);
  float towards = max(-normal.z, 0.0f);
  return Slice(along, atan(across, towards), sqrt(across * across + towards * towards));
}

// What step j of `count` on one side (+1 or -1) of a slice sees. Steps grow as squares: they are closest where horizons
// change most.
vec3 sliceStep(Shaded shaded, Slice slice, float side, int j, int count) {
  float even = marchReach(shaded.jitter, j, count);
  float reach = side * even * even;
  return seenPoint(vec3(reach * slice.along.x, reach * slice.along.y, 0.0f));
}

// Whether it counts as an occluder: neither the shaded point itself, nor beyond the radius.
bool occludes(vec3 seen) {
  float distance = length(seen);
  return distance > kSmallestDistance && distance < 1.0f;
}

// integral over [0, h], or [h, 0], of cos(theta - normal) |sin theta|: what a slice receives from the angles between the
// direction to the eye and h ([Jimenez16] Eq. 7).
float sliceLight(float normal, float h) {
  return 0.25f * (cos(normal) - cos(2.0f * h - normal) + 2.0f * h * sin(normal));
}

// All that a slice receives in the open.
float openSliceLight(float normal) { return cos(normal) + normal * sin(normal); }

// Angle of p from the direction to the eye, >= 0.
float angleFromEye(vec3 p) { return acos(clamp(-p.z / max(length(p), kSmallestDistance), -1.0f, 1.0f)); }
