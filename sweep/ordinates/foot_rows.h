// Feet of the samples of a row, and values that are interpolated there, in SIMD lanes (surface_feet.h says what they
// are). The same bits for any SIMD width. Thread-safe for different output.
#pragma once

#include <cstdint>
#include <vector>

#include "ranked_bits.h"

namespace isolume {

struct SurfaceFoot;

/// What the samples of a row know of the surface. Borrowed.
struct FootFields {
  GridView<const float> level;     ///< finite
  GridView<const float> distance;  ///< world units
};

/// Adds the foot of each sample (x[i], y, z) to `feet`: sample - D N, at most a cell's diagonal away, within the grid.
void addFeet(const FootFields& fields, int y, int z, const std::vector<std::int32_t>& x,
             std::vector<SurfaceFoot>& feet);

/// Values of samples that have a foot, by its number. Borrowed.
struct FootValues {
  const RankedBits& feet;
  const BitGrid& given;         ///< those of them whose value is known
  const std::uint16_t* values;  ///< one after the last is read, and never counts
};

/// For each sample (x[i], y, z) what the corners of its foot's cell that are `given` hold, by trilinear weights; each
/// counts at least a little. Where no corner is given: kNoValue. At least two samples along each axis.
inline constexpr std::int32_t kNoValue = -1;
void interpolatedRow(const FootFields& fields, int y, int z, const std::vector<std::int32_t>& x, const FootValues& from,
                     std::vector<std::int32_t>& interpolated);

}  // namespace isolume
