#include "srgb.h"

#include <algorithm>
#include <cmath>

namespace isolume {
namespace {

// IEC 61966-2-1, with the names of its terms.
constexpr float kSlope = 12.92f;
constexpr float kScale = 1.055f;
constexpr float kOffset = 0.055f;
constexpr float kExponent = 2.4f;
constexpr float kLinearEnd = 0.0031308f;
constexpr float kEncodedEnd = 0.04045f;

float clampToUnit(float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; }  // NaN > 0 is false

}  // namespace

float srgbFromLinear(float linear) {
  const float x = clampToUnit(linear);
  return x <= kLinearEnd ? kSlope * x : kScale * std::pow(x, 1 / kExponent) - kOffset;
}

float linearFromSrgb(float encoded) {
  const float x = clampToUnit(encoded);
  return x <= kEncodedEnd ? x / kSlope : std::pow((x + kOffset) / kScale, kExponent);
}

}  // namespace isolume
