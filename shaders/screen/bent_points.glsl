// Bent normals by samples. They hold a direction of the hemisphere in the axes of the tangent plane (z along the normal),
// evenly spread, and a distance: together they fill the half ball evenly.
//
// crytek-3d: whether the point and steps on the way to it are outside (march_to.glsl; [Klehm11] Sec. 4).
//
// The mean of all of a set's directions stands for N / 2, so that nothing bends in the open however few they are.

// crytek-2d: a point of the disk in the tangent plane stands for the direction above it; what its pixel shows closes that
// one if it rises above the plane, and is not farther in front of it than the thickness ([Klehm11] Eq. 3, d_xn). The
// paper's sum takes the directions to the seen points themselves, whose mean on a plane is 0: here those of the hemisphere
// above the points of the disk.
const float kLeastRise = 0.01f;  // sine of the angle to the plane, half a degree: what normals are not sure of

float diskOpen(vec3 normal, Axes axes, vec3 direction) {
  vec3 at = alongAxes(axes, vec3(direction.x, direction.y, 0.0f));
  vec3 seen = seenPoint(at);
  bool before = seen.z < at.z && seen.z > at.z - seenThickness();
  return before && dot(seen, normal) > kLeastRise * length(seen) ? 0.0f : 1.0f;
}

// By points of the half ball, or of the disk.
Bent pointsBent(Shaded shaded, bool ball) {
  Axes axes = axesAbout(shaded.normal);
  vec3 open = vec3(0.0f);
  vec3 whole = vec3(0.0f);
  float count = 0.0f;
  for (int i = 0; i < sampleCount(); ++i) {
    vec4 each = sampleAt(i);
    vec3 direction = vec3(turnedBy(shaded.turn, each.x, each.y), each.z);
    float visible = ball ? openTo(each.w * alongAxes(axes, direction)) : diskOpen(shaded.normal, axes, direction);
    open += visible * direction;
    whole += direction;
    count += visible;
  }
  float share = count / float(sampleCount());
  return Bent(alongAxes(axes, open - share * whole) / float(sampleCount()), share);
}

Bent ballBent(Shaded shaded) { return pointsBent(shaded, true); }
Bent diskBent(Shaded shaded) { return pointsBent(shaded, false); }
