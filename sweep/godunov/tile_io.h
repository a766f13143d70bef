// Between grids and the skewed buffers of sweep_tile.h: loads and stores one tile for any octant. All mirroring happens
// here, in the signs of the strides, so that the sweep itself knows one direction only.
#pragma once

#include <cstddef>

#include "sweep/grid.h"
#include "sweep/octants.h"
#include "sweep_tile.h"

namespace isolume {

/// A grid walked in the order of one octant: canonical (x, y, z) from the octant's start corner.
struct OctantWalk {
  glm::ivec3 size{0};
  std::ptrdiff_t start = 0;  ///< index of canonical (0, 0, 0)
  std::ptrdiff_t strideX = 1, strideY = 0, strideZ = 0;
  std::ptrdiff_t row(int y, int z) const { return start + y * strideY + z * strideZ; }
};
OctantWalk walkOctant(glm::ivec3 size, const Octant& octant);

/// Where a tile lies: its first canonical row and plane; below 0 where the first lanes or planes are empty.
struct TileOrigin {
  int y = 0, z = 0;
};

/// Fills a span of a tile's buffer, and the steps around it; what is not in the grid is outside, what is not in the
/// span outside or as in the grid.
void loadTile(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* grid, float* buffer);
/// The same for what the tile upwind in z hands over (TileBuffers::carried), from the grid.
void loadCarried(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* grid, float* carried);
/// And for the row upwind in y (TileBuffers::row).
void loadRowBelow(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* grid, float* rows);

/// Writes a span back; rows and planes beyond the grid are not stored.
void storeTile(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* buffer, float* grid);

}  // namespace isolume
