// Signed distance by fast sweeping: the update formula, exact cases, errors and their order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/plain_sweep.h"
#include "support/test_levels.h"
#include "sweep/occlusion_sweep.h"

namespace isolume {
namespace {

using test::ballLevel;
using test::plainUpdate;
using test::sampleLevel;

const SweepOptions kDistanceOnly{.visibility = VisibilityStorage::none};

// The upwind equation that an update solves, over the neighbours below it.
double residual(double d, glm::dvec3 neighbours, glm::dvec3 spacing) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double slope = std::max(0.0, d - neighbours[axis]) / spacing[axis];
    sum += slope * slope;
  }
  return sum - 1;
}

TEST(DistanceUpdate, OneNeighbour) {
  // A neighbour more than h nearer than the others decides alone: d = a + h.
  EXPECT_FLOAT_EQ(plainUpdate({3, 10, 10}, glm::dvec3(1)), 4);
  EXPECT_FLOAT_EQ(plainUpdate({10, 10, 3}, {1, 1, 2.5F}), 5.5F);
}

TEST(DistanceUpdate, TwoNeighbours) {
  // Two equal neighbours and a far one: d = a + h / sqrt(2).
  EXPECT_FLOAT_EQ(plainUpdate({3, 10, 3}, glm::dvec3(1)), 3 + std::sqrt(0.5F));
}

TEST(DistanceUpdate, ThreeNeighbours) {
  // Three equal neighbours: d = a + h / sqrt(3).
  EXPECT_FLOAT_EQ(plainUpdate({3, 3, 3}, glm::dvec3(1)), 3 + std::sqrt(1.0F / 3));
}

TEST(DistanceUpdate, SolvesTheUpwindEquation) {
  // For any neighbours and spacings the result satisfies sum max(0, (d - a_i) / h_i)^2 = 1.
  const Grid<float> noise = test::noiseLevel({6, 1000, 1}, glm::dvec3(1), 1);
  for (int i = 0; i < 1000; ++i) {
    const auto value = [&](int k) { return noise.view()(k, i, 0); };
    const glm::vec3 neighbours(2 + value(0), 2 + value(1), 2 + value(2));
    const bool isotropic = i % 2 == 0;
    const glm::dvec3 spacing = isotropic ? glm::dvec3(1) : glm::dvec3(1, 1.5F + value(4) / 3, 2 + value(5) / 2);
    const float d = plainUpdate(neighbours, spacing);
    EXPECT_NEAR(residual(d, neighbours, spacing), 0, 2e-6);
  }
}

TEST(Distance, OfAnAxisAlignedPlaneIsExact) {
  // In front of and behind a flat surface across an axis, sweeping gives the distance to rounding, at any spacing.
  const glm::dvec3 spacing(0.5, 1.25, 2);
  for (int axis = 0; axis < 3; ++axis) {
    const double where = 9.3 * spacing[axis];
    const auto level = sampleLevel({24, 24, 24}, spacing, [&](glm::dvec3 p) { return p[axis] - where; });
    const SweptFields fields = sweepOcclusion(level.view(), kDistanceOnly);
    for (int i = 0; i < 24; ++i) {
      glm::ivec3 p(5, 6, 7);  // deep inside, the border of the grid (the cap) is nearer than the plane
      p[axis] = i;
      const double exact = where - i * spacing[axis];
      if (exact < -3 * spacing[0]) continue;
      EXPECT_NEAR(fields.distance.view()(p.x, p.y, p.z), exact, 1e-5 * spacing[axis] * 24) << "axis " << axis;
    }
  }
}

TEST(Distance, HasTheSignOfTheData) {
  // Negative exactly where the level is positive, on noise.
  const Grid<float> level = test::noiseLevel({31, 29, 33}, glm::dvec3(1), 9);
  const SweptFields fields = sweepOcclusion(level.view(), kDistanceOnly);
  for (std::size_t i = 0; i < level.count(); ++i) {
    ASSERT_EQ(std::signbit(fields.distance.data()[i]), level.data()[i] > 0);
  }
}

TEST(Distance, WithoutASurfaceIsInfinite) {
  // An empty grid has no surface: +inf everywhere.
  const auto level = sampleLevel({9, 20, 5}, glm::dvec3(1), [](glm::dvec3) { return -1.0; });
  const SweptFields fields = sweepOcclusion(level.view(), kDistanceOnly);
  for (std::size_t i = 0; i < level.count(); ++i) {
    ASSERT_EQ(fields.distance.data()[i], std::numeric_limits<float>::infinity());
  }
}

