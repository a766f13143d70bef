// Environment importance sampling: directions drawn by the luminance of the sky times the cosine, each looked along as
// far as the neighbourhood reaches; the baseline of [Klehm11] Sec. 5.
//
// Cells of the sky (raymarch/screen/sky_draws.h) are drawn by W = power * (cosine at the centre + reach of a cell), one
// sample at every total / n of their running sum, so that samples are stratified over the sky. Within a cell directions
// come by luminance, so a sample of radiance L = luminance * colour has the density luminance * W / (power * total):
//   E / pi = total / (pi n) * sum of V colour (N . w) power / W.
// Normalised by the samples, what they make of the open sky's luminance is replaced by L_p's.
// The includer provides
//   vec4 skyTexel(int cell, int i)  the table of sky_draws.h
//   vec3 openLight(vec3 normal)     L_p, axes of the grid
//   vec3 frameDirection(vec3 v)     from the axes of the grid to the frame of the shaded point

// Sine of the angle from the centre of a cell to its farthest corner, 17 degrees, rounded up.
const float kCellReach = 0.3f;

const float kGoldenShare = 0.618033989f;
const float kOverPi = 0.318309886f;

float luminanceOf(vec3 color) { return 0.2126f * color.x + 0.7152f * color.y + 0.0722f * color.z; }

float cellFacing(vec3 normal, vec4 cell) {
  return max(normal.x * cell.x + normal.y * cell.y + normal.z * cell.z + kCellReach, 0.0f);
}

// Light, and its share of what would arrive in the open.
vec4 importanceLight(Shaded shaded) {
  vec3 normal = gridDirection(shaded.normal);
  float total = 0.0f;
  for (int cell = 0; cell < kSkyCells; ++cell) total += skyTexel(cell, 0).w * cellFacing(normal, skyTexel(cell, 0));
  int count = marchCounts().x;
  float apart = total / float(count);
  int cell = -1;
  float facing = 0.0f;
  float reached = 0.0f;
  vec3 open = vec3(0.0f);
  float visible = 0.0f;
  float whole = 0.0f;
  // Every pixel takes its samples together with its neighbours, though from other cells: what is costly does not diverge.
  for (int i = 0; i < count; ++i) {
    while (reached <= (float(i) + shaded.jitter) * apart && cell < kSkyCells - 1) {
      ++cell;
      facing = cellFacing(normal, skyTexel(cell, 0));
      reached += skyTexel(cell, 0).w * facing;
    }
    int pick = int(fract(shaded.jitter + kGoldenShare * float(i)) * float(kCellDraws));
    vec4 direction = skyTexel(cell, 1 + 2 * pick);
    vec4 color = skyTexel(cell, 2 + 2 * pick);
    vec3 towards = vec3(direction.x, direction.y, direction.z);
    float share = facing > 0.0f ? max(dot(normal, towards), 0.0f) / facing : 0.0f;
    float seen = share > 0.0f ? share * openTo(frameDirection(towards)) : 0.0f;
    open += seen * vec3(color.x, color.y, color.z);
    visible += seen;
    whole += share;
  }
  if (whole <= 0.0f) return vec4(0.0f, 0.0f, 0.0f, 1.0f);
  float scale = normalisedBySamples() ? luminanceOf(openLight(normal)) / whole : apart * kOverPi;
  return vec4(scale * open, visible / whole);
}
