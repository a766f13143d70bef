#include "tests/bench/report/voxel_sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "support/test_levels.h"

namespace isolume::bench {
namespace {

constexpr int kSize = 33, kCount = 200;
constexpr double kRadius = 10.3;
constexpr glm::dvec3 kCentre{16.2, 15.9, 16.1};

DistanceSolver solverOf(std::function<double(int, int, int)> distanceAt) {
  return {"test", "", "", [] {}, std::move(distanceAt)};
}

TEST(VoxelSample, TruthHasTheSignOfTheLevel) {
  // True distances are negative exactly at the samples inside.
  const Grid<float> level = test::ballLevel(kSize, kRadius, kCentre);
  for (const JudgedVoxel& voxel : judgedVoxels(level.view(), kCount))
    EXPECT_EQ(voxel.truth<0, level.view()(voxel.index.x, voxel.index.y, voxel.index.z)> 0);
}

TEST(VoxelSample, HalfOfTheVoxelsLieNear) {
  // Voxels drawn from around the surface lie within a cell's diagonal more than the reach.
  const Grid<float> level = test::ballLevel(kSize, kRadius, kCentre);
  const std::vector<JudgedVoxel> voxels = judgedVoxels(level.view(), kCount);
  ASSERT_EQ(voxels.size(), 2U * kCount);
  int near = 0;
  for (const JudgedVoxel& voxel : voxels) {
    if (voxel.anywhere) continue;
    ++near;
    EXPECT_LE(std::abs(voxel.truth), std::sqrt(3.0) * kNearVoxels);
  }
  EXPECT_EQ(near, kCount);
}

TEST(VoxelSample, KnownErrorsAreMeasured) {
  // A solver that is off by 1/4 everywhere has mean and maximum 1/4; one that errs at a single voxel keeps its maximum.
  const Grid<float> level = test::ballLevel(kSize, kRadius, kCentre);
  const std::vector<JudgedVoxel> voxels = judgedVoxels(level.view(), kCount);
  const auto truthAt = [&voxels](int x, int y, int z) {
    return std::find_if(voxels.begin(), voxels.end(),
                        [=](const JudgedVoxel& v) { return v.index == glm::ivec3(x, y, z); })
        ->truth;
  };
  constexpr double kOff = 0.25, kRounding = 1e-12;
  const DistanceError even =
      distanceError(voxels, solverOf([&](int x, int y, int z) { return truthAt(x, y, z) + kOff; }));
  EXPECT_NEAR(even.mean, kOff, kRounding);
  EXPECT_NEAR(even.max, kOff, kRounding);
  EXPECT_NEAR(even.meanNear, kOff, kRounding);
  EXPECT_NEAR(even.maxNear, kOff, kRounding);
  const glm::ivec3 odd = voxels.front().index;
  const DistanceError one = distanceError(voxels, solverOf([&](int x, int y, int z) {
                                            return truthAt(x, y, z) - (glm::ivec3(x, y, z) == odd ? 2.0 : 0.0);
                                          }));
  EXPECT_NEAR(one.max, 2, kRounding);
  EXPECT_LT(one.mean, kOff);
}

TEST(VoxelSample, WrongSignsAreCounted) {
  // The negated truth has the wrong sign everywhere.
  const Grid<float> level = test::ballLevel(kSize, kRadius, kCentre);
  const std::vector<JudgedVoxel> voxels = judgedVoxels(level.view(), kCount);
  const DistanceError error =
      distanceError(voxels, solverOf([&](int x, int y, int z) { return level.view()(x, y, z) > 0 ? 1.0 : -1.0; }));
  const auto clear = std::count_if(voxels.begin(), voxels.end(),
                                   [](const JudgedVoxel& v) { return std::abs(v.truth) > kTruthTolerance; });
  EXPECT_EQ(error.wrongSign, clear);
}

TEST(VoxelSample, NotANumberIsNotLost) {
  // A NaN in the result makes the mean and the maximum NaN.
  const Grid<float> level = test::ballLevel(kSize, kRadius, kCentre);
  const std::vector<JudgedVoxel> voxels = judgedVoxels(level.view(), kCount);
  const glm::ivec3 odd = voxels.front().index;
  const DistanceError error =
      distanceError(voxels, solverOf([&](int x, int y, int z) {
                      return glm::ivec3(x, y, z) == odd ? std::numeric_limits<double>::quiet_NaN() : 0.0;
                    }));
  EXPECT_TRUE(std::isnan(error.mean));
  EXPECT_TRUE(std::isnan(error.max));
}

}  // namespace
}  // namespace isolume::bench
