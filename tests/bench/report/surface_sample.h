// Random points of a surface with their exact openness.
#pragma once

#include <glm/vec3.hpp>
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

}  // namespace isolume::bench
