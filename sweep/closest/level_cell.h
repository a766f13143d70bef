// The trilinear interpolant of a level at one point, with its gradient.
//
// Positions are in samples (sample (i, j, k) at (i, j, k)); the gradient is per unit of the smallest spacing. An axis
// with a single sample has no extent: the gradient along it is 0. In double, so that levels from the smallest denormal
// to the largest float need no scaling. Thread-safe.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sweep/grid.h"

namespace isolume {

struct LevelAtPoint {
  double value = 0;
  glm::dvec3 gradient{0};
  bool mixed = false;  ///< the cell has corners inside and outside: only such cells hold surface
};

struct LevelInterpolant {
  GridView<const float> level;
  glm::dvec3 step{1};  ///< spacing in units of the smallest

  /// `position` within the box of the samples.
  LevelAtPoint at(glm::dvec3 position) const {
    std::ptrdiff_t stride[3] = {1, level.strideY(), level.strideZ()};
    double t[3];
    std::ptrdiff_t first = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int cell = std::clamp(static_cast<int>(position[axis]), 0, std::max(level.size[axis] - 2, 0));
      first += cell * stride[axis];
      if (level.size[axis] == 1) stride[axis] = 0;
      t[axis] = position[axis] - cell;
    }
    const float* corner = level.data + first;
    const float* cornerY = corner + stride[1];
    const float* cornerZ = corner + stride[2];
    const float* cornerYz = cornerY + stride[2];
    const std::ptrdiff_t sx = stride[0];
    const float c[8] = {corner[0],  corner[sx],  cornerY[0],  cornerY[sx],
                        cornerZ[0], cornerZ[sx], cornerYz[0], cornerYz[sx]};
    const auto [low, high] = std::minmax({c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]});

    double along[4], slope[4];  // along x on the four edges
    for (int e = 0; e < 4; ++e) {
      slope[e] = static_cast<double>(c[2 * e + 1]) - c[2 * e];
      along[e] = c[2 * e] + t[0] * slope[e];
    }
    const double slopeX0 = slope[0] + t[1] * (slope[1] - slope[0]);
    const double slopeX1 = slope[2] + t[1] * (slope[3] - slope[2]);
    const double slopeY0 = along[1] - along[0];
    const double slopeY1 = along[3] - along[2];
    const double value0 = along[0] + t[1] * slopeY0;
    const double value1 = along[2] + t[1] * slopeY1;
    LevelAtPoint result;
    result.value = value0 + t[2] * (value1 - value0);
    result.gradient =
        glm::dvec3(slopeX0 + t[2] * (slopeX1 - slopeX0), slopeY0 + t[2] * (slopeY1 - slopeY0), value1 - value0) / step;
    result.mixed = low <= 0 && high > 0;
    return result;
  }
};

}  // namespace isolume
