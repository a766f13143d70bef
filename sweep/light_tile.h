// The inner loop of the sweep of light alone: [Singh10] Eq. 6 to 8 through given distances, one tile in the skewed
// layout of sweep_tile.h.
#pragma once

#include "sweep_tile.h"

namespace isolume {

/// As TileBuffers, without the hand-over of distances.
struct LightBuffers {
  const float* distance = nullptr;  ///< [plane][step][lane], world units, < 0 inside; +-inf allowed
  float* visibility = nullptr;      ///< [plane][step][lane], out
  float* carriedLight = nullptr;
  const float* rowLight = nullptr;
  float* lastRowLight = nullptr;
};

/// Light below this is dark: keeps the exponential decay of deep shadow out of the slow denormal numbers.
inline constexpr float kDarkest = 1e-20F;

/// Sweeps a tile of rows of nx voxels. The transmittance of a voxel is that which the sweep with distances has at a
/// start value of this magnitude (fixed bit set), so the bits are those of sweeping with every distance fixed.
void sweepLightTile(const LightBuffers& buffers, const SweepMetric& metric, float smallestSpacing, int nx);

}  // namespace isolume
