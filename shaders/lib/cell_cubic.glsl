// A trilinear cell along a ray is a cubic polynomial: its coefficients, its first rise above 0, and the root there.
// [Parker98] solves the same cubic in closed form; splitting at the extrema and bracketing keeps full float precision.

struct Cubic {  // a + b t + c t^2 + d t^3
  float a;
  float b;
  float c;
  float d;
};

float cubicAt(Cubic g, float t) { return ((g.d * t + g.c) * t + g.b) * t + g.a; }
float cubicSlope(Cubic g, float t) { return (3.0f * g.d * t + 2.0f * g.c) * t + g.b; }

// `low` and `high` hold the corners at z = 0 and z = 1, x fastest; the ray is u + t * direction in cell coordinates
// ([0, 1]^3). Linear along x, then quadratic along y, then cubic along z: exact, and without the cancellation that
// expanding the eight monomials would bring.
Cubic cellCubic(vec4 low, vec4 high, vec3 u, vec3 direction) {
  float a00 = low.x + (low.y - low.x) * u.x;
  float a10 = low.z + (low.w - low.z) * u.x;
  float a01 = high.x + (high.y - high.x) * u.x;
  float a11 = high.z + (high.w - high.z) * u.x;
  float b00 = (low.y - low.x) * direction.x;
  float b10 = (low.w - low.z) * direction.x;
  float b01 = (high.y - high.x) * direction.x;
  float b11 = (high.w - high.z) * direction.x;

  vec3 q0 = vec3(a00 + (a10 - a00) * u.y, b00 + (b10 - b00) * u.y + (a10 - a00) * direction.y, (b10 - b00) * direction.y);
  vec3 q1 = vec3(a01 + (a11 - a01) * u.y, b01 + (b11 - b01) * u.y + (a11 - a01) * direction.y, (b11 - b01) * direction.y);
  vec3 s = q1 - q0;
  return Cubic(q0.x + s.x * u.z, q0.y + s.y * u.z + s.x * direction.z, q0.z + s.z * u.z + s.y * direction.z,
               s.z * direction.z);
}

// False only where the cubic is certain not to rise above 0 in [0, len]: its Bernstein coefficients there, between
// whose smallest and largest it stays, are at most 0.
bool mayRise(Cubic g, float len) {
  const float kThird = 1.0f / 3.0f;
  float b = kThird * g.b * len;
  float c = kThird * g.c * len * len;
  float b1 = g.a + b;
  float b2 = b1 + b + c;
  return g.a > 0.0f || b1 > 0.0f || b2 > 0.0f || cubicAt(g, len) > 0.0f;
}

struct Bracket {  // g <= 0 at low (unless low = high), g > 0 at high, monotone between
  bool found;
  float low;
  float high;
};

// The first rise above 0 in [0, len]. Already above 0 at 0: found, with low = high = 0 (a ray that comes from outside
// enters the solid at the face of the cell: rounding on the other side hid the root there).
Bracket firstRise(Cubic g, float len) {
  if (g.a > 0.0f) return Bracket(true, 0.0f, 0.0f);
  float first = 0.0f;
  float second = 0.0f;
  float discriminant = g.c * g.c - 3.0f * g.d * g.b;
  if (discriminant > 0.0f) {
    // Citardauq's form where the plain one cancels; a vanishing cubic term sends one extremum to infinity, clamped.
    float q = -(g.c + (g.c < 0.0f ? -sqrt(discriminant) : sqrt(discriminant)));
    float t0 = g.d == 0.0f ? len : q / (3.0f * g.d);
    float t1 = g.b / q;
    first = clamp(min(t0, t1), 0.0f, len);
    second = clamp(max(t0, t1), 0.0f, len);
  }
  if (cubicAt(g, first) > 0.0f) return Bracket(true, 0.0f, first);
  if (cubicAt(g, second) > 0.0f) return Bracket(true, first, second);
  return Bracket(cubicAt(g, len) > 0.0f, second, len);
}

// At most this many halvings shrink any cell (length <= sqrt(3) times its longest side) below the tolerance.
const int kRefineIterations = 32;
// In units of the smallest spacing; a hundredth of the required 1e-3 voxel.
const float kRefineTolerance = 1e-5f;
// A Newton step as short as this leaves far less than the tolerance behind it.
const float kLastNewtonStep = 1e-4f;

// The root in a bracket, by Newton steps that fall back to halving when they leave it or do not shrink fast enough.
float refineRise(Cubic g, Bracket bracket) {
  float low = bracket.low;
  float high = bracket.high;
  // The secant is close where the bracket is short; nothing to divide by (low = high) gives the middle.
  float atLow = cubicAt(g, low);
  float secant = low - atLow * (high - low) / (cubicAt(g, high) - atLow);
  float t = secant > low && secant < high ? secant : 0.5f * (low + high);
  float stepBefore = high - low;
  for (int i = 0; i < kRefineIterations && high - low > kRefineTolerance; ++i) {
    float value = cubicAt(g, t);
    float slope = cubicSlope(g, t);
    if (value > 0.0f) {
      high = t;
    } else {
      low = t;
    }
    float newton = t - value / (slope == 0.0f ? 1.0f : slope);
    bool useNewton = newton >= low && newton <= high && abs(2.0f * value) < abs(stepBefore * slope);
    float next = useNewton ? newton : 0.5f * (low + high);
    stepBefore = next - t;
    t = next;
    if (abs(stepBefore) < (useNewton ? kLastNewtonStep : kRefineTolerance)) break;
  }
  return t;
}
