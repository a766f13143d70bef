// The sweep as plain loops, one voxel at a time and in the paper's order: what the vectorised sweep must equal bit for
// bit. Written from [Singh10] Sec. 1.1, Eq. 6 to 8, without any of the library's layout.
#pragma once

#include <array>
#include <vector>

#include "sweep/grid.h"
#include "sweep/octants.h"
#include "sweep/surface_start.h"

namespace isolume::test {

struct PlainFields {
  std::vector<float> distance;                              ///< world units, as SweptFields
  std::array<std::vector<float>, kOctantCount> visibility;  ///< V_s
};

/// Distance of a voxel from its three upwind neighbours (unsigned), in the units of the spacing.
float plainUpdate(glm::vec3 neighbours, glm::dvec3 spacing);

PlainFields plainSweep(GridView<const float> level, int rounds = 1, DistanceStart start = DistanceStart::better,
                       float opacity = 1);

/// What leaves a voxel at that distance, in smallest spacings: [Singh10] Eq. 7; of a translucent solid Eq. 8, as the
/// ramp min(max(alpha D + (1 - alpha / 2), 1 - alpha), 1) that it is.
float plainTransmittance(float distance, float opacity = 1);

}  // namespace isolume::test
