#include "sweep/reference/cubic.h"

#include <algorithm>
#include <cmath>

namespace isolume {
namespace {

/// Zeros of f' within (0, 1), in order.
struct Extrema {
  double s[2] = {0, 0};
  int count = 0;
};

Extrema extremaOf(const Cubic& f) {
  // f' / 3 = d0 (1-s)^2 + 2 d1 (1-s) s + d2 s^2 = a s^2 + 2 h s + d0.
  const double d0 = f.b1 - f.b0, d1 = f.b2 - f.b1, d2 = f.b3 - f.b2;
  Extrema extrema;
  const double discriminant = d1 * d1 - d0 * d2;
  if (!(discriminant > 0)) return extrema;
  const double a = (d0 - d1) + (d2 - d1), h = d1 - d0;
  // The two roots by the sum that does not cancel; a = 0 sends the first one to infinity.
  const double w = -(h + std::copysign(std::sqrt(discriminant), h));
  double first = w / a, second = d0 / w;
  if (second < first) std::swap(first, second);
  if (first > 0 && first < 1) extrema.s[extrema.count++] = first;
  if (second > 0 && second < 1) extrema.s[extrema.count++] = second;
  return extrema;
}

double slopeAt(const Cubic& f, double s) {
  const double r = 1 - s;
  return 3 * ((f.b1 - f.b0) * (r * r) + 2 * (f.b2 - f.b1) * (r * s) + (f.b3 - f.b2) * (s * s));
}

// The zero of f in [low, high] where f is monotone, f(low) <= 0 < f(high): Newton, kept in the bracket by bisection.
double zeroBetween(const Cubic& f, double low, double atLow, double high, double atHigh) {
  if (atLow == 0) return low;
  double s = low + (high - low) * (atLow / (atLow - atHigh));
  // Halving at least every other step, 53 halvings exhaust a double in [1/2, 1]; Newton from the secant needs 3 to 6.
  constexpr int kMostSteps = 120;
  double lastMove = 1;
  for (int step = 0; step < kMostSteps; ++step) {
    const double value = f(s);
    (value > 0 ? high : low) = s;
    double next = s - value / slopeAt(f, s);
    // Out of the bracket, not a number, or too slow (next to an extremum): halve the bracket.
    if (!(next >= low && next <= high && std::abs(next - s) <= lastMove / 2)) next = low + (high - low) / 2;
    lastMove = std::abs(next - s);
    s = next;
    // One unit in the last place of 1/2: s is a share of a segment that is no longer than a cell.
    constexpr double kResolution = 0x1p-53;
    if (lastMove <= kResolution) break;
  }
  return s;
}

}  // namespace

std::optional<double> firstRise(const Cubic& f) {
  if (f.b0 > 0) return 0;
  if (f.isNowherePositive()) return std::nullopt;
  const Extrema extrema = extremaOf(f);
  double low = 0, atLow = f.b0;
  for (int piece = 0; piece <= extrema.count; ++piece) {
    const bool last = piece == extrema.count;
    const double high = last ? 1 : extrema.s[piece], atHigh = last ? f.b3 : f(high);
    if (atHigh > 0) return zeroBetween(f, low, atLow, high, atHigh);
    low = high;
    atLow = atHigh;
  }
  return std::nullopt;
}

bool rises(const Cubic& f) {
  if (f.b0 > 0 || f.b3 > 0) return true;
  if (f.isNowherePositive()) return false;
  const Extrema extrema = extremaOf(f);
  for (int i = 0; i < extrema.count; ++i)
    if (f(extrema.s[i]) > 0) return true;
  return false;
}

double positiveShare(const Cubic& f) {
  if (f.isNowherePositive()) return 0;
  if (f.isNowhereNegative()) return 1;
  const Extrema extrema = extremaOf(f);
  double share = 0, low = 0, atLow = f.b0;
  for (int piece = 0; piece <= extrema.count; ++piece) {
    const bool last = piece == extrema.count;
    const double high = last ? 1 : extrema.s[piece], atHigh = last ? f.b3 : f(high);
    if (atLow > 0 && atHigh < 0)
      share += zeroBetween(-f, low, -atLow, high, -atHigh) - low;
    else if (atLow <= 0 && atHigh > 0)
      share += high - zeroBetween(f, low, atLow, high, atHigh);
    else if (atLow > 0)
      share += high - low;
    low = high;
    atLow = atHigh;
  }
  return share;
}

}  // namespace isolume
