// Parallel rays through a lattice one ray and one point at a time: what the rays of sweep/ordinates, 256 at a time and
// by shifts, must equal bit for bit.
#pragma once

#include <cstdint>
#include <vector>

#include "sweep/ordinates/carried_rays.h"
#include "sweep/ordinates/ray_points.h"
#include "sweep/ordinates/sheared_rays.h"
#include "sweep/ordinates/solid_lattice.h"

namespace isolume::test {

/// What sweepRays() adds to zeros, for the points as sorted for `axis`: [c * points.count() + i]. Reads lattice.alongX
/// alone, and neither stride nor sums of the tally; `spacing` of the samples.
std::vector<std::int32_t> plainRays(const SolidLattice& lattice, glm::dvec3 spacing, int axis, int towards,
                                    const std::vector<RayDirection>& directions, const RayPoints& points,
                                    const RayTally& tally);

/// The same for sweepCarriedRays(). `met` has a value for every point of the lattice: what is met there, or nothing
/// (nearest: a point that is not solid has kNothingMet; length: solid shares).
inline constexpr std::uint8_t kNothingMet = 255;
std::vector<std::int32_t> plainCarried(const SolidLattice& lattice, glm::dvec3 spacing, int axis, int towards,
                                       const std::vector<RayDirection>& directions, const RayPoints& points,
                                       GridView<const std::uint8_t> met, const CarriedTally& tally);

}  // namespace isolume::test
