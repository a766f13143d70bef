#include "sweep/level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace isolume {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(Level, IsValueMinusIsovalueAndPositiveInside) {
  // Inside::above makes values above the isovalue positive, Inside::below those below; the isovalue itself is outside.
  std::vector<float> above{1, 2, 3, 4};
  std::vector<float> below = above;
  const LevelSummary a = makeLevel({above.data(), {4, 1, 1}}, 3, Inside::above);
  const LevelSummary b = makeLevel({below.data(), {4, 1, 1}}, 3, Inside::below);
  EXPECT_EQ(above, (std::vector<float>{-2, -1, 0, 1}));
  EXPECT_EQ(below, (std::vector<float>{2, 1, 0, -1}));
  EXPECT_EQ(a.insideCount, 1U);
  EXPECT_EQ(b.insideCount, 2U);
  EXPECT_EQ(a.finiteMin, 1);
  EXPECT_EQ(a.finiteMax, 4);
}

TEST(Level, MissingSamplesBecomeTheLowestLevelAndAreCounted) {
  // NaN and both infinities count as outside, on either side setting, and take the lowest finite level.
  for (const Inside inside : {Inside::above, Inside::below}) {
    std::vector<float> values{kNan, 5, kInf, -7, -kInf, 1};
    const LevelSummary summary = makeLevel({values.data(), {6, 1, 1}}, 0, inside);
    EXPECT_EQ(summary.replacedCount, 3U);
    const float lowest = inside == Inside::above ? -7.0F : -5.0F;
    for (const std::size_t i : {0U, 2U, 4U}) EXPECT_EQ(values[i], lowest);
    EXPECT_EQ(summary.finiteMin, -7);
    EXPECT_EQ(summary.finiteMax, 5);
  }
}

TEST(Level, MissingSamplesAreOutsideEvenIfAllOthersAreInside) {
  // With no finite sample outside, a missing one still ends the solid.
  std::vector<float> values{kNan, 5, 6};
  const LevelSummary summary = makeLevel({values.data(), {3, 1, 1}}, 0, Inside::above);
  EXPECT_LT(values[0], 0);
  EXPECT_EQ(summary.insideCount, 2U);
}

TEST(Level, NothingFiniteMeansNoSurface) {
  // A volume of NaN alone has no surface and an empty range, and its levels are finite.
  std::vector<float> values(8, kNan);
  const LevelSummary summary = makeLevel({values.data(), {2, 2, 2}}, 0, Inside::above);
  EXPECT_FALSE(summary.hasSurface());
  EXPECT_GT(summary.finiteMin, summary.finiteMax);
  for (const float level : values) EXPECT_TRUE(std::isfinite(level));
}

TEST(Level, BoundsOfTheSolidAreTight) {
  // The index bounds enclose the samples inside and no more.
  const glm::ivec3 size(9, 8, 7);
  std::vector<float> values(voxelCount(size), 0.0F);
  const GridView<float> view(values.data(), size);
  view(2, 5, 1) = 1;
  view(6, 3, 4) = 1;
  const LevelSummary summary = makeLevel(view, 0.5F, Inside::above);
  EXPECT_EQ(summary.solidMin, glm::ivec3(2, 3, 1));
  EXPECT_EQ(summary.solidMax, glm::ivec3(6, 5, 4));
  EXPECT_EQ(summary.insideCount, 2U);
}

TEST(Level, HugeValuesStayFinite) {
  // The difference of the largest floats is clamped, never infinite.
  const float huge = std::numeric_limits<float>::max();
  std::vector<float> values{huge, -huge};
  makeLevel({values.data(), {2, 1, 1}}, -huge, Inside::above);
  EXPECT_TRUE(std::isfinite(values[0]));
  EXPECT_GT(values[0], 0);
  EXPECT_TRUE(std::isfinite(values[0] - values[1]));
}

}  // namespace
}  // namespace isolume
