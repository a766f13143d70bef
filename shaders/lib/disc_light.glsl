// A disc of light on the sky.

const float kPi = 3.14159265359f;

// Mean of max(N . w, 0) over the directions w of a disc of angular radius `radius`, in (0, pi / 2], whose centre makes
// an angle with that cosine with N: above the horizon cosine (1 + cos radius) / 2, below it 0, and across it the closed
// form of [Snyder96].
float discCosine(float cosine, float radius) {
  float sine = sin(radius);
  float solidAngle = 2.0f * kPi * (1.0f - cos(radius));
  if (cosine >= sine) return cosine * kPi * sine * sine / solidAngle;
  if (cosine <= -sine) return 0.0f;
  float across = sqrt(max(1.0f - cosine * cosine, 0.0f));
  float x = cos(radius) / sine;
  float y = clamp(-x * cosine / max(across, 1e-6f), -1.0f, 1.0f);
  float z = across * sqrt(1.0f - y * y);
  float clipped = (cosine * acos(y) - x * z) * sine * sine + atan(z / max(x, 1e-6f));
  return max(clipped, 0.0f) / solidAngle;
}
