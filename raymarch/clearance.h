// What the ray marcher steps by: for every cell of the grid, whether the surface may pass it, and how large a ball
// about its centre is free of surface.
//
// A cell lies between eight samples (so there are size - 1 along each axis). The trilinear interpolant cannot change
// sign where its eight corners agree, so "mixed" is exact, from the level. The ball comes from the swept distance,
// which is not a lower bound: first-order upwinding overestimates (by up to 1.6 spacings over 250, and 2 % beyond
// that). So
//   radius = kTrusted * mean of the corners' |distance| - kMargin * largest spacing,
// which leaves room for 1.5 spacings and a tenth of the distance. In units of the smallest spacing, rounded down to
// kClearanceUnit and limited to what 7 bits hold; see shaders/shared/clearance_code.h. A cell that touches the border
// and is not mixed has no special code: the marcher knows the box. O(n), threaded; bitwise the same for any thread
// count.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sweep/grid.h"

namespace isolume {

/// One byte per cell, x fastest. Not-a-number distances count as 0.
std::vector<std::uint8_t> buildClearance(GridView<const float> level, GridView<const float> distance);

/// Distances in units of the smallest spacing as half floats.
std::vector<std::uint16_t> packDistance(GridView<const float> distance);

}  // namespace isolume
