// The level function: the data seen from the isosurface. level > 0 inside the solid, level <= 0 outside, and the
// surface is the zero set of its trilinear interpolant, cut by the box of the samples.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "grid.h"

namespace isolume {

/// Which side of the isovalue is solid.
enum class Inside { above, below };

struct LevelSummary {
  std::size_t insideCount = 0;    ///< samples with level > 0
  std::size_t replacedCount = 0;  ///< samples that were NaN or infinite
  float finiteMin = 0;            ///< smallest and largest finite sample before the change; min > max if there is none
  float finiteMax = -1;
  glm::ivec3 solidMin{0};  ///< index bounds of the samples inside, inclusive; min > max if there is none
  glm::ivec3 solidMax{-1};
  bool hasSurface() const { return insideCount > 0; }
};

/// Turns samples into levels in place: value - isovalue, negated for Inside::below. NaN and infinities become the
/// lowest finite level (most clearly outside; -1 if that is not below 0), so that a solid ends short of them.
/// A sample exactly at the isovalue is outside. O(n), threaded; bitwise the same for any thread count.
LevelSummary makeLevel(GridView<float> values, float isovalue, Inside inside);

}  // namespace isolume
