// The sweep of light as plain loops, one voxel at a time and in the paper's order ([Singh10] Eq. 6 to 8): what the
// vectorised sweeps must equal bit for bit. Written without any of the library's layout.
#pragma once

#include <cstdint>
#include <vector>

#include "sweep/grid.h"

namespace isolume::test {

/// What leaves a voxel at that distance, in smallest spacings: [Singh10] Eq. 7; of a translucent solid Eq. 8, as the
/// ramp min(max(alpha D + (1 - alpha / 2), 1 - alpha), 1) that it is.
float plainTransmittance(float distance, float opacity = 1);

/// V of the octant swept in direction `sign`, in float, through given distances in world units.
std::vector<float> plainLight(GridView<const float> distance, glm::ivec3 sign, float opacity = 1);

/// The same in the 15 bits of sweep/octants/fixed_light.h.
std::vector<std::int16_t> plainFixedLight(GridView<const float> distance, glm::ivec3 sign, float opacity = 1);

}  // namespace isolume::test
