// The inner loop of a sweep: one tile of kTilePlanes z planes by `lanes` rows by the whole x axis, in SIMD.
//
// Skewed layout. Every tile is swept in the canonical direction (+, +, +); mirroring happens when it is loaded and
// stored. Lane j of the vector at step t holds the voxel x = t - j of row j, so that in-order Gauss-Seidel becomes data
// parallel: the x neighbour is the previous vector, the y neighbour the previous vector shifted by one lane (lane 0
// comes from the row below the tile), the z neighbour the vector of the plane below at the same t. Planes run staggered
// by one step, which hides the latency of the update. Per voxel the operations and their order are those of the plain
// loop, so the result is bitwise the same for any number of lanes.
#pragma once

#include <glm/vec3.hpp>

namespace isolume {

/// The distance of a voxel outside the grid: unset, and fixed so that no sweep changes it.
inline constexpr float kOutsideDistance = 0x1.000002p60F;

/// Planes of a tile that are swept together.
inline constexpr int kTilePlanes = 4;

/// Rows of a tile = lanes of a vector on this machine; the layout of all buffers below follows it.
int tileLanes();

/// What the sweep needs to know of the grid and its solid. Lengths in units of the smallest spacing.
struct SweepMetric {
  glm::vec3 spacing{1};        ///< h_x, h_y, h_z
  glm::vec3 inverseSquare{1};  ///< 1 / h^2
  glm::vec3 weights{0};        ///< of the three neighbours in [Singh10] Eq. 6, sum exactly 1 in float
  float opacity = 1;           ///< alpha of [Singh10] Eq. 8
  bool isotropic = true;
};
SweepMetric makeSweepMetric(glm::dvec3 spacing, float opacity = 1);

/// The part of a tile's rows that is swept, in canonical x. What lies beside it counts as outside or, within a vector's
/// lanes, may be there as in the grid: before the span that must be values that lower nothing; behind it they are
/// upwind of none of its samples, and what becomes of them is not stored.
struct TileSpan {
  int first = 0, count = 0;
};

/// Buffers of one block of rows (all its tiles along z in turn), 64 bytes aligned by the owner. Steps are counted from
/// -frontPad(), in the tile's own `distance` from the start of the span; an entry outside the grid holds
/// kOutsideDistance, one outside the span that or its own value.
struct TileBuffers {
  int rowLength = 0;           ///< of the grid: gives the sizes of all buffers
  float* distance = nullptr;   ///< [plane][step][lane], in and out
  float* carried = nullptr;    ///< [step][lane]: plane below the tile, replaced by the tile's last plane
  const float* row = nullptr;  ///< [plane][step]: the row below the tile
  float* lastRow = nullptr;    ///< [plane][step]: the tile's own last row, for the block above
};

/// Steps before the first that every buffer holds, so that staggered planes need no special case.
inline constexpr int frontPad() { return kTilePlanes; }
/// Steps that a buffer holds in all, for rows of nx voxels: whole blocks of `lanes` steps are loaded.
inline int paddedSteps(int nx, int lanes) { return frontPad() + nx + 2 * lanes + kTilePlanes; }
/// Room of a [step] row buffer before its step 0: the last lane lags behind by lanes - 1 steps.
inline int rowFrontPad(int lanes) { return frontPad() + 2 * lanes; }
inline int paddedRow(int nx, int lanes) { return rowFrontPad(lanes) + nx + lanes + kTilePlanes; }

/// Sweeps the distances of a span of one tile ([Singh10] Sec. 1.1). Returns whether any changed.
bool sweepTile(const TileBuffers& buffers, const SweepMetric& metric, TileSpan span);

}  // namespace isolume
