// The transfer function of sRGB (IEC 61966-2-1), exact and piecewise: a straight line near black, a power above.
//
//   encode(x) = 12.92 x                       for x <= 0.0031308
//               1.055 x^(1/2.4) - 0.055       above
//
// Inputs are clamped to [0, 1] and NaN counts as 0, so that every result can be stored. Monotonic; decode(encode(x)) =
// x within 1e-6. Thread-safe.
#pragma once

namespace isolume {

float srgbFromLinear(float linear);
float linearFromSrgb(float encoded);

}  // namespace isolume
