// How much memory openness takes beyond the level and the distance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "support/resident_peak.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/ordinates/openness_sweep.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr int kSize = 256;

class OpennessMemory : public testing::Test {
 protected:
  void SetUp() override {
    if (test::kKeepsFreedMemory) GTEST_SKIP() << "a sanitizer keeps freed memory";
    if (!test::resetPeak()) GTEST_SKIP() << "the peak of resident memory cannot be reset here";
  }
  void TearDown() override { setThreadCount(0); }
};

TEST_F(OpennessMemory, IsBelowTwoBytesPerVoxel) {
  // Of waves with feet at less than a fiftieth of the samples: 5/16 byte for the samples' marks, 5/16 for the lattice,
  // and 40 per foot, 28 for their order and 4 for the sums and for those of each of two threads, make at most 1.4; .2
  // go to feet that are kept, and .4 to the state of the rays and what the allocator keeps. The result alone, dense,
  // would be 2.
  const Grid<float> level = test::sampleLevel(glm::ivec3(kSize), glm::dvec3(1), [](glm::dvec3 p) {
    return std::sin(.02 * p.x) + std::sin(.025 * p.y) + std::cos(.015 * p.z);
  });
  setThreadCount(2);
  const Grid<float> distance = closestDistance(level.view(), {.extent = DistanceExtent::band});
  const std::size_t feet = SurfaceFeet(level.view(), distance.view()).count();
  const auto perVoxel = [&](std::size_t bytes) {
    return static_cast<double>(bytes) / static_cast<double>(level.count());
  };
  EXPECT_LT(perVoxel(feet), .02);
  EXPECT_TRUE(test::resetPeak());
  const std::size_t before = test::statusBytes("VmRSS");
  const SurfaceField openness = sweepOpenness(level.view(), distance.view(), {.ordinates = 64});
  const std::size_t peak = test::statusBytes("VmHWM");
  EXPECT_LT(perVoxel(peak - before), 2);
  EXPECT_GT(perVoxel(peak - before), .6) << "is anything measured?";
  // 3/16 byte for the bits and their counts, in rows of five words for four, and two for each number.
  EXPECT_LT(perVoxel(openness.bytes()), 3. / 16 * 5 / 4 * 1.03 + .15);
  // Some of these feet were kept and some made anew.
  const SurfaceRays kept(level.view(), distance.view(), 1, SurfaceRays::Orders::kept);
  const SurfaceField want = kept.surface().spread(opennessOf(blockedShares(kept, 64)));
  EXPECT_TRUE(std::ranges::equal(openness.numbers(), want.numbers()));
}

}  // namespace
}  // namespace isolume
