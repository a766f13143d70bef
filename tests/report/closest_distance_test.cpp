#include "tests/bench/report/closest_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "support/test_levels.h"
#include "volumes/random.h"

namespace isolume::bench {
namespace {

using test::ballLevel;
using test::noiseLevel;
using test::sampleLevel;

constexpr glm::dvec3 kUnitSpacing{1};

TEST(ClosestDistance, PlaneIsExact) {
  // The distance to a tilted plane, which the interpolant holds exactly, is found to the tolerance from anywhere.
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, -2, 3));
  constexpr double kOffset = 7.3;
  const Grid<float> level =
      sampleLevel(glm::ivec3(24), kUnitSpacing, [&](glm::dvec3 p) { return kOffset - glm::dot(p, normal); });
  const ClosestDistance closest(level.view());
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 p = random.inBox(9, 14);  // far enough from the border for the foot to lie in the grid
    const double exact = std::abs(kOffset - glm::dot(p, normal));
    const double found = closest(p);
    // Float samples are off by up to 2^-24 of their size, here 32.
    constexpr double kRounding = 2e-6;
    EXPECT_GE(found, exact - kRounding);
    EXPECT_LE(found, exact + kTruthTolerance + kRounding);
  }
}

TEST(ClosestDistance, BallWithinInterpolationError) {
  // The distance to a ball is that of its interpolant: off by at most the sagitta of a cell's diagonal.
  constexpr double kRadius = 12.4;
  constexpr glm::dvec3 kCentre{15.8, 16.3, 16.1};
  const Grid<float> level = ballLevel(33, kRadius, kCentre);
  const ClosestDistance closest(level.view());
  // The trilinear interpolant of a function with second derivatives up to 1 / r' (two of them, at radius r') is off by
  // at most 2 / (8 r'); within the cells of the surface r' is at least the radius less a cell's diagonal.
  const double interpolation = 0.25 / (kRadius - std::sqrt(3.0));
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 p = random.inBox(0, 32);
    EXPECT_NEAR(closest(p), std::abs(glm::length(p - kCentre) - kRadius), interpolation + kTruthTolerance);
  }
}

TEST(ClosestDistance, AnisotropicSpacingCountsInSmallestSpacings) {
  // With spacing (1, 2, 4), a plane across z at 10 world units has its distance in units of 1.
  const Grid<float> level = sampleLevel({9, 9, 9}, {1, 2, 4}, [](glm::dvec3 p) { return 10.0 - p.z; });
  const ClosestDistance closest(level.view());
  EXPECT_NEAR(closest({4, 4, 0}), 10, kTruthTolerance);
  EXPECT_NEAR(closest({4, 4, 5}), 10, kTruthTolerance);
}

/// Dense sampling of the interpolant's zero set along lines of the three axes: an upper bound of the distance.
double sampledDistance(GridView<const float> level, glm::dvec3 q) {
  constexpr int kLines = 24;  // per cell and axis
  double best = std::numeric_limits<double>::infinity();
  const auto at = [&](glm::dvec3 p) {
    const glm::ivec3 low = glm::min(glm::ivec3(p), level.size - 2);
    const glm::dvec3 t = p - glm::dvec3(low);
    double sum = 0;
    for (int c = 0; c < 8; ++c) {
      const glm::ivec3 o(c & 1, (c >> 1) & 1, c >> 2);
      const glm::dvec3 w = glm::mix(1.0 - t, t, glm::dvec3(o));
      sum += w.x * w.y * w.z * level(low.x + o.x, low.y + o.y, low.z + o.z);
    }
    return sum;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i <= kLines * (level.size[u] - 1); ++i)
      for (int j = 0; j <= kLines * (level.size[v] - 1); ++j)
        for (int k = 0; k + 1 < level.size[axis]; ++k) {
          glm::dvec3 a(0), b(0);
          a[u] = b[u] = double(i) / kLines;
          a[v] = b[v] = double(j) / kLines;
          a[axis] = k;
          b[axis] = k + 1;
          const double before = at(a), after = at(b);
          if ((before > 0) == (after > 0)) continue;
          a[axis] += before / (before - after);  // the interpolant is linear along the axis
          best = std::min(best, glm::length(a - q));
        }
  }
  return best;
}

TEST(ClosestDistance, NoiseAgreesWithDenseSampling) {
  // In noise, where every cell holds surface and curvature is unbounded, it is never above a dense sampling of the
  // surface and never farther below it than the sampling is coarse.
  const Grid<float> level = noiseLevel({5, 6, 7}, kUnitSpacing, 11);
  const ClosestDistance closest(level.view());
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 q = random.inBox(-2, 8);
    const double found = closest(q), sampled = sampledDistance(level.view(), q);
    EXPECT_LE(found, sampled + kTruthTolerance);
    // Lines lie 1 / 24 apart, in the two directions across; along the axis that a surface faces most, the nearest line
    // is within half a diagonal of 1 / 24 and the surface rises over that by at most as much times the slope, sqrt(2).
    EXPECT_GE(found, sampled - 2 * std::sqrt(0.5) / 24);
  }
}

TEST(ClosestDistance, NoSurfaceIsInfinite) {
  // A grid on one side only has no surface: the distance is infinite.
  const Grid<float> level = sampleLevel(glm::ivec3(8), kUnitSpacing, [](glm::dvec3) { return -1.0; });
  EXPECT_TRUE(std::isinf(ClosestDistance(level.view())({3, 3, 3})));
}

}  // namespace
}  // namespace isolume::bench
