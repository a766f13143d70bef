// Between grids and the skewed buffers of sweep_tile.h: loads and stores one tile for any octant. All mirroring happens
// here, in the signs of the strides, so that the sweep itself knows one direction only.
#pragma once

#include <cstddef>
#include <cstdint>

#include "grid.h"
#include "octants.h"

namespace isolume {

/// A grid walked in the order of one octant: canonical (x, y, z) from the octant's start corner.
struct OctantWalk {
  glm::ivec3 size{0};
  std::ptrdiff_t start = 0;  ///< index of canonical (0, 0, 0)
  std::ptrdiff_t strideX = 1, strideY = 0, strideZ = 0;
  std::ptrdiff_t row(int y, int z) const { return start + y * strideY + z * strideZ; }
};
OctantWalk walkOctant(glm::ivec3 size, const Octant& octant);

/// Where a tile lies: its first canonical row and plane.
struct TileOrigin {
  int y = 0, z = 0;
};

/// Rows and planes beyond the grid are loaded as unset and not stored.
void loadTile(const OctantWalk& walk, TileOrigin origin, const float* grid, float* buffer);
void storeTile(const OctantWalk& walk, TileOrigin origin, const float* buffer, float* grid);
/// As bytes: round(255 value), for values in [0, 1].
void storeTile(const OctantWalk& walk, TileOrigin origin, const float* buffer, std::uint8_t* grid);

}  // namespace isolume
