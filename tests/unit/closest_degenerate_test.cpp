// The closest-point solver on input that breaks solvers: no surface, caps, plateaus, thin sheets, extreme values.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"

namespace isolume {
namespace {

using test::noiseLevel;
using test::sampleLevel;

TEST(ClosestDegenerate, WithoutASurfaceIsInfinite) {
  // An empty grid, and one at exactly 0 everywhere (0 is outside), have no surface: +inf.
  for (const double value : {-1.0, 0.0}) {
    const auto level = sampleLevel({9, 20, 5}, glm::dvec3(1), [&](glm::dvec3) { return value; });
    const Grid<float> distance = closestDistance(level.view());
    for (std::size_t i = 0; i < level.count(); ++i)
      ASSERT_EQ(distance.data()[i], std::numeric_limits<float>::infinity());
  }
}

TEST(ClosestDegenerate, AFullGridHasItsCap) {
  // A solid that fills the grid ends at the border: exactly minus the distance to the nearest face, at any sample.
  const glm::ivec3 n(21, 13, 18);
  const glm::dvec3 h(2, 3, .5);
  const auto level = sampleLevel(n, h, [](glm::dvec3) { return 1.0; });
  const Grid<float> distance = closestDistance(level.view());
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x) {
        const glm::dvec3 toFace = glm::dvec3(glm::min(glm::ivec3(x, y, z), n - 1 - glm::ivec3(x, y, z))) * h;
        ASSERT_FLOAT_EQ(distance.view()(x, y, z), static_cast<float>(-std::min({toFace.x, toFace.y, toFace.z})));
        ASSERT_TRUE(std::signbit(distance.view()(x, y, z)));
      }
}

TEST(ClosestDegenerate, ACapIsSurfaceForBothSides) {
  // A slab cut by the border x = 0: inside samples there are at 0; an outside sample on that face sees the slab's edge.
  const auto level = sampleLevel({12, 12, 12}, glm::dvec3(1), [](glm::dvec3 p) { return 5.25 - p.y; });
  const Grid<float> distance = closestDistance(level.view());
  EXPECT_EQ(distance.view()(0, 3, 6), 0);
  EXPECT_NEAR(distance.view()(0, 8, 6), 2.75, 1e-6);
  EXPECT_NEAR(distance.view()(2, 3, 6), -2, 1e-6);
  EXPECT_NEAR(distance.view()(6, 4, 6), -1.25, 1e-6);
}

TEST(ClosestDegenerate, ALevelOfZeroIsOutsideAndOnTheSurfaceOnlyNextToTheSolid) {
  // A plateau at exactly 0 around a block: distance 0 at the plateau's samples next to the block, counted from there.
  const auto level = sampleLevel({20, 20, 20}, glm::dvec3(1), [](glm::dvec3 p) {
    const bool solid = p.x >= 8 && p.x <= 11 && p.y >= 8 && p.y <= 11 && p.z >= 8 && p.z <= 11;
    return solid ? 3.0 : 0.0;
  });
  const Grid<float> distance = closestDistance(level.view());
  EXPECT_EQ(distance.view()(7, 9, 9), 0);
  EXPECT_FALSE(std::signbit(distance.view()(7, 9, 9)));
  EXPECT_FLOAT_EQ(distance.view()(4, 9, 9), 3);
  EXPECT_FLOAT_EQ(distance.view()(9, 9, 9), -2);
  EXPECT_FLOAT_EQ(distance.view()(10, 15, 9), 3);
}

TEST(ClosestDegenerate, ASheetThinnerThanAVoxelIsSeenFromBothSides) {
  // One plane of samples inside: both faces of the sheet, a third of a voxel from it, are found.
  const auto level = sampleLevel({16, 16, 16}, glm::dvec3(1), [](glm::dvec3 p) { return p.z == 8 ? .5 : -1.0; });
  const Grid<float> distance = closestDistance(level.view());
  EXPECT_NEAR(distance.view()(7, 7, 8), -1.0 / 3, 1e-6);
  EXPECT_NEAR(distance.view()(7, 7, 9), 2.0 / 3, 1e-6);
  EXPECT_NEAR(distance.view()(7, 7, 3), 5 - 1.0 / 3, 1e-5);
}

TEST(ClosestDegenerate, TheScaleOfTheLevelDoesNotMatter) {
  // Levels times a power of two, from denormals to near the largest float: the same bits.
  const Grid<float> noise = noiseLevel({15, 12, 13}, glm::dvec3(1), 4);
  const Grid<float> want = closestDistance(noise.view());
  for (const int exponent : {-110, -40, 40, 120}) {
    Grid<float> scaled(noise.size());
    for (std::size_t i = 0; i < noise.count(); ++i) scaled.data()[i] = std::ldexp(noise.data()[i], exponent);
    const Grid<float> got = closestDistance(scaled.view());
    EXPECT_EQ(std::memcmp(got.data(), want.data(), noise.count() * sizeof(float)), 0) << exponent;
  }
  Grid<float> denormal = sampleLevel({8, 8, 8}, glm::dvec3(1), [](glm::dvec3) { return 0.0; });
  for (std::size_t i = 0; i < denormal.count(); ++i)
    denormal.data()[i] = std::copysign(std::numeric_limits<float>::denorm_min(), i % 8 < 4 ? 1.0F : -1.0F);
  EXPECT_FLOAT_EQ(closestDistance(denormal.view()).view()(6, 4, 4), 2.5F);
}

TEST(ClosestDegenerate, AnySpacing) {
  // A plane across z at spacings 1:1:1000, tiny and large: exact to rounding, in world units.
  for (const glm::dvec3 h :
       {glm::dvec3(1, 1, 1000), glm::dvec3(1000, 1, 1), glm::dvec3(1e-6), glm::dvec3(1e6, 2e6, 1e6)}) {
    const auto level = sampleLevel({10, 10, 10}, h, [&](glm::dvec3 p) { return p.z / h.z - 4.4; });
    const Grid<float> distance = closestDistance(level.view());
    for (int z = 0; z < 5; ++z)
      for (const int x : {0, 5}) EXPECT_NEAR(distance.view()(x, 5, z) / h.z, 4.4 - z, 1e-5);
  }
}

TEST(ClosestDegenerate, TinyGrids) {
  // Rows and columns of one sample: every sample lies on the border, so inside ones are at 0 and outside ones see the
  // nearest crossing.
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 size(1);
    size[axis] = 9;
    Grid<float> level(size);
    for (int i = 0; i < 9; ++i) level.data()[i] = static_cast<float>(i - 4.25);
    const Grid<float> distance = closestDistance(level.view());
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(distance.data()[i], i > 4 ? 0 : 4.25 - i, 1e-6) << axis;
  }
  Grid<float> two({2, 2, 2});
  for (int i = 0; i < 8; ++i) two.data()[i] = i == 0 ? 1.0F : -1.0F;
  const Grid<float> distance = closestDistance(two.view());
  EXPECT_EQ(distance.data()[0], 0);
  EXPECT_NEAR(distance.data()[1], .5, 1e-6);
  // From the far corner: on the diagonal f(t, t, t) = 2 (1 - t)^3 - 1 is 0 at t = 1 - (1/2)^(1/3).
  EXPECT_NEAR(distance.data()[7], std::sqrt(3) * std::cbrt(.5), 1e-5);
}

}  // namespace
}  // namespace isolume
