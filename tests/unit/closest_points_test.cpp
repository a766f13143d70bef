// The vector search for closest points against the careful scalar one (closest_point.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "support/plain_closest.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/closest/closest_point.h"
#include "sweep/closest/neighbour_points.h"
#include "sweep/closest/point_kernels.h"
#include "sweep/closest/surface_band.h"

namespace isolume {
namespace {

using test::noiseLevel;
using test::sampleLevel;

struct Comparison {
  std::size_t count = 0, further = 0;  // compared; further than the scalar one by more than a hundredth
  double worst = 0;                    // by how much at most
};

// Every sample of the band against what the scalar search finds from the same point and, at the corners of cells with
// surface, from all starts.
Comparison compare(GridView<const float> level, int layers) {
  OffsetField field(level);
  const BitGrid band = solveBand(level, layers, field);
  const LevelInterpolant interpolant(level, smallestSpacing(level.spacing));
  Comparison result;
  for (int z = 0; z < level.size.z; ++z)
    for (int y = 0; y < level.size.y; ++y)
      for (int x = 0; x < level.size.x; ++x) {
        if (!band.test(x, y, z)) continue;
        const glm::dvec3 found(field.at(level.index(x, y, z)));
        glm::dvec3 refined = found, seeded(0);
        refineOffset(interpolant, {x, y, z}, refined);
        double careful = glm::length(refined);
        if (seedOffset(interpolant, {x, y, z}, seeded)) careful = std::min(careful, glm::length(seeded));
        const double further = glm::length(found) - careful;
        ++result.count;
        result.further += further > .01 ? 1 : 0;
        result.worst = std::max(result.worst, further);
      }
  return result;
}

TEST(ClosestPoints, OnSmoothLevelsAreThoseOfTheScalarSearch) {
  // Where the radius of curvature is nine voxels and more, no sample is further than the careful search finds by more
  // than the height of the interpolant's own bumps, (h^2 / 8) times the sum of curvatures (ball: .03; the waves less):
  // one may hide the foot on the next. All but one in a hundred agree to a hundredth of a voxel.
  const auto waves = [](glm::dvec3 p) { return 19.2 - p.z + 2 * std::sin(.2 * p.x) * std::cos(.23 * p.y + .1 * p.z); };
  const auto ball = [](glm::dvec3 p) { return 170 - glm::dot(p - 19.3, p - 19.3); };
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, .8, 1.4)})
    for (const auto& shape : {std::function<double(glm::dvec3)>(waves), std::function<double(glm::dvec3)>(ball)}) {
      const Grid<float> level = sampleLevel({40, 41, 39}, spacing, shape);
      const Comparison result = compare(level.view(), 3);
      EXPECT_GT(result.count, 9000U);
      EXPECT_LT(result.worst, .03);
      EXPECT_LT(result.further * 100, result.count);
    }
}

TEST(ClosestPoints, OnNoiseMissFewNearerSheets) {
  // Noise has several sheets in most cells: at one sample in fifty at most does the careful search find one that is
  // nearer by more than a hundredth of a voxel, and nowhere by more than half a voxel.
  std::size_t count = 0, further = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Grid<float> level = noiseLevel({21, 18, 20}, glm::dvec3(1), seed);
    const Comparison result = compare(level.view(), 1);
    EXPECT_LT(result.worst, .5);
    count += result.count;
    further += result.further;
  }
  EXPECT_GT(count, 20000U);
  EXPECT_LT(further * 50, count);
}

TEST(ClosestPoints, LieOnTheSurfaceWhateverTheScale) {
  // Levels of 1e-30 beside 1e30, and cells that are nearly flat: every point of the band satisfies the interpolant to
  // 1e-5 of the largest level of its cell.
  Grid<float> level = noiseLevel({17, 19, 16}, glm::dvec3(1), 21);
  for (std::size_t i = 0; i < level.count(); ++i) {
    if (i % 7 == 0) level.data()[i] *= 1e-30F;
    if (i % 11 == 0) level.data()[i] *= 1e30F;
  }
  OffsetField field(level.view());
  const BitGrid band = solveBand(level.view(), 2, field);
  int checked = 0;
  for (int z = 0; z < 16; ++z)
    for (int y = 0; y < 19; ++y)
      for (int x = 0; x < 17; ++x) {
        if (!band.test(x, y, z)) continue;
        const glm::dvec3 offset(field.at(level.view().index(x, y, z)));
        ASSERT_TRUE(test::liesOnSurface(level.view(), glm::dvec3(x, y, z) + offset, 1e-5)) << x << " " << y << " " << z;
        ++checked;
      }
  EXPECT_GT(checked, 4000);
}

