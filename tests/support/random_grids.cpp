#include "support/random_grids.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>

namespace isolume::test {
namespace {

class Numbers {
 public:
  explicit Numbers(int seed) : state_(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15ULL + 1) {}
  /// In [0, 1).
  double uniform() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;  // Knuth's MMIX generator
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  int below(int bound) { return static_cast<int>(uniform() * bound); }

 private:
  std::uint64_t state_;
};

constexpr const char* kKinds[] = {"noise",      "plateaus",    "at the isovalue", "extreme values",
                                  "all inside", "all outside", "single samples",  "ball"};
constexpr int kKindCount = 8;

float levelOf(int kind, Numbers& numbers, glm::dvec3 fromCentre) {
  const double noise = 2 * numbers.uniform() - 1;
  switch (kind) {
    case 0:
      return static_cast<float>(noise);
    case 1:
      return noise > 0 ? 1.0F : noise > -0.5 ? -1.0F : -2.0F;
    case 2:
      return noise > 0.3 ? 1.0F : noise > -0.3 ? 0.0F : -1.0F;
    case 3:
      return (noise > 0 ? 1.0F : -1.0F) * (numbers.below(2) == 0 ? 1e-30F : 1e30F);
    case 4:
      return static_cast<float>(1.5 + noise);
    case 5:
      return static_cast<float>(-1.0 - noise);
    case 6:
      return noise > 0.98 ? 1.0F : -1.0F;
    default:
      return static_cast<float>(2.7 - glm::length(fromCentre));
  }
}

template <class Map>
Grid<float> mapped(const Grid<float>& grid, glm::ivec3 size, glm::dvec3 spacing, const Map& from) {
  Grid<float> result(size, spacing);
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const glm::ivec3 q = from(glm::ivec3(x, y, z));
        result.view()(x, y, z) = grid.view()(q.x, q.y, q.z);
      }
  return result;
}

}  // namespace

RandomGrid randomGrid(int i) {
  Numbers numbers(i);
  constexpr std::array<glm::ivec3, 4> kSmall{glm::ivec3(1, 1, 1), glm::ivec3(1, 1, 7), glm::ivec3(2, 2, 2),
                                             glm::ivec3(1, 6, 5)};
  constexpr std::array<double, 6> kSpacings{1, 1, 1, 1.5, 0.3, 1000};
  constexpr int kLongest = 8;
  glm::ivec3 size(1 + numbers.below(kLongest), 1 + numbers.below(kLongest), 1 + numbers.below(kLongest));
  if (numbers.below(8) == 0) size = kSmall[static_cast<std::size_t>(numbers.below(4))];
  glm::dvec3 spacing(1);
  if (numbers.below(2) == 0)
    for (int axis = 0; axis < 3; ++axis) spacing[axis] = kSpacings[static_cast<std::size_t>(numbers.below(6))];
  const int kind = i % kKindCount;
  RandomGrid grid;
  grid.name = "grid " + std::to_string(i) + ", " + kKinds[kind] + ", " + std::to_string(size.x) + "x" +
              std::to_string(size.y) + "x" + std::to_string(size.z);
  grid.level = Grid<float>(size, spacing);
  const glm::dvec3 centre = glm::dvec3(size - 1) / 2.0 + 0.21;
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        grid.level.view()(x, y, z) = levelOf(kind, numbers, glm::dvec3(x, y, z) - centre);
  return grid;
}

Grid<float> mirrored(const Grid<float>& grid, int axes) {
  const glm::ivec3 n = grid.size();
  return mapped(grid, n, grid.view().spacing, [&](glm::ivec3 p) {
    for (int axis = 0; axis < 3; ++axis)
      if ((axes >> axis & 1) != 0) p[axis] = n[axis] - 1 - p[axis];
    return p;
  });
}

Grid<float> permuted(const Grid<float>& grid, int order) {
  constexpr std::array<glm::ivec3, 6> kOrders{glm::ivec3(0, 1, 2), glm::ivec3(0, 2, 1), glm::ivec3(1, 0, 2),
                                              glm::ivec3(1, 2, 0), glm::ivec3(2, 0, 1), glm::ivec3(2, 1, 0)};
  const glm::ivec3 axis = kOrders[static_cast<std::size_t>(order)];
  const glm::ivec3 n = grid.size();
  const glm::dvec3 h = grid.view().spacing;
  return mapped(grid, {n[axis.x], n[axis.y], n[axis.z]}, {h[axis.x], h[axis.y], h[axis.z]}, [&](glm::ivec3 p) {
    glm::ivec3 q(0);
    for (int k = 0; k < 3; ++k) q[axis[k]] = p[k];
    return q;
  });
}

std::vector<Crossing> crossings(GridView<const float> level) {
  std::vector<Crossing> found;
  const glm::ivec3 n = level.size;
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x)
        for (int axis = 0; axis < 3; ++axis)
          for (const int side : {-1, 1}) {
            const double here = level(x, y, z);
            glm::ivec3 q(x, y, z);
            q[axis] += side;
            if (q[axis] < 0 || q[axis] >= n[axis]) {
              if (here > 0) found.push_back({glm::dvec3(x, y, z), 0});
              continue;
            }
            const double there = level(q.x, q.y, q.z);
            if ((here > 0) != (there > 0))
              found.push_back({glm::dvec3(x, y, z), level.spacing[axis] * (here / (here - there))});
          }
  return found;
}

}  // namespace isolume::test
