// The better start value (sweep/godunov/better_start.h) for one sample at a time: what the vectorised form must equal
// bit for bit.
#pragma once

#include <glm/vec3.hpp>

#include "sweep/grid.h"

namespace isolume::test {

/// Sum of three in sorted order.
float sortedSum(float x, float y, float z);

/// Distance of sample p from the surface, not more than `axisMinimum`; spacing in units of the smallest.
float plainBetterStart(GridView<const float> level, glm::vec3 spacing, glm::ivec3 p, float axisMinimum);

}  // namespace isolume::test
