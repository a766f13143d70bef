// Closest points of many samples at once, in SIMD: the fast form of closest_point.h, in float.
//
// Newton's method on the equations of closest_point.h, one evaluation of the interpolant per step: the step aims at
// f = 0 and at the foot at once. A point counts if it lies on the surface to kOnSurface and is nearer than the one
// before it. A lane is settled when its point is on the surface and a foot (the tangential step left would shorten the
// distance by less than 1e-5) and not further than the point it came with. What does not settle within kPointSteps
// keeps the best point found and is left to closest_point.h: creases between cells, saddles, other sheets.
//
// Levels are scaled by a power of two per cell, so that their size does not matter; where a cell's steepness is below
// kSteepEnough of its largest level, float is too coarse and the lane fails. No fused operations, no approximate
// reciprocals: the same bits on every target and for any order of samples. Thread-safe.
#pragma once

#include <cstdint>

#include "level_cell.h"
#include "point_batch.h"

namespace isolume {

/// The level as the kernels see it. Cells are addressed by 32 bits from the first plane within reach of the sample.
struct PointFrame {
  const float* level = nullptr;
  glm::ivec3 size{0};
  glm::vec3 step{1};     ///< spacing in units of the smallest
  glm::vec3 inverse{1};  ///< 1 / step

  explicit PointFrame(GridView<const float> view);
  /// False for planes so large (2^25 samples) that the kernels cannot address the cells around a sample.
  bool fits() const;
};

/// How many samples a point may be from its sample along each axis.
inline constexpr int kPointReach = 24;

/// PointBatch::promised before the interpolant has confirmed a point.
inline constexpr float kNothingPromised = 0x1p60F;

/// Offsets and trials of samples of plane z from the crossings of their own edges: the offset is the nearest crossing,
/// the trial the foot on the plane through the nearest crossing of each axis. Every sample must have a crossed edge.
void startAtCrossings(const PointFrame& frame, int z, PointBatch& batch);

/// Makes searches of samples with a crossed edge stuck if one of those crossings is not on the sheet of the point
/// found: if it leaves the plane there, across the offset, by more than kSameSheet.
void doubtOtherSheets(const PointFrame& frame, int z, PointBatch& batch);

/// Moves the offsets of samples of plane z to closest points, starting at the trials, and says how each search ended.
void searchPoints(const PointFrame& frame, int z, PointBatch& batch);

}  // namespace isolume