TEST(Distance, OfAFullGridIsThatToItsCap) {
  // A solid that fills the grid ends at the border: the distance is minus that to the nearest face.
  // (Checked away from the edges of the grid: where two faces are equally near, the first-order scheme rounds the
  // ridge.)
  const int n = 21;
  const auto level = sampleLevel({n, 61, 61}, glm::dvec3(2), [](glm::dvec3) { return 1.0; });
  const SweptFields fields = sweepOcclusion(level.view(), kDistanceOnly);
  for (int i = 0; i < n; ++i) {
    EXPECT_NEAR(fields.distance.view()(i, 30, 30), -2.0 * std::min(i, n - 1 - i), 1e-5);
  }
}

TEST(Distance, PaperStartIsTheNearestCrossedEdge) {
  // With the paper's start, next to the surface the value is the smallest crossing distance along the six grid edges,
  // and no sweep changes it.
  const Grid<float> level = ballLevel(24, 7.3, glm::dvec3(11.2, 12.1, 11.7));
  const SweptFields fields =
      sweepOcclusion(level.view(), {.visibility = VisibilityStorage::none, .start = DistanceStart::paper});
  int checked = 0;
  for (int z = 1; z < 23; ++z)
    for (int y = 1; y < 23; ++y)
      for (int x = 1; x < 23; ++x) {
        const double here = level.view()(x, y, z);
        double best = 2;
        for (const glm::ivec3 e : {glm::ivec3(1, 0, 0), glm::ivec3(0, 1, 0), glm::ivec3(0, 0, 1)})
          for (const int side : {-1, 1}) {
            const double there = level.view()(x + side * e.x, y + side * e.y, z + side * e.z);
            if ((here > 0) != (there > 0)) best = std::min(best, here / (here - there));
          }
        if (best > 1) continue;
        ++checked;
        EXPECT_NEAR(std::abs(fields.distance.view()(x, y, z)), best, 1e-6);
      }
  EXPECT_GT(checked, 800);
}

struct ErrorOfBall {
  double mean = 0, max = 0;
};

// Error in units of the radius, so that refinement shows the order.
ErrorOfBall errorOfBall(int size) {
  const double radius = 0.31 * size;
  const glm::dvec3 centre(0.5 * size + 0.13, 0.5 * size - 0.21, 0.5 * size + 0.07);
  const Grid<float> level = ballLevel(size, radius, centre);
  const SweptFields fields = sweepOcclusion(level.view(), kDistanceOnly);
  ErrorOfBall error;
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const double exact = glm::length(glm::dvec3(x, y, z) - centre) - radius;
        const double off = std::abs(fields.distance.view()(x, y, z) - exact) / radius;
        error.mean += off / static_cast<double>(level.count());
        error.max = std::max(error.max, off);
      }
  return error;
}

TEST(Distance, ConvergesWithTheFirstOrder) {
  // Doubling the grid about halves the error: the observed order of the first-order scheme lies near 1, not 0 and
  // not 2.
  const ErrorOfBall coarse = errorOfBall(40);
  const ErrorOfBall middle = errorOfBall(80);
  const ErrorOfBall fine = errorOfBall(160);
  for (const double order : {std::log2(coarse.mean / middle.mean), std::log2(middle.mean / fine.mean)}) {
    EXPECT_GT(order, 0.7);
    EXPECT_LT(order, 1.3);
  }
  // The error stays near a fifth of a voxel on average (first order) and below two.
  EXPECT_LT(fine.mean * 0.31 * 160, 0.25);
  EXPECT_LT(fine.max * 0.31 * 160, 2);
  EXPECT_GT(fine.mean * 0.31 * 160, 0.05)
      << "better than first order can be: is the exact distance compared with itself?";
}

TEST(Distance, OneRoundIsAlmostTheFixedPointAndMoreRoundsReachIt) {
  // A second round changes no value by a twentieth of a voxel, and after a few rounds one more changes no bit.
  const Grid<float> level = ballLevel(48, 13, glm::dvec3(24.3, 23.1, 22.8));
  const auto after = [&](int rounds) {
    return sweepOcclusion(level.view(), {.visibility = VisibilityStorage::none, .rounds = rounds});
  };
  const SweptFields once = after(1), twice = after(2), seven = after(7), eight = after(8);
  double changed = 0;
  for (std::size_t i = 0; i < level.count(); ++i) {
    changed = std::max(changed, std::abs(static_cast<double>(once.distance.data()[i] - twice.distance.data()[i])));
    ASSERT_EQ(seven.distance.data()[i], eight.distance.data()[i]);
  }
  EXPECT_LT(changed, 0.05);
}

}  // namespace
}  // namespace isolume
