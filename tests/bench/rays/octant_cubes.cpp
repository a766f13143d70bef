#include "tests/bench/rays/octant_cubes.h"

#include <algorithm>
#include <glm/common.hpp>

#include "sweep/parallel.h"

namespace isolume::bench {

std::size_t OctantCubes::indexOf(glm::ivec3 cell) const {
  return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(cells_.y) + static_cast<std::size_t>(cell.y)) *
             static_cast<std::size_t>(cells_.x) +
         static_cast<std::size_t>(cell.x);
}

int OctantCubes::side(glm::ivec3 cell, int octant) const {
  return sides_[static_cast<std::size_t>(octant)][indexOf(cell)];
}

OctantCubes::OctantCubes(GridView<const float> level) : level_(level), cells_(level.size - 1) {
  std::vector<std::uint8_t> mixed(voxelCount(cells_));
  for (glm::ivec3 cell(0); cell.z < cells_.z; ++cell.z)
    for (cell.y = 0; cell.y < cells_.y; ++cell.y)
      for (cell.x = 0; cell.x < cells_.x; ++cell.x) mixed[indexOf(cell)] = isMixed(level, cell);

  parallelFor(sides_.size(), [&](std::size_t octant) {
    std::vector<std::uint8_t>& sides = sides_[octant];
    sides.resize(mixed.size());
    glm::ivec3 ahead;
    for (int axis = 0; axis < 3; ++axis) ahead[axis] = (octant >> axis & 1) != 0 ? -1 : 1;
    // From the end that such rays go to, backwards.
    const auto cellAt = [&](int x, int y, int z) {
      const glm::ivec3 steps(x, y, z);
      glm::ivec3 cell;
      for (int axis = 0; axis < 3; ++axis) cell[axis] = ahead[axis] > 0 ? cells_[axis] - 1 - steps[axis] : steps[axis];
      return cell;
    };
    for (int z = 0; z < cells_.z; ++z)
      for (int y = 0; y < cells_.y; ++y)
        for (int x = 0; x < cells_.x; ++x) {
          const glm::ivec3 cell = cellAt(x, y, z);
          int least = mixed[indexOf(cell)] != 0 ? -1 : kLargestSide - 1;
          constexpr int kAllAxes = 7;
          for (int axes = 1; axes <= kAllAxes && least >= 0; ++axes) {
            const glm::ivec3 next = cell + ahead * glm::ivec3(axes & 1, axes >> 1 & 1, axes >> 2);
            if (next != glm::clamp(next, glm::ivec3(0), cells_ - 1)) continue;
            least = std::min<int>(least, sides[indexOf(next)]);
          }
          sides[indexOf(cell)] = static_cast<std::uint8_t>(least + 1);
        }
  });
}

TracedRay OctantCubes::trace(const GridRay& ray) const {
  TracedRay traced;
  const RayStart start = startOf(level_, ray);
  if (!start.clip) return traced;
  traced.found = start.cap;
  if (start.cap) return traced;
  int octant = 0;
  for (int axis = 0; axis < 3; ++axis) octant |= ray.direction[axis] < 0 ? 1 << axis : 0;
  RayPosition position(ray, level_.size, start.clip->begin);
  for (bool inGrid = true; inGrid;) {
    ++traced.steps;
    const int side = this->side(position.cell(), octant);
    CellBox box{position.cell(), position.cell()};
    if (side == 0) {
      ++traced.solves;
      const double end = std::min(position.exit(), start.clip->end);
      traced.found = surfaceInCell(level_, position, end, start.inside);
      if (traced.found) return traced;
    } else if (isBeyondSurface(level_, position.cell(), start.inside)) {
      traced.found = position.point();
      return traced;
    } else {
      for (int axis = 0; axis < 3; ++axis)
        (octant >> axis & 1 ? box.low : box.high)[axis] += (octant >> axis & 1 ? 1 - side : side - 1);
    }
    inGrid = position.leave(box) && position.t() < start.clip->end;
  }
  traced.found = foundAtEnd(start, position);
  return traced;
}

}  // namespace isolume::bench
