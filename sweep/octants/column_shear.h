// Between rows of 16-bit values and the diagonals of fixed_light.h, without gathers: lane j of a diagonal takes the row
// that lies j (falling: lanes - 1 - j) further back, two binary digits of that shift at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/gtc/type_precision.hpp>

#include "fixed_light.h"

namespace isolume {

/// tau = clamp(slope D / h + middle, least, 1), the same for all D beyond +-h.
struct TransmittanceRamp {
  float slope = 1, middle = 0.5F, least = 0;
};
/// [Singh10] Eq. 7 and 8.
constexpr TransmittanceRamp centredRamp(float opacity) { return {opacity, 1 - opacity / 2, 1 - opacity}; }

/// -tau in units of 2^-15 for `count` distances times `perSmallest` = 1 / h, rounded; to whole vectors, kClear beyond
/// the count.
void transmittanceRow(const float* distance, int count, float perSmallest, const TransmittanceRamp& ramp,
                      std::int16_t* row);

/// What a column's `lanes` values in each of `count` >= 1 rows are.
Content contentOfRows(const std::int16_t* rows, std::ptrdiff_t stride, int count);

/// Steps or rows from `begin` to before `end`.
struct Stretch {
  int begin = 0, end = 0;
};

/// The diagonals of these steps. `rows`: that of y = 0 of a plane, `stride` values apart, `lanes` of each are read,
/// from `lanes` rows before those of y = begin on; diagonals[0] is step 0.
void shearRows(const std::int16_t* rows, std::ptrdiff_t stride, const ColumnShape& shape, bool rising, Stretch steps,
               std::int16_t* scratch, std::int16_t* diagonals);

/// The way back: `lanes` values of each of these rows, from the steps y to y + lanes - 1.
void unshearRows(const std::int16_t* diagonals, const ColumnShape& shape, bool rising, Stretch rows,
                 std::int16_t* scratch, std::int16_t* values, std::ptrdiff_t stride);

/// Values of a scratch of the two.
inline std::size_t shearScratch(const ColumnShape& shape) {
  return 2 * static_cast<std::size_t>(shape.steps() + shape.lanes) * static_cast<std::size_t>(shape.lanes);
}

/// A plane of what all octants of a walk leave, rows `stride` >= nx values apart, rounded up to whole vectors.
struct MergedRows {
  const std::int16_t* rising = nullptr;   ///< octants 0 and 3
  const std::int16_t* falling = nullptr;  ///< 1 and 2
  int nx = 0, ny = 0;
  std::ptrdiff_t stride = 0;
};

/// RGBA of the four (kFirstByte, kSecondByte) in a plane of a grid.
void packBytes(const MergedRows& rows, glm::u8vec4* voxels);

/// 16-bit means from sums of missing light: the first visit stores rising + falling, the last adds to them what is
/// there and stores round(65535 (1 - sum / total)).
void packMeans(const MergedRows& rows, bool last, int total, std::uint16_t* voxels);

}  // namespace isolume
