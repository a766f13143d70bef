// What the ray marcher steps by: for every cell of the grid, whether the surface may pass it, and how large a cube of
// cells about it is free of surface.
//
// A cell lies between eight samples (so there are size - 1 along each axis). The trilinear interpolant cannot change
// sign where its eight corners agree, so "mixed" is exact, from the level. The cube comes from the chessboard distance
// of cells (the largest of the three index differences) to the nearest mixed cell: exact as well, at any spacing, where
// the swept distance overestimates by up to 1.6 voxels and would need a margin. Coded in a byte:
// shaders/shared/clearance_code.h. A cell that touches the border and is not mixed has no special code: the marcher
// knows the box.
//
// Three separable passes: along x by differences; then along y and z by d(i) = min(d(i), 1 + min over the neighbours
// across of d(i -+ 1)), which is exact because a chessboard distance changes by at most 1 from cell to cell. O(n),
// threaded; bitwise the same for any thread count.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sweep/grid.h"

namespace isolume {

/// One byte per cell, x fastest.
std::vector<std::uint8_t> buildClearance(GridView<const float> level);

}  // namespace isolume
