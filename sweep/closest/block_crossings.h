// Where the surface crosses the grid edges of the eight cells around one sample.
//
// The interpolant is linear along an edge, so that a crossing is a point of the surface, exact to rounding: the zero
// between two samples of which one is inside. Offsets are from the sample, in units of the smallest spacing. Cells that
// the grid does not have are left out; an axis with one sample has one layer of cells without thickness. Thread-safe.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "level_cell.h"

namespace isolume {

inline constexpr int kBlockEdges = 54;  ///< of eight cells: 3 axes, 2 edges on each of 9 lines
inline constexpr int kNoCrossing = -1;

struct BlockCrossings {
  std::array<glm::dvec3, kBlockEdges> offset;  ///< as many as there are
  std::array<int, 8> nearest;     ///< of each cell, the index of its crossing nearest to the sample, or kNoCrossing
  std::array<double, 8> squared;  ///< and its squared distance, or the largest double
};

void findCrossings(const LevelInterpolant& level, glm::ivec3 sample, BlockCrossings& crossings);

}  // namespace isolume
