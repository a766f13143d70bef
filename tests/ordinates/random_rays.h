// Lattices and directions of no scene in particular, for rays to cross.
#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <vector>

#include "support/random_numbers.h"
#include "sweep/grid.h"
#include "sweep/ordinates/sheared_rays.h"

namespace isolume::test {

/// A level of single solid samples, one in `rarity`.
inline Grid<float> specks(glm::ivec3 size, int rarity, RandomNumbers& numbers) {
  Grid<float> level(size);
  for (std::size_t i = 0; i < level.count(); ++i) level.data()[i] = numbers.below(rarity) == 0 ? 1.0F : -1.0F;
  return level;
}

/// Directions whose rays cross most layers of the axis, some along it and some along its diagonals; all count 1 in the
/// first channel and nothing in the others.
inline std::vector<RayDirection> directionsAlong(int axis, int towards, int count, RandomNumbers& numbers) {
  const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
  std::vector<RayDirection> directions;
  while (static_cast<int>(directions.size()) < count) {
    glm::dvec3 w = numbers.direction();
    const int kind = numbers.below(6);
    if (kind == 0) w = glm::sign(w) / glm::sqrt(3.0);
    if (kind == 1) w[axes.row] = 0;
    const double size = glm::abs(w[axis]);
    if (size < glm::abs(w[axes.bit]) || size < glm::abs(w[axes.row]) || (w[axis] > 0) != (towards > 0)) continue;
    directions.push_back({static_cast<float>(w[axes.bit]), static_cast<float>(w[axes.row]), static_cast<float>(w[axis]),
                          w[axes.bit] / w[axis], w[axes.row] / w[axis], static_cast<float>(0.5 / size)});
  }
  return directions;
}

}  // namespace isolume::test
