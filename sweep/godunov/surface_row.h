// Start value of one voxel, one voxel at a time: the plain form of what surface_start.cpp does for vectors.
#pragma once

#include <algorithm>
#include <glm/vec3.hpp>

#include "surface_start.h"

namespace isolume {

/// Rows of levels around one row; the row itself stands in where the grid ends, since a row never crosses itself.
struct RowNeighbours {
  const float *here, *yBefore, *yAfter, *zBefore, *zAfter;
};

/// The smaller of `best` and the distance to the crossing on the edge to `there`, if that edge is crossed. The zero of
/// the linear interpolant; both levels halved so that their difference cannot overflow.
inline float nearerCrossing(float best, float here, float there, float spacing) {
  const float along = spacing * ((0.5F * here) / (0.5F * here - 0.5F * there));
  return (here > 0) != (there > 0) ? std::min(best, along) : best;
}

/// startRow() for voxel x of a row of `count`, axis minimum; spacing in units of the smallest.
inline float startValueAt(const RowNeighbours& rows, glm::vec3 spacing, float unset, int count, int x, bool onBorder) {
  const float here = rows.here[x];
  const bool border = onBorder || x == 0 || x + 1 == count;
  float best = border && here > 0 ? 0 : kUnsetDistance;
  if (x > 0) best = nearerCrossing(best, here, rows.here[x - 1], spacing.x);
  if (x + 1 < count) best = nearerCrossing(best, here, rows.here[x + 1], spacing.x);
  best = nearerCrossing(best, here, rows.yBefore[x], spacing.y);
  best = nearerCrossing(best, here, rows.yAfter[x], spacing.y);
  best = nearerCrossing(best, here, rows.zBefore[x], spacing.z);
  best = nearerCrossing(best, here, rows.zAfter[x], spacing.z);
  const bool fixed = best < kUnsetDistance;
  const float magnitude = withFixedBit(std::min(std::max(best, kSmallestDistance), unset), fixed);
  return here > 0 ? -magnitude : magnitude;
}

}  // namespace isolume
