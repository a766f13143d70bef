// The skewed, threaded, vectorised sweep against plain loops: equal bits, whatever the size, the lanes or the threads.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstring>
#include <vector>

#include "support/plain_light.h"
#include "support/plain_sweep.h"
#include "support/simd_targets.h"
#include "support/test_levels.h"
#include "sweep/godunov/sweep_tile.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

using test::ballLevel;
using test::noiseLevel;
using test::plainSweep;

template <class T>
bool sameBits(const T* a, const T* b, std::size_t count) {
  return std::memcmp(a, b, count * sizeof(T)) == 0;
}

void expectEqualsPlain(GridView<const float> level, int rounds = 1, DistanceStart start = DistanceStart::better,
                       float opacity = 1) {
  const std::vector<float> want = plainSweep(level, rounds, start);
  SweepOptions options{.visibility = VisibilityStorage::float32, .opacity = opacity, .start = start, .rounds = rounds};
  const SweptFields got = sweepOcclusion(level, options);
  options.visibility = VisibilityStorage::none;
  const SweptFields alone = sweepOcclusion(level, options);
  EXPECT_TRUE(sameBits(got.distance.data(), want.data(), level.count()));
  EXPECT_TRUE(sameBits(alone.distance.data(), want.data(), level.count()));
  for (std::size_t s = 0; s < kOctants.size(); ++s) {
    const std::vector<float> light = test::plainLight(got.distance.view(), kOctants[s].sweep, opacity);
    EXPECT_TRUE(sameBits(got.visibility.octants[s].data(), light.data(), level.count()))
        << "octant " << kOctants[s].name;
  }
}

TEST(SweepLayout, EqualsPlainLoopsForAnySize) {
  // Rows shorter than a vector, blocks and layers that do not fill, single voxels: the same bits as the plain loops.
  const glm::ivec3 sizes[] = {{1, 1, 1},    {2, 1, 3},   {1, 40, 1},   {40, 1, 1},   {1, 1, 40},
                              {15, 16, 17}, {16, 16, 4}, {17, 33, 5},  {31, 15, 9},  {33, 47, 6},
                              {64, 3, 2},   {3, 64, 30}, {48, 48, 48}, {100, 20, 7}, {29, 31, 37}};
  for (const glm::ivec3& size : sizes) {
    SCOPED_TRACE(testing::Message() << size.x << "x" << size.y << "x" << size.z);
    expectEqualsPlain(noiseLevel(size, glm::dvec3(1), 7).view());
  }
}

TEST(SweepLayout, EqualsPlainLoopsOnPlateaus) {
  // Samples exactly at the isovalue, and edges crossed equally far on both sides.
  Grid<float> level = noiseLevel({41, 22, 19}, {1, 1, 1.5}, 23);
  for (std::size_t i = 0; i < level.count(); ++i) {
    float& value = level.data()[i];
    value = value > 0.4F ? 1.0F : value > 0.2F ? 0.0F : -1.0F;
  }
  expectEqualsPlain(level.view());
  expectEqualsPlain(level.view(), 3);
}

TEST(SweepLayout, EqualsPlainLoopsOnSparseSurfacesAndAnySpacing) {
  // Long empty runs, where unset values must spread correctly, at isotropic and anisotropic spacings, and more rounds.
  const glm::dvec3 spacings[] = {{1, 1, 1}, {0.957, 0.957, 1.5}, {3, 1, 2}, {1e-6, 2e-6, 1e-6}, {700, 700, 1234}};
  for (const glm::dvec3& spacing : spacings) {
    SCOPED_TRACE(testing::Message() << spacing.x << " " << spacing.y << " " << spacing.z);
    Grid<float> level({37, 41, 29}, spacing);
    const Grid<float> ball = ballLevel(48, 7, glm::dvec3(22, 15, 12));
    for (int z = 0; z < 29; ++z)
      for (int y = 0; y < 41; ++y)
        for (int x = 0; x < 37; ++x) level.view()(x, y, z) = ball.view()(x, y, z);
    expectEqualsPlain(level.view());
    expectEqualsPlain(level.view(), 2);
    expectEqualsPlain(level.view(), 1, DistanceStart::paper);
  }
}

TEST(SweepLayout, EqualsPlainLoopsOnEveryInstructionSet) {
  // Every SIMD target that this machine can run gives the bits of the plain loops, of a translucent solid too.
  const Grid<float> noise = noiseLevel({53, 38, 21}, {1, 1.25, 2}, 11);
  const Grid<float> ball = ballLevel(40, 11, glm::dvec3(17, 20, 22));
  const int tried = test::onEverySimdTarget([&] {
    for (const DistanceStart start : {DistanceStart::paper, DistanceStart::better}) {
      expectEqualsPlain(noise.view(), 1, start);
      expectEqualsPlain(ball.view(), 1, start);
    }
    expectEqualsPlain(noise.view(), 1, DistanceStart::better, 0.4F);
    expectEqualsPlain(ball.view(), 1, DistanceStart::better, 0.4F);
  });
  EXPECT_GE(tried, 1);
}

TEST(SweepLayout, ThreadsDoNotChangeABit) {
  // One, two and seven threads give the same distance and the same octants.
  const Grid<float> level = noiseLevel({70, 90, 50}, glm::dvec3(1), 3);
  std::vector<SweptFields> results;
  for (const int threads : {1, 2, 7}) {
    setThreadCount(threads);
    results.push_back(sweepOcclusion(level.view()));
  }
  setThreadCount(0);
  for (std::size_t i = 1; i < results.size(); ++i) {
    EXPECT_TRUE(sameBits(results[i].distance.data(), results[0].distance.data(), level.count()));
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_TRUE(
          sameBits(results[i].visibility.packed[k].data(), results[0].visibility.packed[k].data(), level.count()));
    }
  }
}

}  // namespace
}  // namespace isolume
