// Feet of the samples of a row, and values that are interpolated there, in SIMD lanes (surface_feet.h says what they
// are). The same bits for any SIMD width. Thread-safe for different output.
#pragma once

#include <cstdint>
#include <vector>

#include "sweep/bit_grid.h"

namespace isolume {

class SurfaceField;
struct SurfaceFoot;

/// What the samples of a row know of the surface. Borrowed.
struct FootFields {
  GridView<const float> level;     ///< finite
  GridView<const float> distance;  ///< world units
};

/// The foot of each sample (x[i], y, z): sample - D N, at most a cell's diagonal away, within the grid.
void footRow(const FootFields& fields, int y, int z, const std::vector<std::int32_t>& x,
             std::vector<SurfaceFoot>& feet);

/// For each sample (x[i], y, z) what the field holds at the corners of its foot's cell that are `given`, by trilinear
/// weights; each counts at least a little. Where no corner is given: kNoValue. At least two samples along each axis.
inline constexpr std::int32_t kNoValue = -1;
void interpolatedRow(const FootFields& fields, int y, int z, const std::vector<std::int32_t>& x, const BitGrid& given,
                     const SurfaceField& field, std::vector<std::int32_t>& interpolated);

}  // namespace isolume
