// What the ordinates of a group add to the openness of a point, read from light in 15 bits (light_strip.h).
#pragma once

#include <array>
#include <cstdint>

namespace isolume {

/// Where a point is read, between samples, and its normal. Parts and normals in units of 2^-15.
struct FixedPlace {
  std::array<std::int16_t, 3> low{}, part{}, normal{};
};

/// sum_k R(c_k M_k) and sum_k R(c_k kFullLight), c_k = max(0, N . w_k) and M_k = kFullLight - V_k what is missing.
struct PlaceSum {
  std::int32_t blocked = 0, all = 0;
};

/// `corners`: V by lane at the samples around, 64-byte aligned, bit i of the index set for the further one along axis
/// i. `directions`: [axis][lane] of w in units of 2^-15; 0 in lanes without an ordinate. Exactly 0 where all V are
/// full, exactly all where they are 0, and the same of each ordinate in whatever lane.
PlaceSum readPlace(const std::array<const std::int16_t*, 8>& corners, const FixedPlace& place,
                   const std::int16_t* directions, int lanes);

}  // namespace isolume
