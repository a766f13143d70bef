// Bounds of the distance against the distance itself: they must never be above it.
#include "sweep/bounds/lower_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "bench/report/closest_distance.h"
#include "reference/random_rays.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/half.h"
#include "sweep/level.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/parallel.h"
#include "volumes/scenes.h"

namespace isolume::test {
namespace {

// By how much the judge's distance may be above the true one, voxels: at first, and where that does not settle it.
constexpr double kCoarseJudge = 0.1, kFineJudge = 1e-3;

struct SmallGrid {
  Grid<float> level;
  glm::dvec3 scale;  ///< spacing in voxels
};

// 2 to 9 samples along each axis, spacings up to 1 : 4, from no structure at all to a few samples inside.
SmallGrid randomGrid(std::uint64_t number) {
  Random random(number);
  const glm::ivec3 size(2 + random.below(8), 2 + random.below(8), 2 + random.below(8));
  const glm::dvec3 spacing = random.below(2) == 0 ? glm::dvec3(0.5) : random.pointIn(glm::dvec3(0.5), glm::dvec3(2));
  SmallGrid grid{noiseLevel(size, spacing, number), spacing / smallestSpacing(spacing)};
  const double shares[] = {0, 0.5, 0.9, 0.98};
  const auto bias = static_cast<float>(shares[random.below(4)]);
  for (std::size_t i = 0; i < grid.level.count(); ++i) grid.level.data()[i] -= bias;
  return grid;
}

bool isMixed(GridView<const float> level, glm::ivec3 cell) {
  int inside = 0;
  for (int c = 0; c < 8; ++c) inside += level(cell.x + (c & 1), cell.y + ((c >> 1) & 1), cell.z + (c >> 2)) > 0;
  return inside != 0 && inside != 8;
}

glm::ivec3 cellOf(GridView<const float> level, glm::dvec3 point) {
  return glm::clamp(glm::ivec3(point), glm::ivec3(0), level.size - 2);
}

double interpolatedMagnitude(GridView<const float> field, glm::dvec3 point) {
  const glm::ivec3 cell = cellOf(field, point);
  const glm::dvec3 u = point - glm::dvec3(cell);
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    const glm::ivec3 bit(c & 1, (c >> 1) & 1, c >> 2);
    sum += (bit.x ? u.x : 1 - u.x) * (bit.y ? u.y : 1 - u.y) * (bit.z ? u.z : 1 - u.z) *
           std::abs(field(cell.x + bit.x, cell.y + bit.y, cell.z + bit.z));
  }
  return sum;
}

Grid<float> inVoxels(Grid<float> distance, GridView<const float> level) {
  const double smallest = smallestSpacing(level.spacing);
  for (std::size_t i = 0; i < distance.count(); ++i)
    distance.data()[i] = static_cast<float>(distance.data()[i] / smallest);
  return distance;
}

// Largest excess of each bound over the distance at random points, and the largest bound seen.
struct Excess {
  double cell = -1e9, halfCell = -1e9, godunov = -1e9, closest = -1e9, half = -1e9, stretched = -1e9, raw = -1e9;
  double largestCell = 0, largestField = 0;
};

void expectBelowDistance(GridView<const float> level, std::uint64_t seed, int points, Excess& worst) {
  const Grid<float> cells = cellLowerBound(level);
  const Grid<float> godunov = inVoxels(sweepOcclusion(level, {.visibility = VisibilityStorage::none}).distance, level);
  const Grid<float> closest = inVoxels(closestDistance(level), level);
  if (!std::isfinite(godunov.data()[0])) return;
  // A solver that is wrong by a factor: certified like any other.
  Grid<float> stretched(level.size, level.spacing);
  for (std::size_t i = 0; i < stretched.count(); ++i) stretched.data()[i] = 3 * closest.data()[i];
  const FieldBound ofStretched = certifyField(level, stretched.view());
  Grid<std::uint16_t> halves(level.size, level.spacing);
  Grid<float> fromHalves(level.size, level.spacing);
  for (std::size_t i = 0; i < halves.count(); ++i) {
    halves.data()[i] = halfFromFloat(closest.data()[i]);
    fromHalves.data()[i] = floatFromHalf(halves.data()[i]);
  }
  const FieldBound ofGodunov = certifyField(level, godunov.view()), ofClosest = certifyField(level, closest.view()),
                   ofHalves = certifyField(level, GridView<const std::uint16_t>(halves.view()));
  const bench::ClosestDistance truth(level);
  Random random(~seed);
  for (int i = 0; i < points; ++i) {
    const glm::dvec3 point = random.pointIn(glm::dvec3(0), glm::dvec3(level.size - 1));
    const glm::ivec3 cell = cellOf(level, point);
    const float bound = cells.view()(cell.x, cell.y, cell.z);
    const auto fieldBound = [&](const FieldBound& certified, const Grid<float>& field) {
      const float value = certified(static_cast<float>(interpolatedMagnitude(field.view(), point)));
      worst.largestField = std::max<double>(worst.largestField, value);
      return value;
    };
    const double ofCell = bound, ofHalfCell = floatFromHalf(halfBelow(bound)), field = fieldBound(ofGodunov, godunov),
                 closestField = fieldBound(ofClosest, closest), halfField = fieldBound(ofHalves, fromHalves),
                 stretchedField = fieldBound(ofStretched, stretched);
    double distance = truth(point, kCoarseJudge) - kCoarseJudge;
    const double largest = std::max({ofCell, ofHalfCell, field, closestField, halfField, stretchedField});
    if (largest > std::max(distance, 0.0)) distance = truth(point, kFineJudge);
    distance = std::max(distance, 0.0);  // the judge's least is below 0 next to the surface
    worst.cell = std::max(worst.cell, ofCell - distance);
    worst.halfCell = std::max(worst.halfCell, ofHalfCell - distance);
    worst.godunov = std::max(worst.godunov, field - distance);
    worst.closest = std::max(worst.closest, closestField - distance);
    worst.half = std::max(worst.half, halfField - distance);
    worst.stretched = std::max(worst.stretched, stretchedField - distance);
    worst.raw = std::max(worst.raw, interpolatedMagnitude(godunov.view(), point) - distance - kCoarseJudge);
    worst.largestCell = std::max<double>(worst.largestCell, bound);
  }
}

void expectNoExcess(const Excess& worst) {
  EXPECT_LE(worst.cell, 0);
  EXPECT_LE(worst.halfCell, 0);
  EXPECT_LE(worst.godunov, 0);
  EXPECT_LE(worst.closest, 0);
  EXPECT_LE(worst.half, 0);
  EXPECT_LE(worst.stretched, 0);
  EXPECT_GT(worst.raw, 0.1) << "the raw distance is no bound, or this test could not see that";
}

TEST(LowerBound, NeverAboveTheDistanceOnRandomGrids) {
  // On 10,000 random small grids no bound, in float or in half, is above the exact distance at any of five points.
  Excess worst;
  for (std::uint64_t number = 0; number < 10'000; ++number) {
    const SmallGrid grid = randomGrid(number);
    expectBelowDistance(grid.level.view(), number, 5, worst);
  }
  expectNoExcess(worst);
  EXPECT_GT(worst.largestCell, 4) << "bounds of some length were judged";
  EXPECT_GT(worst.largestField, 1);
}

TEST(LowerBound, NeverAboveTheDistanceOnTheSampleScenes) {
  // The same on the six sample scenes, whose surfaces are smooth, thin and far from each other.
  for (const std::string_view name : sceneNames()) {
    SCOPED_TRACE(name);
    Grid<float> level = sampleScene(*findScene(name), 48);
    makeLevel(level.view(), 0, Inside::below);
    Excess worst;
    expectBelowDistance(level.view(), 1, 2000, worst);
    expectNoExcess(worst);
  }
}

TEST(LowerBound, CellBoundIsTheDistanceOfBoxes) {
  // The cell bound is the exact distance to the nearest mixed cell, box to box, less at most its rounding (2^-20).
  for (std::uint64_t number = 0; number < 300; ++number) {
    const SmallGrid grid = randomGrid(number);
    const GridView<const float> level = grid.level.view();
    const Grid<float> bound = cellLowerBound(level);
    ASSERT_EQ(bound.size(), level.size - 1);
    const glm::ivec3 cells = bound.size();
    const auto forAll = [&](const auto& body) {
      for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
          for (int x = 0; x < cells.x; ++x) body(glm::ivec3(x, y, z));
    };
    std::vector<glm::ivec3> mixed;
    forAll([&](glm::ivec3 cell) {
      if (isMixed(level, cell)) mixed.push_back(cell);
    });
    forAll([&](glm::ivec3 cell) {
      double nearest = kBoundReach;
      for (const glm::ivec3& other : mixed) {
        const glm::ivec3 gap = glm::max(glm::abs(cell - other) - 1, glm::ivec3(0));
        nearest = std::min(nearest, glm::length(glm::dvec3(gap) * grid.scale));
      }
      const double got = bound.view()(cell.x, cell.y, cell.z);
      ASSERT_LE(got, nearest);
      ASSERT_GE(got, nearest * (1 - 0x1p-20)) << "grid " << number << ", " << mixed.size() << " mixed cells";
    });
  }
}

TEST(LowerBound, ReachesItsEndAndIsTheSameForAnyThreads) {
  // A lone sample in the end of a long grid: exact up to kBoundReach and that from there on; threads change no bit.
  Grid<float> level =
      sampleLevel({200, 5, 4}, glm::dvec3(1), [](glm::dvec3 p) { return p.x == 0 && p.y == 2 && p.z == 1 ? 1 : -1; });
  const Grid<float> bound = cellLowerBound(level.view());
  for (int x = 0; x < 199; ++x) {
    const float expected = std::min(static_cast<float>(std::max(x - 1, 0)), kBoundReach);
    EXPECT_LE(bound.view()(x, 1, 1), expected);
    EXPECT_GE(bound.view()(x, 1, 1), expected * (1 - 0x1p-20F));
  }
  const Grid<float> noise = noiseLevel({37, 29, 31}, {1, 0.3, 2}, 5);
  const Grid<float> many = cellLowerBound(noise.view());
  setThreadCount(1);
  const Grid<float> one = cellLowerBound(noise.view());
  setThreadCount(0);
  EXPECT_TRUE(std::equal(one.data(), one.data() + one.count(), many.data()));
}

TEST(LowerBound, WithoutSurfaceThereIsNoBound) {
  // Nothing mixed: every cell has the whole reach. A field that is not finite is certified as no bound at all.
  const Grid<float> outside = sampleLevel({5, 4, 3}, glm::dvec3(1), [](glm::dvec3) { return -1; });
  const Grid<float> bound = cellLowerBound(outside.view());
  for (std::size_t i = 0; i < bound.count(); ++i) EXPECT_EQ(bound.data()[i], kBoundReach * (1 - 0x1p-21F));
  Grid<float> field = sampleLevel({5, 4, 3}, glm::dvec3(1), [](glm::dvec3) { return 2; });
  EXPECT_GT(certifyField(outside.view(), field.view())(2), 1);
  field.data()[7] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_LT(certifyField(outside.view(), field.view())(2), 0);
}

TEST(LowerBound, SteepestCornerOfAFieldIsItsSlope) {
  // For u = 3 x along one axis of spacing 2 next to the surface the slope is 3/2 per voxel, and the shift the largest
  // magnitude at a mixed cell.
  Grid<float> level = sampleLevel({6, 3, 3}, {2, 1, 1}, [](glm::dvec3 p) { return p.x < 3 ? 1 : -1; });
  Grid<float> field = sampleLevel({6, 3, 3}, {2, 1, 1}, [](glm::dvec3 p) { return 1.5 * p.x; });
  const FieldBound bound = certifyField(level.view(), field.view());
  EXPECT_NEAR(bound.slope, 1.5, 1e-5);
  EXPECT_NEAR(bound.shift, 6, 1e-5);
  EXPECT_GE(bound.slope, 1.5F);
  EXPECT_GE(bound.shift, 6.0F);
}

TEST(LowerBound, HalfBelowIsTheLargestHalfBelow) {
  // Every normal half gives itself; what lies between two halves gives the lower one; no value is rounded up.
  EXPECT_EQ(halfBelow(0), 0);
  EXPECT_EQ(halfBelow(0x1p-15F), 0);
  EXPECT_EQ(floatFromHalf(halfBelow(1e30F)), 65504);
  EXPECT_EQ(floatFromHalf(0xc000), -2);
  EXPECT_EQ(floatFromHalf(1), 0x1p-24F);
  constexpr std::uint16_t kFirstNormal = 0x400, kLargestHalf = 0x7bff;
  for (std::uint16_t half = kFirstNormal; half < kLargestHalf; ++half) {
    const float value = floatFromHalf(half), next = floatFromHalf(static_cast<std::uint16_t>(half + 1));
    ASSERT_LT(value, next);
    ASSERT_EQ(halfBelow(value), half);
    ASSERT_EQ(halfBelow(std::nextafter(next, 0.0F)), half);
    ASSERT_EQ(halfFromFloat(value), half);
  }
}

}  // namespace
}  // namespace isolume::test
