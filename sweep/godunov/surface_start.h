// Start of the distance sweep: samples next to the surface get their distance, all others are unset ([Singh10]
// Sec. 1.1, Fig. 1). Also how a value says that it is fixed.
//
// Start and sweep share one float per voxel, in units of the smallest spacing: the sign bit says inside, the lowest bit
// of the mantissa says fixed. The tag costs one unit in the last place (6e-8 of the value) and no memory.
#pragma once

#include <bit>
#include <cstdint>

#include "sweep/grid.h"

namespace isolume {

/// Magnitude of a value that no sweep has reached. Its square fits into a float, adding a spacing does not change it,
/// and a power of two has the fixed bit clear.
inline constexpr float kUnsetDistance = 0x1p60F;
/// Smallest magnitude of a start value: keeps the sign of a sample on the surface, and denormals out of the sweep.
inline constexpr float kSmallestDistance = 1e-30F;
inline constexpr std::uint32_t kFixedBit = 1;

inline float withFixedBit(float value, bool fixed) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return std::bit_cast<float>(fixed ? bits | kFixedBit : bits & ~kFixedBit);
}
inline bool isFixed(float value) { return (std::bit_cast<std::uint32_t>(value) & kFixedBit) != 0; }

/// How a sample next to the surface gets its distance.
enum class DistanceStart {
  paper,   ///< along the nearest crossed grid edge ([Singh10] Sec. 1.1): up to .39 voxels too long
  better,  ///< to the interpolant's surface itself, where the cell allows it (better_start.h): .002 voxels off on
           ///< average
};

/// Start values of the row (y, z). A sample whose six neighbours are on its own side is unset: +-`unset` with the sign
/// of its side. Otherwise the value is fixed: |value| is the smallest distance to a crossing of the linear interpolant
/// along the crossed edges or, with `better`, a smaller one, and never above `unset`. A sample inside the solid on the
/// border of the grid lies on the cap: 0. Returns whether any may be fixed. `unset` is even: its fixed bit is clear.
bool startRow(GridView<const float> level, DistanceStart start, float unset, int y, int z, float* row);

/// startRow() for all rows of `distance` (same size as `level`). O(n), threaded.
void startDistance(GridView<const float> level, GridView<float> distance, DistanceStart start);

}  // namespace isolume
