// The sweep of distances as plain loops, one voxel at a time and in the paper's order: what the vectorised sweep must
// equal bit for bit. Written from [Singh10] Sec. 1.1, without any of the library's layout.
#pragma once

#include <vector>

#include "sweep/godunov/surface_start.h"
#include "sweep/grid.h"
#include "sweep/octants.h"

namespace isolume::test {

/// Distance of a voxel from its three upwind neighbours (unsigned), in the units of the spacing.
float plainUpdate(glm::vec3 neighbours, glm::dvec3 spacing);

/// World units, as SweptFields.
std::vector<float> plainSweep(GridView<const float> level, int rounds = 1, DistanceStart start = DistanceStart::better);

}  // namespace isolume::test
