// Directional occlusion ([Ritschel09] Eq. 1): the sum over points of points.glsl of the radiance from beyond each that is
// open, L = sum_i w_i V_i L_i, and openness, the sum without L_i. The includer provides
//   vec3 skyRadiance(vec3 direction)  from a direction of any length, axes of the grid
vec4 ssdoLight(Shaded shaded) {
  Axes axes = axesAbout(shaded.normal);
  vec4 sum = vec4(0.0f);
  for (int i = 0; i < sampleCount(); ++i) {
    vec4 each = sampleAt(i);
    vec2 turned = turnedBy(shaded.turn, each.x, each.y);
    vec3 p = alongAxes(axes, vec3(turned.x, turned.y, each.z));
    if (outside(p) > 0.0f) sum += each.w * vec4(skyRadiance(gridDirection(p)), 1.0f);
  }
  return vec4(sum.x, sum.y, sum.z, clamp(sum.w, 0.0f, 1.0f));
}
