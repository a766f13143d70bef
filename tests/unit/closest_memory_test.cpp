// How much memory the closest-point solver holds at its peak.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "support/resident_peak.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// Bytes per voxel that the distance takes at its peak, with itself and without the level.
double peakPerVoxel(GridView<const float> level) {
  setThreadCount(2);
  // Buffers of threads stay; how large one grows depends on the blocks that its thread gets.
  for (int i = 0; i < 3; ++i) closestDistance(level);
  const bool reset = test::resetPeak();
  EXPECT_TRUE(reset);
  const std::size_t before = test::statusBytes("VmRSS");
  const Grid<float> distance = closestDistance(level);
  const std::size_t peak = test::statusBytes("VmHWM");
  setThreadCount(0);
  return static_cast<double>(peak - before) / static_cast<double>(level.count());
}

class ClosestMemory : public testing::Test {
 protected:
  void SetUp() override {
    if (test::kKeepsFreedMemory) GTEST_SKIP() << "a sanitizer keeps freed memory";
    if (!test::resetPeak()) GTEST_SKIP() << "the peak of resident memory cannot be reset here";
  }
};

constexpr int kSize = 192;

TEST_F(ClosestMemory, OfABallIsBelowTwelveBytesPerVoxel) {
  // Twelve bytes are three components everywhere; of planes below and above the band, with what lies about them in the
  // same huge pages, a third of them (measured: 10.1).
  const Grid<float> ball = test::ballLevel(kSize, .31 * kSize, glm::dvec3(.5 * kSize));
  const double peak = peakPerVoxel(ball.view());
  EXPECT_LT(peak, 10.5);
  EXPECT_GT(peak, 4.0) << "is anything measured?";
}

TEST_F(ClosestMemory, OfASurfaceThroughTheWholeGridIsTwelveBytesAndAFewBits) {
  // Waves that reach the lowest plane: twelve bytes, three bits while the band is made, one in the passes, and planes
  // of scratch (18 floats per sample of a plane, .38 byte per voxel at this size).
  const Grid<float> waves = test::sampleLevel(glm::ivec3(kSize), glm::dvec3(1), [](glm::dvec3 p) {
    return std::sin(.2 * p.x) + std::sin(.21 * p.y) + std::cos(.19 * p.z);
  });
  EXPECT_LT(peakPerVoxel(waves.view()), 12 + 3.0 / 8 + .38);
}

}  // namespace
}  // namespace isolume
