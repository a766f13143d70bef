// Distance to the trilinear isosurface by brute force, to a certified tolerance: the truth for distance solvers.
//
// The surface is the boundary of { level > 0 } of the trilinear interpolant within the box of the samples, without caps
// at the border (use levels that are outside there). A best-first search over an octree of the cells, which goes on
// below the cell by halving: a box all of whose corners lie on one side holds no surface, since the interpolant takes
// its extremes at corners. Every box kept has a lower bound of its distance, the larger of
//
//   the distance to the box, and  (|c + g.(q - m)| - r) / |g|,
//
// where c, g, m are the interpolant's value, gradient and place at the box's centre and r bounds its mixed terms over
// the box; every edge with two signs has one exact crossing, which is an upper bound. The search ends when the least
// lower bound is within the tolerance of the best upper bound, so nothing is assumed about the data, and no iteration
// can miss a nearer part.
//
// Unit: the smallest spacing ("voxels"). Unsigned. No surface: +inf. Memory: 8/7 B per cell. Thread-safe once built.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "sweep/grid.h"

namespace isolume::bench {

/// How far the result may be above the true distance, voxels. The solvers judged are off by some hundredths on average;
/// a tighter bound costs time in proportion to its inverse where much of the surface is about equally far.
inline constexpr double kTruthTolerance = 4e-3;

class ClosestDistance {
 public:
  /// Borrows the level (finite, > 0 inside), at least two samples along each axis.
  explicit ClosestDistance(GridView<const float> level);

  /// `position` in index space, anywhere.
  double operator()(glm::dvec3 position, double tolerance = kTruthTolerance) const;

  /// Cells with samples on both sides, in index order.
  std::vector<glm::ivec3> mixedCells() const;

 private:
  /// Blocks of 2^k cells at octree level k: whether each holds samples on both sides.
  struct Blocks {
    glm::ivec3 size{0};
    std::vector<std::uint8_t> mixed;
    bool at(glm::ivec3 i) const {
      return mixed[(static_cast<std::size_t>(i.z) * size.y + i.y) * static_cast<std::size_t>(size.x) + i.x] != 0;
    }
  };

  GridView<const float> level_;
  glm::dvec3 spacing_;  ///< in smallest spacings
  std::vector<Blocks> blocks_;
};

}  // namespace isolume::bench
