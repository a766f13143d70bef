// The distance sweep run until nothing changes, on many small grids of every degenerate kind: what must hold on any
// data.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "support/random_grids.h"
#include "sweep/occlusion_sweep.h"

namespace isolume {
namespace {

using test::mirrored;
using test::permuted;
using test::randomGrid;
using test::RandomGrid;

constexpr int kGrids = 10000;
// More rounds than any of them needs; EndsByItself checks it.
constexpr int kManyRounds = 1000;

Grid<float> solved(GridView<const float> level, int rounds = kManyRounds, DistanceStart start = DistanceStart::better) {
  return std::move(
      sweepOcclusion(level, {.visibility = VisibilityStorage::none, .start = start, .rounds = rounds}).distance);
}

bool sameBits(const Grid<float>& a, const Grid<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.count() * sizeof(float)) == 0;
}

TEST(FixedPoint, MirroredAndPermutedGridsGiveTheSameBits) {
  // The fixed point depends on no order: mirroring or permuting the axes of the data does the same to the result, to
  // the last bit, with either start.
  for (int i = 0; i < kGrids; ++i) {
    const RandomGrid grid = randomGrid(i);
    const DistanceStart start = i % 4 == 0 ? DistanceStart::paper : DistanceStart::better;
    const Grid<float> distance = solved(grid.level.view(), kManyRounds, start);
    const int mirror = i % 8;
    ASSERT_TRUE(sameBits(solved(mirrored(grid.level, mirror).view(), kManyRounds, start), mirrored(distance, mirror)))
        << grid.name << " mirrored " << mirror;
    const int order = i % 6;
    ASSERT_TRUE(sameBits(solved(permuted(grid.level, order).view(), kManyRounds, start), permuted(distance, order)))
        << grid.name << " permuted " << order;
  }
}

TEST(FixedPoint, OneMoreRoundChangesNothing) {
  // Rounds stop by themselves where nothing changes: twice as many give the same bits, and so do far fewer than
  // allowed.
  int needMore = 0;
  for (int i = 0; i < kGrids; ++i) {
    const RandomGrid grid = randomGrid(i);
    const Grid<float> distance = solved(grid.level.view());
    ASSERT_TRUE(sameBits(solved(grid.level.view(), 2 * kManyRounds), distance)) << grid.name;
    // 8^3 samples at most: a wave crosses them in a few rounds, however it winds.
    ASSERT_TRUE(sameBits(solved(grid.level.view(), 16), distance)) << grid.name;
    needMore += sameBits(solved(grid.level.view(), 1), distance) ? 0 : 1;
  }
  EXPECT_GT(needMore, 100) << "one round is never enough: the grids are too simple to test anything";
}

TEST(FixedPoint, HasTheSignOfTheDataAndIsOneLipschitzAlongTheAxes) {
  // D < 0 exactly where the level is positive, and |D| is at most a neighbour's on the same side plus the spacing, up
  // to the rounding of the update: two units of the last place of an even float.
  constexpr float kRounding = 1 + 4 * std::numeric_limits<float>::epsilon();
  for (int i = 0; i < kGrids; ++i) {
    const RandomGrid grid = randomGrid(i);
    const Grid<float> distance = solved(grid.level.view());
    const auto level = grid.level.view();
    const auto d = distance.view();
    const glm::ivec3 n = level.size;
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x) {
          ASSERT_EQ(std::signbit(d(x, y, z)), level(x, y, z) > 0) << grid.name;
          ASSERT_FALSE(std::isnan(d(x, y, z)));
          for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 q(x, y, z);
            if (++q[axis] >= n[axis]) continue;
            const float a = std::abs(d(x, y, z)), b = std::abs(d(q.x, q.y, q.z));
            const auto h = static_cast<float>(level.spacing[axis]);
            ASSERT_LE(std::max(a, b), (std::min(a, b) + h) * kRounding) << grid.name << " axis " << axis;
          }
        }
  }
}

TEST(FixedPoint, IsAtMostTheShortestPathAlongTheGridToTheSurface) {
  // |D| is at most the length of any path along grid edges to a crossed edge and along it to the crossing: the update
  // is never above a neighbour plus the spacing. That path is at most sqrt(3) times the straight line to that crossing.
  constexpr double kRounding = 1 + 64 * std::numeric_limits<float>::epsilon();
  for (int i = 0; i < kGrids; i += 4) {
    const RandomGrid grid = randomGrid(i);
    const Grid<float> distance = solved(grid.level.view());
    const auto level = grid.level.view();
    const glm::ivec3 n = level.size;
    // A sample on the surface is kept this far from it, so that zero has a sign (surface_start.h).
    const double least = 2 * kSmallestDistance * smallestSpacing(level.spacing);
    for (const test::Crossing& crossing : test::crossings(level)) {
      for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
          for (int x = 0; x < n.x; ++x) {
            const glm::dvec3 away = glm::abs(glm::dvec3(x, y, z) - crossing.sample) * level.spacing;
            const double path = away.x + away.y + away.z + crossing.along;
            ASSERT_LE(std::abs(distance.view()(x, y, z)), path * kRounding + least) << grid.name;
          }
    }
  }
}

}  // namespace
}  // namespace isolume
