#include "rotated_shadow.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <utility>

#include "light_sweeper.h"
#include "sweep/octants.h"
#include "sweep/parallel.h"
#include "sweep/trilinear.h"

namespace isolume {
namespace {

// Voxels: far more than rounding moves a sample, far less than anyone sees. Keeps a grid that is not turned congruent.
constexpr double kSlack = 1e-9;

int nearestOctant(glm::dvec3 towardsLight) {
  for (int s = 0; s < kOctantCount; ++s) {
    const glm::bvec3 positive = glm::greaterThan(kOctants[static_cast<std::size_t>(s)].towardsLight(), glm::ivec3(0));
    if (positive == glm::greaterThanEqual(towardsLight, glm::dvec3(0))) return s;
  }
  return kOctantCount - 1;
}

// The smallest turn that takes unit vector `from` to unit vector `to`, not its opposite: with v = from x to and
// c = from . to, 1 + [v] + [v]^2 / (1 + c).
glm::dmat3 smallestTurn(glm::dvec3 from, glm::dvec3 to) {
  const glm::dvec3 v = glm::cross(from, to);
  const glm::dmat3 cross(glm::dvec3(0, v.z, -v.y), glm::dvec3(-v.z, 0, v.x), glm::dvec3(v.y, -v.x, 0));
  return glm::dmat3(1) + cross + cross * cross / (1 + glm::dot(from, to));
}

// Difference quotient one sample to each side, one-sided at the border; 0 along an axis with one sample.
glm::dvec3 gradientAt(GridView<const float> field, glm::ivec3 at) {
  glm::dvec3 gradient(0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 before = at, after = at;
    before[axis] = std::max(at[axis] - 1, 0);
    after[axis] = std::min(at[axis] + 1, field.size[axis] - 1);
    const double between = field(after.x, after.y, after.z) - field(before.x, before.y, before.z);
    if (after[axis] > before[axis]) gradient[axis] = between / ((after[axis] - before[axis]) * field.spacing[axis]);
  }
  return gradient;
}

// The turned grid about the middle of the given one. Lengths in world units.
struct TurnedGrid {
  glm::dmat3 axesFromTurned{1};
  glm::dvec3 middle{0};  // of the given grid, from its first sample
  glm::dvec3 low{0};     // first turned sample, from the middle
  glm::ivec3 size{0};
  double spacing = 1;

  glm::dvec3 positionOf(glm::ivec3 sample) const {
    return middle + axesFromTurned * (low + spacing * glm::dvec3(sample));
  }
  glm::dvec3 indexOf(glm::dvec3 position) const {
    return (glm::transpose(axesFromTurned) * (position - middle) - low) / spacing;
  }
};

TurnedGrid turnedGrid(GridView<const float> grid, const glm::dmat3& axesFromTurned) {
  TurnedGrid turned;
  turned.axesFromTurned = axesFromTurned;
  turned.middle = grid.spacing * glm::dvec3(grid.size - 1) / 2.0;
  turned.spacing = smallestSpacing(grid.spacing);
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = 2 * glm::dot(glm::abs(axesFromTurned[axis]), turned.middle) / turned.spacing;
    turned.size[axis] = static_cast<int>(std::ceil(reach - kSlack)) + 1;
    turned.low[axis] = -turned.spacing * (turned.size[axis] - 1) / 2;
  }
  return turned;
}

Grid<float> turnDistance(GridView<const float> distance, const TurnedGrid& turned) {
  Grid<float> result(turned.size, glm::dvec3(turned.spacing));
  const glm::dvec3 last(distance.size - 1);
  parallelFor(static_cast<std::size_t>(turned.size.z), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    float* out = result.data() + plane * voxelCount({turned.size.x, turned.size.y, 1});
    for (int y = 0; y < turned.size.y; ++y)
      for (int x = 0; x < turned.size.x; ++x, ++out) {
        const glm::dvec3 index = turned.positionOf({x, y, z}) / distance.spacing;
        const bool within = glm::all(glm::greaterThanEqual(index, glm::dvec3(-kSlack))) &&
                            glm::all(glm::lessThanEqual(index, last + kSlack));
        *out = within ? static_cast<float>(trilinear(distance, glm::clamp(index, glm::dvec3(0), last)))
                      : std::numeric_limits<float>::infinity();
      }
  });
  return result;
}

}  // namespace

Grid<std::uint16_t> sweepRotatedShadow(GridView<const float> distance, glm::dvec3 towardsLight,
                                       const RotatedShadowOptions& options) {
  assert(glm::length(towardsLight) > 0);
  assert(options.offsetVoxels >= 0);
  const int octant = nearestOctant(towardsLight);
  const glm::dvec3 diagonal(kOctants[static_cast<std::size_t>(octant)].towardsLight());
  const TurnedGrid turned = turnedGrid(distance, smallestTurn(glm::normalize(diagonal), glm::normalize(towardsLight)));

  // The octant's V takes the place of the distance: each tile is read before it is written.
  Grid<float> field = turnDistance(distance, turned);
  LightSweeper sweeper(std::as_const(field).view(), options.opacity);
  sweeper.sweep(OctantSet().set(static_cast<std::size_t>(octant)), [&](const LitTile& tile) {
    storeTile(tile.walk, tile.origin, {0, turned.size.x}, tile.visibility, field.data());
  });

  Grid<std::uint16_t> shadow(distance.size, distance.spacing, distance.origin);
  const GridView<const float> visibility = std::as_const(field).view();
  const double offset = options.offsetVoxels * turned.spacing;
  parallelFor(static_cast<std::size_t>(distance.size.z), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    for (int y = 0; y < distance.size.y; ++y)
      for (int x = 0; x < distance.size.x; ++x) {
        glm::dvec3 position = distance.spacing * glm::dvec3(x, y, z);
        if (offset > 0) {
          const glm::dvec3 gradient = gradientAt(distance, {x, y, z});
          const double length = glm::length(gradient);
          if (std::isfinite(length) && length > 0) position += offset / length * gradient;
        }
        const glm::dvec3 index = glm::clamp(turned.indexOf(position), glm::dvec3(0), glm::dvec3(turned.size - 1));
        shadow.view()(x, y, z) = static_cast<std::uint16_t>(std::lround(65535 * trilinear(visibility, index)));
      }
  });
  return shadow;
}

}  // namespace isolume
