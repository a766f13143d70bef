#include "sweep/ordinates/ray_points.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "ordinates/random_feet.h"
#include "support/test_levels.h"
#include "sweep/near_sets.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr glm::dvec3 kSpacing(1, 2, 0.5);

SolidLattice latticeOf(glm::ivec3 size, int refinement) {
  const Grid<float> level = test::noiseLevel(size, kSpacing, 1);
  return makeSolidLattice(level.view(), insideSamples(level.view()), refinement);
}

TEST(RayPoints, HoldEachFootOnceInTheGroupOfItsLayer) {
  // Each foot stands once, in the group of the layer at or below its point; the point is the foot in points
  // of the lattice.
  test::RandomNumbers numbers(3);
  for (const int refinement : {1, 2}) {
    const SolidLattice lattice = latticeOf({9, 5, 7}, refinement);
    const std::vector<SurfaceFoot> feet = test::randomFeet({9, 5, 7}, 2000, numbers);
    RayPoints points(feet.size());
    for (int axis = 0; axis < 3; ++axis) {
      points.sort(test::chunksOf(feet), lattice, kSpacing, axis);
      const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
      ASSERT_EQ(axes.layer, axis);
      std::vector<int> seen(feet.size());
      std::size_t at = 0;
      EXPECT_EQ(points.begin(-1), 0U);
      EXPECT_EQ(points.begin(lattice.size[axis]), feet.size());
      for (int layer = -1; layer < lattice.size[axis]; ++layer) {
        for (; at < points.begin(layer + 1); ++at) {
          const SurfaceFoot& foot = feet[points.foot()[at]];
          ++seen[points.foot()[at]];
          const glm::dvec3 want = glm::dvec3(foot.position) * static_cast<double>(refinement);
          const glm::dvec3 got(points.bit()[at], points.row()[at], points.layer()[at]);
          constexpr double kRounding = 1e-5;
          ASSERT_NEAR(got.x, want[axes.bit], kRounding);
          ASSERT_NEAR(got.y, want[axes.row], kRounding);
          ASSERT_NEAR(got.z, want[axes.layer], kRounding);
          ASSERT_EQ(points.normalBit()[at], foot.normal[axes.bit]);
          ASSERT_EQ(points.normalRow()[at], foot.normal[axes.row]);
          ASSERT_EQ(points.normalLayer()[at], foot.normal[axes.layer]);
          if (layer >= 0) {
            ASSERT_GE(got.z, layer);
          }
          if (layer + 1 < lattice.size[axis]) {
            ASSERT_LT(got.z, layer + 1);
          }
        }
      }
      EXPECT_EQ(seen, std::vector<int>(feet.size(), 1));
    }
  }
}

TEST(RayPoints, OrderDoesNotDependOnThreads) {
  // One and four threads give the same order, over several chunks of 32768.
  test::RandomNumbers numbers(4);
  const SolidLattice lattice = latticeOf({12, 11, 10}, 2);
  const std::vector<SurfaceFoot> feet = test::randomFeet({12, 11, 10}, 100000, numbers);
  RayPoints one(feet.size()), four(feet.size());
  setThreadCount(1);
  one.sort(test::chunksOf(feet), lattice, kSpacing, 1);
  setThreadCount(4);
  four.sort(test::chunksOf(feet), lattice, kSpacing, 1);
  setThreadCount(0);
  EXPECT_EQ(std::memcmp(one.foot(), four.foot(), feet.size() * sizeof(std::uint32_t)), 0);
  EXPECT_EQ(std::memcmp(one.bit(), four.bit(), feet.size() * sizeof(float)), 0);
}

}  // namespace
}  // namespace isolume
