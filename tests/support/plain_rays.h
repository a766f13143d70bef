// Parallel rays through a lattice of bits one ray and one point at a time: what the rays of sweep/ordinates, 256 at a
// time and by shifts, must equal bit for bit.
#pragma once

#include <cstdint>
#include <vector>

#include "sweep/ordinates/ray_points.h"
#include "sweep/ordinates/sheared_rays.h"
#include "sweep/ordinates/solid_lattice.h"

namespace isolume::test {

/// What sweepRays() adds to zeros, for the points as sorted for `axis`. Reads lattice.alongX alone; `spacing` of the
/// samples.
std::vector<std::int32_t> plainRays(const SolidLattice& lattice, glm::dvec3 spacing, int axis, int towards,
                                    const std::vector<RayDirection>& directions, const RayPoints& points, float scale);

}  // namespace isolume::test
