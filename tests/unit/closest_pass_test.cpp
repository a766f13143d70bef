// The vectorised, threaded passes of the closest-point solver against plain loops: equal bits.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstring>
#include <vector>

#include "support/plain_closest.h"
#include "support/simd_targets.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

using test::ballLevel;
using test::noiseLevel;
using test::plainClosestDistance;
using test::sampleLevel;

void expectEqualsPlain(GridView<const float> level, int band) {
  const std::vector<float> want = plainClosestDistance(level, band);
  const Grid<float> got = closestDistance(level, {.bandVoxels = band});
  EXPECT_EQ(std::memcmp(got.data(), want.data(), level.count() * sizeof(float)), 0);
}

// One inside sample in a corner region, so that most of the grid is reached by the passes alone.
Grid<float> speckLevel(glm::ivec3 size, glm::dvec3 spacing) {
  Grid<float> level = sampleLevel(size, spacing, [](glm::dvec3) { return -1.0; });
  level.view()(size.x / 3, size.y / 4, size.z / 2) = 0.7F;
  return level;
}

TEST(ClosestPasses, EqualPlainLoopsForAnySize) {
  // Rows shorter than a vector, row groups that do not fill, single planes and columns: the bits of the plain loops.
  const glm::ivec3 sizes[] = {{1, 1, 1},    {2, 1, 3},    {1, 40, 1},   {40, 1, 1},  {1, 1, 40},  {2, 2, 2},
                              {15, 16, 17}, {16, 16, 4},  {17, 33, 5},  {31, 15, 9}, {33, 47, 6}, {64, 3, 2},
                              {3, 64, 30},  {48, 48, 48}, {100, 20, 7}, {29, 31, 37}};
  for (const glm::ivec3& size : sizes) {
    SCOPED_TRACE(testing::Message() << size.x << "x" << size.y << "x" << size.z);
    expectEqualsPlain(noiseLevel(size, glm::dvec3(1), 7).view(), 0);
    expectEqualsPlain(speckLevel(size, {1, 1.5, 0.8}).view(), 1);
  }
}

TEST(ClosestPasses, EqualPlainLoopsOnEveryInstructionSet) {
  // Every SIMD target that this machine can run gives the bits of the plain loops.
  const Grid<float> speck = speckLevel({53, 38, 21}, {1, 1.25, 2});
  const Grid<float> ball = ballLevel(40, 11, glm::dvec3(17, 20, 22));
  const int tried = test::onEverySimdTarget([&] {
    expectEqualsPlain(speck.view(), 2);
    expectEqualsPlain(ball.view(), 1);
  });
  EXPECT_GE(tried, 1);
}

TEST(ClosestPasses, ThreadsDoNotChangeABit) {
  // One, two and seven threads give the same distance, band included.
  const Grid<float> level = noiseLevel({70, 90, 50}, glm::dvec3(1), 3);
  const Grid<float> speck = speckLevel({70, 90, 50}, {1, 2, 1});
  std::vector<Grid<float>> noise, far;
  for (const int threads : {1, 2, 7}) {
    setThreadCount(threads);
    noise.push_back(closestDistance(level.view()));
    far.push_back(closestDistance(speck.view()));
  }
  setThreadCount(0);
  for (std::size_t i = 1; i < noise.size(); ++i) {
    EXPECT_EQ(std::memcmp(noise[i].data(), noise[0].data(), level.count() * sizeof(float)), 0);
    EXPECT_EQ(std::memcmp(far[i].data(), far[0].data(), level.count() * sizeof(float)), 0);
  }
}

TEST(ClosestPasses, ASecondRoundChangesNextToNothing) {
  // A second round never lengthens a distance, and shortens none by more than an eighth of a voxel nor the mean by
  // more than 1e-4 of one (measured: .046 and 2e-5: one sample in a few thousand hears of its point late).
  const Grid<float> level = sampleLevel(glm::ivec3(64), glm::dvec3(1), [](glm::dvec3 p) {
    const glm::dvec3 q = p - glm::dvec3(32.3, 31.1, 33.2);
    const glm::dvec3 axis(.36, .48, .8);
    const double height = glm::dot(q, axis);
    return 7 - std::hypot(glm::length(q - height * axis) - 17, height);
  });
  const Grid<float> once = closestDistance(level.view());
  const std::vector<float> twice = plainClosestDistance(level.view(), kWholeBandVoxels, 2);
  double largest = 0, sum = 0;
  for (std::size_t i = 0; i < level.count(); ++i) {
    const double change = std::abs(once.data()[i]) - std::abs(twice[i]);
    ASSERT_GE(change, 0);
    largest = std::max(largest, change);
    sum += change;
  }
  EXPECT_LT(largest, 0.125);
  EXPECT_LT(sum / static_cast<double>(level.count()), 1e-4);
}

}  // namespace
}  // namespace isolume
