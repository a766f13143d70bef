// The passes of the closest-point solver as plain loops, one voxel at a time: what the vectorised, threaded passes must
// equal bit for bit. Also a reference for the distance itself, by points strewn densely over the interpolant's surface.
#pragma once

#include <vector>

#include "sweep/closest/offset_field.h"

namespace isolume::test {

/// Distance in world units after `rounds` rounds on the library's own start (solveBand).
std::vector<float> plainClosestDistance(GridView<const float> level, int bandVoxels, int rounds = 1);

/// Distance from every sample to the nearest of many points of the trilinear surface and the cap: exact crossings of
/// `perAxis` x `perAxis` lines along each axis of each mixed cell. Never below the true distance of the surface. With
/// `zeroCorners` the corners of mixed cells whose level is 0 count too: the zero set holds them, even where the solid
/// does not come near.
std::vector<double> strewnDistance(GridView<const float> level, int perAxis, bool zeroCorners = false);

/// Is `position` (in samples) a point of the trilinear surface, to `tolerance` of the largest level of its cell, or an
/// inside sample on the border of the grid (cap)?
bool liesOnSurface(GridView<const float> level, glm::dvec3 position, double tolerance);

}  // namespace isolume::test
