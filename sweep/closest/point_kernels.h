// Closest points of many samples at once, in SIMD: the fast form of closest_point.h, in float.
//
// A search looks at the interpolant once per step. A look counts if its point lies on the surface and is nearer than
// the best before it; from there goes Newton's step for closest_point.h's equations. From a look off the surface goes a
// step straight to it; where that fails, or ends further away, half as much as before of the tangential step from the
// best point. Before it is halved, that step is tried as far as the next cell alone: the interpolant has creases where
// cells meet, and on a convex one lies the closest point of all samples in a wedge. If the step that the next cell asks
// for leads back at once, the search goes on within the face between the two. Searches end as
//   settled  the step left would shorten the distance by less than 1e-5 spacings (or by 1e-3, after kMostTries looks in
//            vain: a corner where creases meet);
//   stuck    after as many looks, with more than that to gain: another sheet, a saddle;
//   failed   in a cell whose steepness is below kSteepEnough of its largest level, where float is too coarse.
// On the surface means |f| <= kOnSurface |grad f| as computed: the rounding of f adds 4e-7 of the cell's largest level
// over |grad f|, 3e-5 spacings at worst.
//
// Levels are scaled by a power of two per cell, so that their size does not matter. No fused operations, no approximate
// reciprocals, and what a sample gets does not depend on its neighbours in the vector: the same bits on every target,
// in any order of samples. Two looks and a half per sample. Thread-safe.
#pragma once

#include <cstdint>

#include "level_cell.h"
#include "point_batch.h"

namespace isolume {

/// The level as the kernels see it. Cells are addressed by 32 bits from the first plane within reach of a batch.
struct PointFrame {
  const float* level = nullptr;
  glm::ivec3 size{0};
  glm::vec3 step{1};     ///< spacing in units of the smallest
  glm::vec3 inverse{1};  ///< 1 / step

  explicit PointFrame(GridView<const float> view);
  /// False for planes so large (3.7e7 samples) that 32 bits do not address the cells around a sample.
  bool fits() const;
};

/// How many samples a point may be from its sample along each axis.
inline constexpr int kPointReach = 24;

/// PointBatch::promised before the interpolant has confirmed a point.
inline constexpr float kNothingPromised = 0x1p60F;

/// Offsets and trials from the crossings of their own edges: the offset is the nearest crossing,
/// the trial the foot on the plane through the nearest crossing of each axis. Every sample must have a crossed edge.
void startAtCrossings(const PointFrame& frame, PointBatch& batch);

/// Makes searches of samples with a crossed edge stuck if one of those crossings is not on the sheet of the point
/// found: if it leaves the plane there, across the offset, by more than kSameSheet.
void doubtOtherSheets(const PointFrame& frame, PointBatch& batch);

/// Moves the offsets to closest points, starting at the trials, and says how each search ended.
void searchPoints(const PointFrame& frame, PointBatch& batch);

}  // namespace isolume
