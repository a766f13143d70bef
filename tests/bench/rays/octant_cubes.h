// Cubes of cells free of surface that reach ahead of a ray: a sharper certificate than the shader's clearance.
//
// The clearance of a cell is that of the nearest mixed cell in any direction, also behind the ray. Here each cell has,
// for each of the eight octants of directions, the side of the largest cube of free cells that has the cell in the
// corner where such a ray comes from:
//
//   s(c) = 0 in a mixed cell, else 1 + the least s of the seven neighbours of c ahead along one, two or three axes
//
// (a cube of side s + 1 is the union of the cell and the seven cubes of side s ahead; beyond the grid there is no
// surface, s is kLargestSide). Eight times the memory of the clearance, 1 byte per cell and octant; O(n) per octant,
// one pass. Exact for the levels; a ray through a cell with component 0 along an axis may take either octant.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sweep/grid.h"
#include "sweep/octants.h"
#include "tests/bench/rays/ray_position.h"
#include "tests/bench/rays/traced_ray.h"

namespace isolume::bench {

inline constexpr int kLargestSide = 255;

class OctantCubes {
 public:
  /// Borrows the level. At least two samples along each axis.
  explicit OctantCubes(GridView<const float> level);
  /// 0: the cell is mixed. `octant`: bit i is set where the ray goes down along axis i.
  int side(glm::ivec3 cell, int octant) const;
  glm::ivec3 cells() const { return cells_; }
  TracedRay trace(const GridRay& ray) const;

 private:
  std::size_t indexOf(glm::ivec3 cell) const;

  GridView<const float> level_;
  glm::ivec3 cells_;
  std::array<std::vector<std::uint8_t>, kOctantCount> sides_;
};

}  // namespace isolume::bench
