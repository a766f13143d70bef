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
  glm::dvec3 twist{0};  ///< second derivatives yz, xz, xy; those along one axis are 0
  double bend = 0;      ///< bound on |f(p + m) - f(p) - m . gradient| / |m|^2 for |m| <= 1 within the cell
  bool mixed = false;   ///< the cell has corners inside and outside: only such cells hold surface
};

struct LevelInterpolant {
  GridView<const float> level;
  glm::dvec3 step{1};     ///< spacing in units of the smallest
  glm::dvec3 inverse{1};  ///< 1 / step
  glm::dvec3 last{0};     ///< position of the last sample

  LevelInterpolant(GridView<const float> level_, double smallestSpacing)
      : level(level_), step(level_.spacing / smallestSpacing), inverse(1.0 / step), last(level_.size - 1) {}

  /// Do both positions lie in one cell of the grid, the first one in the box of the samples?
  static bool sameCell(glm::dvec3 a, glm::dvec3 b) {
    return b.x >= 0 && b.y >= 0 && b.z >= 0 && static_cast<int>(a.x) == static_cast<int>(b.x) &&
           static_cast<int>(a.y) == static_cast<int>(b.y) && static_cast<int>(a.z) == static_cast<int>(b.z);
  }

  /// `position` within the box of the samples.
  LevelAtPoint at(glm::dvec3 position) const {
    const int x = std::min(static_cast<int>(position.x), std::max(level.size.x - 2, 0));
    const int y = std::min(static_cast<int>(position.y), std::max(level.size.y - 2, 0));
    const int z = std::min(static_cast<int>(position.z), std::max(level.size.z - 2, 0));
    const std::ptrdiff_t nextX = level.size.x > 1 ? 1 : 0;
    const std::ptrdiff_t nextY = level.size.y > 1 ? level.strideY() : 0;
    const std::ptrdiff_t nextZ = level.size.z > 1 ? level.strideZ() : 0;
    const float* c00 = level.data + (z * level.strideZ() + y * level.strideY() + x);
    const float* c10 = c00 + nextY;
    const float* c01 = c00 + nextZ;
    const float* c11 = c10 + nextZ;
    const double tx = position.x - x, ty = position.y - y, tz = position.z - z;

    const float c[8] = {c00[0], c00[nextX], c10[0], c10[nextX], c01[0], c01[nextX], c11[0], c11[nextX]};
    int inside = 0;
    for (const float corner : c) inside += corner > 0 ? 1 : 0;
    // Along x on the four edges, then along y on two faces, then along z.
    const double slope00 = static_cast<double>(c[1]) - c[0], slope10 = static_cast<double>(c[3]) - c[2];
    const double slope01 = static_cast<double>(c[5]) - c[4], slope11 = static_cast<double>(c[7]) - c[6];
    const double on00 = c[0] + tx * slope00, on10 = c[2] + tx * slope10;
    const double on01 = c[4] + tx * slope01, on11 = c[6] + tx * slope11;
    const double twist0 = slope10 - slope00, twist1 = slope11 - slope01;
    const double slopeX0 = slope00 + ty * twist0, slopeX1 = slope01 + ty * twist1;
    const double slopeY0 = on10 - on00, slopeY1 = on11 - on01;
    const double value0 = on00 + ty * slopeY0, value1 = on01 + ty * slopeY1;
    const double twistXz = slopeX1 - slopeX0, twistYz = slopeY1 - slopeY0, slopeZ = value1 - value0;

    LevelAtPoint result;
    result.value = value0 + tz * slopeZ;
    result.gradient = glm::dvec3(slopeX0 + tz * twistXz, slopeY0 + tz * twistYz, slopeZ) * inverse;
    result.twist = glm::dvec3(twistYz * inverse.y * inverse.z, twistXz * inverse.x * inverse.z,
                              (twist0 + tz * (twist1 - twist0)) * inverse.x * inverse.y);
    result.bend = std::abs(result.twist.x) + std::abs(result.twist.y) + std::abs(result.twist.z) +
                  std::abs((twist1 - twist0) * inverse.x * inverse.y * inverse.z);
    result.mixed = inside > 0 && inside < 8;
    return result;
  }
};

}  // namespace isolume
