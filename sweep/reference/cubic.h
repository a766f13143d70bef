// A cubic polynomial over [0, 1] in Bernstein form: where it first rises above 0, and how long it is above.
//
//   f(s) = b0 (1-s)^3 + 3 b1 (1-s)^2 s + 3 b2 (1-s) s^2 + b3 s^3
//
// f lies between the smallest and the largest coefficient, so no coefficient above 0 means no point above 0. The zeros
// of f' cut [0, 1] into at most three monotone pieces; the first piece that ends above 0 holds the rise, bracketed from
// the start, so nothing is missed and no tolerance is needed. An extremum enters f in second order only: a touch
// (double root) is told from a crossing to the rounding of f itself, about 4 ulp of the largest coefficient.
#pragma once

#include <optional>

namespace isolume {

struct Cubic {
  double b0 = 0, b1 = 0, b2 = 0, b3 = 0;

  double operator()(double s) const {
    const double r = 1 - s;
    return (b0 * r + 3 * b1 * s) * (r * r) + (3 * b2 * r + b3 * s) * (s * s);
  }
  /// f'(s).
  double slope(double s) const {
    const double r = 1 - s;
    return 3 * ((b1 - b0) * r * r + 2 * (b2 - b1) * r * s + (b3 - b2) * s * s);
  }
  /// No coefficient above 0, and so no point.
  bool isNowherePositive() const { return b0 <= 0 && b1 <= 0 && b2 <= 0 && b3 <= 0; }
  bool isNowhereNegative() const { return b0 >= 0 && b1 >= 0 && b2 >= 0 && b3 >= 0; }
  Cubic operator-() const { return {-b0, -b1, -b2, -b3}; }
  Cubic operator-(double level) const { return {b0 - level, b1 - level, b2 - level, b3 - level}; }
};

/// Smallest s in [0, 1] beyond which f is above 0, to the rounding of f: 0 if b0 > 0, nothing if f <= 0 throughout
/// (f(1) counts: a rise that ends the range is one). Coefficients finite.
std::optional<double> firstRise(const Cubic& f);

/// Whether firstRise(f) has a value, for less work.
bool rises(const Cubic& f);

/// How much of [0, 1] has f > 0: 0 to 1. A touch changes it by its width, the square root of the rounding of f, at
/// most.
double positiveShare(const Cubic& f);

}  // namespace isolume
