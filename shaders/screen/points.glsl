// Weighed points around the shaded point: O = sum_i w_i I(p_i). The samples hold p_i in the axes of the tangent plane (z
// along the normal) and w_i, all worked out beforehand (raymarch/screen/point_samples.h): [Szirmay10] Eq. 5,
// [SzirmayGpu] Sec. 4.1 to 4.4, the points of [Mittring07], and those of [Loos10]. `scale` is the radius of the ball in
// radii.
float pointsOpenness(Shaded shaded, float scale) {
  Axes axes = axesAbout(shaded.normal);
  float sum = 0.0f;
  for (int i = 0; i < sampleCount(); ++i) {
    vec4 each = sampleAt(i);
    vec2 turned = turnedBy(shaded.turn, each.x, each.y);
    sum += each.w * outside(scale * alongAxes(axes, vec3(turned.x, turned.y, each.z)));
  }
  return clamp(sum, 0.0f, 1.0f);
}