// Distance of a point outside to the roof z = -a |x| - b |y|, by its faces, ridges and peak.
double distanceToRoof(glm::dvec3 p, double a, double b) {
  p = {std::abs(p.x), std::abs(p.y), p.z};
  double best = glm::length(p);
  const auto onPlane = [&](double slopeX, double slopeY) {
    const glm::dvec3 normal(slopeX, slopeY, 1);
    const glm::dvec3 inPlane(slopeX != 0 ? p.x : 0, slopeY != 0 ? p.y : 0, p.z);  // of a ridge: x = 0 or y = 0
    return inPlane - normal * (glm::dot(inPlane, normal) / glm::dot(normal, normal));
  };
  for (const glm::dvec3 foot : {onPlane(a, b), onPlane(a, 0), onPlane(0, b)})
    if (foot.x >= 0 && foot.y >= 0) best = std::min(best, glm::length(p - foot));
  return best;
}

TEST(ClosestPoints, OfConvexCreasesAndPeaksAreExact) {
  // A roof whose ridges and peak lie on faces and edges of cells: its interpolant is the roof itself. Outside within
  // three voxels the distance is exact to the gain that ends a search (1e-5), how far beyond a face a point may lie
  // (2^-17) and the rounding of levels up to 40. Next to the peak a few searches end after many looks in vain: 1e-3.
  constexpr double kTolerance = 1e-5 + 0x1p-17 + 40 * 0x1p-23;
  for (const glm::dvec2 slope : {glm::dvec2(.3, .2), glm::dvec2(1, 1.4), glm::dvec2(.05, .02)}) {
    const glm::dvec3 peak(20, 19, 21.3);
    const Grid<float> level = sampleLevel({41, 40, 39}, glm::dvec3(1), [&](glm::dvec3 p) {
      const glm::dvec3 q = p - peak;
      return -q.z - slope.x * std::abs(q.x) - slope.y * std::abs(q.y);
    });
    const Grid<float> distance = closestDistance(level.view());
    int onCreases = 0, inVain = 0;
    for (int z = 0; z < 30; ++z)
      for (int y = 14; y < 25; ++y)
        for (int x = 15; x < 26; ++x) {
          const glm::dvec3 q = glm::dvec3(x, y, z) - peak;
          const double want = distanceToRoof(q, slope.x, slope.y);
          if (level.view()(x, y, z) > 0 || want > 3) continue;
          ASSERT_NEAR(distance.view()(x, y, z), want, 1e-3) << x << " " << y << " " << z;
          inVain += std::abs(distance.view()(x, y, z) - want) > kTolerance ? 1 : 0;
          const double toPlane = -level.view()(x, y, z) / std::sqrt(1 + glm::dot(slope, slope));
          onCreases += want > toPlane + 1e-3 ? 1 : 0;
        }
    EXPECT_GT(onCreases, 20);
    EXPECT_LE(inVain, 6);
  }
}

TEST(ClosestPoints, AreSoughtOneByOneInPlanesTooLargeForTheKernels) {
  // Cells around a sample are addressed by 32 bits: 57 planes of 6100^2 samples fit, of 6200^2 they do not.
  EXPECT_TRUE(PointFrame(GridView<const float>(nullptr, {6100, 6100, 3})).fits());
  EXPECT_FALSE(PointFrame(GridView<const float>(nullptr, {6200, 6200, 3})).fits());
}

TEST(ClosestPoints, AreNotTakenFromTheRowAfter) {
  // In rows of whole words the last sample has no neighbour beyond it: the first of the next row, whose bit is the next
  // one in memory and whose point would be nearer, is none.
  const Grid<float> like({64, 3, 3});
  OffsetField field(like.view());
  BitGrid set(like.size());
  set.mark(62, 1, 1);
  field.set(like.view().index(62, 1, 1), glm::vec3(5, 0, 0));
  set.mark(0, 2, 1);
  field.set(like.view().index(0, 2, 1), glm::vec3(.01F, 0, 0));
  set.mark(49, 1, 1);
  field.set(like.view().index(49, 1, 1), glm::vec3(3, 0, 0));
  BitRow wanted(1, std::uint64_t{1} << 63 | std::uint64_t{1} << 50);  // one vector of sixteen lanes
  PointBatch batch;
  appendStarts({field, set}, 1, 1, wanted, batch);
  ASSERT_EQ(batch.count, 2U);
  EXPECT_EQ(batch.sample(0), glm::ivec3(50, 1, 1));
  EXPECT_EQ(batch.point(0), glm::vec3(2, 0, 0));
  EXPECT_EQ(batch.sample(1), glm::ivec3(63, 1, 1));
  EXPECT_EQ(batch.point(1), glm::vec3(4, 0, 0));
}

}  // namespace
}  // namespace isolume
