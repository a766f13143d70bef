// Structural similarity [Wang04] Eq. 13 of two pictures that are compared only at some pixels.
//
//   SSIM(p) = (2 mx my + C1) (2 sxy + C2) / ((mx^2 + my^2 + C1) (sx^2 + sy^2 + C2)),  C1 = (.01 L)^2, C2 = (.03 L)^2
// with means, variances and covariance under a Gaussian window around pixel p (11 x 11, sigma 1.5, [Wang04] Sec. III
// C). Windows are normalised over the pixels that are compared: w_q = g(q - p) m_q / sum g m, with mask m = 0 or 1,
// also 0 outside the picture. The result is the mean over the compared pixels whose window holds at least a quarter of
// the Gaussian's weight: the corner of a picture does (.40), so does an upright thread of one pixel (.27); a slanted
// one and single pixels do not. [Wang04] knows no mask and drops windows that stick out of the picture.
//
// 1 for identical pictures, exactly; symmetric in the two. Sums in double and in a fixed order: bitwise the same for
// any number of threads. 2 x 11 steps per pixel: the window is a product of rows and columns. Thread-safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

namespace isolume {

/// `range` is L, the range that the values can take, > 0. None if no window has weight enough.
std::optional<double> structuralSimilarity(glm::ivec2 size, std::span<const float> got, std::span<const float> want,
                                           std::span<const std::uint8_t> compared, double range);

}  // namespace isolume
