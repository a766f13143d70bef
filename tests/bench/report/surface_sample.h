// Random points of a surface with their exact openness, and fields read there.
#pragma once

#include <algorithm>
#include <glm/common.hpp>
#include <vector>

#include "sweep/grid.h"

namespace isolume::bench {

struct JudgedPoint {
  glm::dvec3 position{0};  ///< on the surface, index space
  glm::dvec3 normal{0};    ///< unit, as pictures show it; cubic voxels
  double openness = 0;     ///< by Monte Carlo
};

/// At random crossed cells, evenly over these; the same for the same level. Cubic voxels.
std::vector<JudgedPoint> judgedPoints(GridView<const float> level, int count, int rays);

/// Trilinear, clamped to the grid.
template <class T>
double trilinear(GridView<const T> field, glm::dvec3 position) {
  const glm::dvec3 p = glm::clamp(position, glm::dvec3(0), glm::dvec3(field.size - 1));
  const glm::ivec3 low = glm::min(glm::ivec3(p), field.size - 2);
  const glm::dvec3 part = p - glm::dvec3(low);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 weight = glm::mix(1.0 - part, part, glm::dvec3(side));
    sum += weight.x * weight.y * weight.z * static_cast<double>(field(low.x + side.x, low.y + side.y, low.z + side.z));
  }
  return sum;
}

}  // namespace isolume::bench
