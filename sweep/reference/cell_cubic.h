// The trilinear interpolant of one cell, at a point and along a segment.
//
// Along a straight segment it is a cubic, and its Bernstein coefficients are values of the interpolant itself, at the
// corners of the box that the segment spans (its blossom): with f(x, y, z) and the segment from p to q,
//   b0 = f(p)   3 b1 = f(q.x, p.y, p.z) + f(p.x, q.y, p.z) + f(p.x, p.y, q.z)
//   b3 = f(q)   3 b2 = f(q.x, q.y, p.z) + f(q.x, p.y, q.z) + f(p.x, q.y, q.z)
// Each is a mean of the eight corner levels with weights >= 0: nothing cancels, the error is 2^-50 of the largest
// corner, a cell without an inside corner has no coefficient above 0, and on the face between two cells both give the
// same bits. Expanding the cubic in powers of t ([Parker98] Sec. 2.1) has none of these properties.
#pragma once

#include <glm/vec3.hpp>

#include "sweep/grid.h"
#include "sweep/reference/cubic.h"

namespace isolume {

/// Levels of a cell's corners: [x + 2 y + 4 z].
struct CellCorners {
  double at[8];

  CellCorners(GridView<const float> level, glm::ivec3 cell);
  /// Points relative to the cell's lowest corner, in [0, 1]^3.
  double valueAt(glm::dvec3 p) const;
  glm::dvec3 gradientAt(glm::dvec3 p) const;
  Cubic along(glm::dvec3 p, glm::dvec3 q) const;
  double largestMagnitude() const;
};

}  // namespace isolume
