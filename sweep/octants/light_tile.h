// The inner loop of the sweep of light alone: [Singh10] Eq. 6 to 8 through given distances, one tile in the skewed
// layout of sweep_tile.h.
#pragma once

#include "sweep/godunov/sweep_tile.h"

namespace isolume {

/// As TileBuffers, but that light V tau is handed on in place of distances, 1 from outside the grid.
struct LightBuffers {
  const float* distance = nullptr;  ///< [plane][step][lane], world units, < 0 inside; +-inf allowed
  float* visibility = nullptr;      ///< [plane][step][lane], out
  float* carriedLight = nullptr;    ///< [step][lane]: plane below the tile, replaced by the tile's last plane
  const float* rowLight = nullptr;  ///< [plane][step]: the row below the tile
  float* lastRowLight = nullptr;    ///< [plane][step]: the tile's own last row; may be rowLight
};

/// Sweeps a tile of rows of nx voxels. The transmittance of a voxel is that of its distance in smallest spacings as the
/// sweep of distances has it at a start value: with the fixed bit set (surface_start.h).
void sweepLightTile(const LightBuffers& buffers, const SweepMetric& metric, float smallestSpacing, int nx);

}  // namespace isolume
