// The band extent of the closest-point solver: the full solution near the surface, a lower bound beyond.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <limits>
#include <vector>

#include "support/plain_closest.h"
#include "support/simd_targets.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/closest/surface_band.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

using test::noiseLevel;
using test::sampleLevel;

// A ball that the border cuts, so that it has a cap.
Grid<float> cutBall(glm::ivec3 size, glm::dvec3 spacing) {
  const glm::dvec3 centre = glm::dvec3(size) * glm::dvec3(.1, .45, .52);
  return sampleLevel(size, spacing, [=](glm::dvec3 p) { return 7.3 - glm::length(p / spacing - centre); });
}

// Inside random noise everything is near the surface; a few specks in the open have a far.
Grid<float> specks(glm::ivec3 size, glm::dvec3 spacing) {
  Grid<float> level = noiseLevel(size, spacing, 6);
  for (std::size_t i = 0; i < level.count(); ++i) level.data()[i] -= .995F;
  return level;
}

TEST(ClosestExtent, TheBandIsTheFullSolutionAndALimitBeyond) {
  // For any k and spacing: samples of the band have the bits of the full solution, all others k + 1 smallest spacings
  // with the sign of their side, which the full solution does not fall short of but by the rounding of carried offsets.
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1.5, .6, 2), glm::dvec3(1, 1, 1000)})
    for (const int k : {0, 1, 3, 5})
      for (const bool ball : {true, false}) {
        const glm::ivec3 size(41, 38, 36);
        const Grid<float> level = ball ? cutBall(size, spacing) : specks(size, spacing);
        const Grid<float> full = closestDistance(level.view(), {.bandVoxels = k});
        const Grid<float> band = closestDistance(level.view(), {.extent = DistanceExtent::band, .bandVoxels = k});
        const auto limit = static_cast<float>((k + 1) * smallestSpacing(spacing));
        OffsetField field(level.view());
        const BitGrid solved = solveBand(level.view(), k, field);
        std::size_t near = 0, far = 0;
        for (int z = 0; z < size.z; ++z)
          for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
              const float got = band.view()(x, y, z), whole = full.view()(x, y, z);
              ASSERT_EQ(std::signbit(got), level.view()(x, y, z) > 0);
              if (solved.test(x, y, z)) {
                ASSERT_EQ(got, whole) << "k " << k << " at " << x << " " << y << " " << z;
                ++near;
              } else {
                ASSERT_EQ(std::abs(got), limit);
                ASSERT_GE(std::abs(whole), limit * (1 - 1e-5F));
                ++far;
              }
            }
        EXPECT_GT(near, 100U);
        EXPECT_GT(far, 100U);
      }
}

TEST(ClosestExtent, BeyondTheBandTheLimitIsNotAboveTheTrueDistance) {
  // On specks and a cut ball, against points strewn on 3 x 3 lines per axis and cell: a sample that is not in the band
  // has no point of the surface nearer than the limit. Strewn points are no nearer than the surface itself.
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 2, .7)})
    for (const bool ball : {true, false}) {
      const glm::ivec3 size(24, 22, 23);
      const Grid<float> level = ball ? cutBall(size, spacing) : specks(size, spacing);
      const std::vector<double> truth = test::strewnDistance(level.view(), 3);
      for (const int k : {1, 3}) {
        const double limit = (k + 1) * smallestSpacing(spacing);
        const Grid<float> band = closestDistance(level.view(), {.extent = DistanceExtent::band, .bandVoxels = k});
        OffsetField field(level.view());
        const BitGrid solved = solveBand(level.view(), k, field);
        std::size_t beyond = 0;
        for (int z = 0; z < size.z; ++z)
          for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
              if (solved.test(x, y, z)) continue;
              ASSERT_NEAR(std::abs(band.view()(x, y, z)), limit, limit * 1e-6);
              ASSERT_GE(truth[level.view().index(x, y, z)], limit) << "k " << k << " at " << x << " " << y << " " << z;
              ++beyond;
            }
        EXPECT_GT(beyond, 50U);
      }
    }
}

TEST(ClosestExtent, BandsHoldAllThatIsNearACellWithSurface) {
  // One sample inside: the eight cells around it hold the surface. The band of k layers has all samples a, b and c
  // steps from the nearest corner of these with a^2 + b^2 + c^2 < (k + 1)^2, and none more than k steps along an axis.
  constexpr int kCentre = 10;
  const Grid<float> speck = sampleLevel(glm::ivec3(2 * kCentre + 1), glm::dvec3(1),
                                        [](glm::dvec3 p) { return p == glm::dvec3(kCentre) ? 1.0 : -1.0; });
  for (int k = 0; k <= 8; ++k) {
    OffsetField field(speck.view());
    const BitGrid band = solveBand(speck.view(), k, field);
    for (int z = 0; z <= 2 * kCentre; ++z)
      for (int y = 0; y <= 2 * kCentre; ++y)
        for (int x = 0; x <= 2 * kCentre; ++x) {
          const glm::ivec3 steps = glm::max(glm::abs(glm::ivec3(x, y, z) - kCentre) - 1, glm::ivec3(0));
          const int squared = steps.x * steps.x + steps.y * steps.y + steps.z * steps.z;
          const bool has = band.test(x, y, z);
          ASSERT_TRUE(has || squared >= (k + 1) * (k + 1)) << "k " << k << " at " << x << " " << y << " " << z;
          ASSERT_FALSE(has && std::max({steps.x, steps.y, steps.z}) > k) << "k " << k << " at " << x << " " << y;
        }
  }
}

TEST(ClosestExtent, OfAFullAndAnEmptyGrid) {
  // A grid that is all inside is cut off at the limit from its cap inwards; an empty one is infinite.
  const Grid<float> inside = sampleLevel({20, 20, 20}, glm::dvec3(2), [](glm::dvec3) { return 1.0; });
  const Grid<float> cap = closestDistance(inside.view(), {.extent = DistanceExtent::band, .bandVoxels = 2});
  EXPECT_EQ(cap.view()(0, 7, 9), 0);
  EXPECT_EQ(cap.view()(2, 7, 9), -4);
  EXPECT_EQ(cap.view()(10, 10, 10), -6);
  const Grid<float> outside = sampleLevel({20, 20, 20}, glm::dvec3(2), [](glm::dvec3) { return -1.0; });
  const Grid<float> none = closestDistance(outside.view(), {.extent = DistanceExtent::band});
  for (std::size_t i = 0; i < none.count(); ++i) ASSERT_EQ(none.data()[i], std::numeric_limits<float>::infinity());
}

TEST(ClosestExtent, ThreadsAndInstructionSetsDoNotChangeABit) {
  // Full and band, on every SIMD target of this machine and with one, two and five threads: the bits of the first.
  const Grid<float> noise = noiseLevel({37, 30, 29}, {1, 1.3, .8}, 12);
  const Grid<float> ball = cutBall({60, 41, 37}, glm::dvec3(1));
  for (const auto extent : {DistanceExtent::full, DistanceExtent::band})
    for (const Grid<float>* level : {&noise, &ball}) {
      const Grid<float> want = closestDistance(level->view(), {.extent = extent});
      const auto expectSame = [&] {
        const Grid<float> got = closestDistance(level->view(), {.extent = extent});
        EXPECT_EQ(std::memcmp(got.data(), want.data(), want.count() * sizeof(float)), 0);
      };
      EXPECT_GE(test::onEverySimdTarget(expectSame), 1);
      for (const int threads : {1, 2, 5}) {
        setThreadCount(threads);
        expectSame();
      }
      setThreadCount(0);
    }
}

}  // namespace
}  // namespace isolume
