#include "sweep/ordinates/translucency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ordinates/swept_openness.h"
#include "ordinates/swept_scene.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/ordinates/openness_sweep.h"
#include "sweep/ordinates/sky_ordinates.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

using test::SweptScene;

constexpr int kOrdinates = 512;

Translucency translucencyOf(const SweptScene& scene, double freePath) {
  return sweepTranslucency(scene.rays, scene.distance.view(), uniformSky(kOrdinates), freePath);
}

// Means over the feet, at their positions.
double meanAt(const SweptScene& scene, const SweptLight& light) {
  double sum = 0;
  for (const SurfaceFoot& foot : scene.feet()) sum += test::lightAt(light, glm::dvec3(foot.position));
  return sum / static_cast<double>(scene.feet().size());
}
struct Extremes {
  double least = 1e30, largest = 0;
};
Extremes extremesAt(const SweptScene& scene, const SweptLight& light) {
  Extremes found;
  for (const SurfaceFoot& foot : scene.feet()) {
    const double value = test::lightAt(light, glm::dvec3(foot.position));
    found = {std::min(found.least, value), std::max(found.largest, value)};
  }
  return found;
}

TEST(Translucency, OpacityIsThatOfAVoxel) {
  // Over one voxel T is 1 - opacity, from nearly clear to nearly opaque.
  for (const double opacity : {1e-9, 0.01, 0.5, 0.999})
    for (const double spacing : {0.001, 1.0, 7.0})
      EXPECT_NEAR(std::expm1(-spacing / meanFreePath(opacity, spacing)), -opacity, 1e-12 * opacity);
}

constexpr glm::dvec3 kCentre(20.3, 19.8, 20.1);
SweptScene ball(double radius, glm::dvec3 spacing = glm::dvec3(1)) {
  return SweptScene(glm::ivec3(41), spacing, 1,
                    [=](glm::dvec3 p) { return radius - glm::length(p - kCentre * spacing); });
}

TEST(Translucency, ThicknessOfABall) {
  // From a point of a ball the chord at an angle whose cosine is c has 2 r c; weighed by c its mean is 4 r / 3. Rays
  // are too short by .2 / c voxels (carried_rays.h), by .4 at most on the mean weighed by c: between 0 and .4 voxels
  // (measured: .26), and at each foot to one voxel, whatever the spacing.
  for (const double radius : {6.0, 14.0})
    for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(0.5, 0.7, 0.6)}) {
      const double world = radius * spacing.x, voxel = (spacing.x + spacing.y + spacing.z) / 3;
      const SweptScene scene = ball(world, spacing);
      const SweptLight thickness = translucencyOf(scene, 1).thickness;
      const double want = 4 * world / 3, mean = meanAt(scene, thickness);
      EXPECT_LT(mean, want) << radius;
      EXPECT_GT(mean, want - 0.4 * voxel) << radius;
      const Extremes found = extremesAt(scene, thickness);
      EXPECT_GT(found.least, want - voxel) << radius;
      EXPECT_LT(found.largest, want + voxel) << radius;
    }
}

TEST(Translucency, LightThroughABall) {
  // E / pi = 1 + 2 integral of c exp(-a c) dc over [0, 1] with a = 2 r / mean free path, 1 + 2 (1 - (1 + a) exp(-a)) /
  // a^2. To .01 on the mean and .03 at each foot.
  const SweptScene scene = ball(14);
  for (const double freePath : {2.0, 10.0, 40.0}) {
    const double a = 2 * 14 / freePath, want = 1 + 2 * (1 - (1 + a) * std::exp(-a)) / (a * a);
    const SweptLight light = translucencyOf(scene, freePath).light;
    EXPECT_NEAR(meanAt(scene, light), want, 0.01) << freePath;
    const Extremes found = extremesAt(scene, light);
    EXPECT_NEAR(found.least, want, 0.03) << freePath;
    EXPECT_NEAR(found.largest, want, 0.03) << freePath;
  }
}

TEST(Translucency, LightThroughASlab) {
  // In the middle of a wide slab of thickness d, far from where the border cuts it: 1 + 2 integral of c exp(-d / (f c))
  // dc over [0, 1] with the mean free path f. To .02, on slabs across each axis, with faces on samples and between.
  constexpr int kSize = 49, kMiddle = 24, kSteps = 100000;
  for (int axis = 0; axis < 3; ++axis)
    for (const double half : {2.0, 3.3}) {
      glm::ivec3 size(kSize);
      size[axis] = 15;
      const SweptScene scene(size, glm::dvec3(1), 1, [=](glm::dvec3 p) { return half - std::abs(p[axis] - 7); });
      for (const double freePath : {2.0, 8.0}) {
        double want = 1;
        for (int i = 0; i < kSteps; ++i) {
          const double c = (i + 0.5) / kSteps;
          want += 2 * c * std::exp(-2 * half / (freePath * c)) / kSteps;
        }
        glm::dvec3 at(kMiddle);
        for (const double side : {-half, half}) {
          at[axis] = 7 + side;
          const double got = test::lightAt(translucencyOf(scene, freePath).light, at);
          EXPECT_NEAR(got, want, 0.02) << "axis " << axis << " half " << half << " free path " << freePath;
        }
      }
    }
}

TEST(Translucency, WhereNothingIsHeldBackTheWholeSkyCounts) {
  // Without opacity every foot sees the sky on both sides: 2, to what the ordinates' cosines differ from their integral
  // (ordinate_set_test.cpp) on both. On rims, between walls and on caps of all six faces alike.
  constexpr double kNoOpacity = 1e30;
  const SweptScene balls = ball(14), cut(glm::ivec3(21), glm::dvec3(1), 1, [](glm::dvec3 p) {
    return std::sin(p.x) + std::sin(p.y) + std::sin(p.z) + 0.3;
  });
  for (const SweptScene* scene : {&balls, &cut}) {
    const SweptLight light = translucencyOf(*scene, kNoOpacity).light;
    for (const SurfaceFoot& foot : scene->feet()) {
      if (foot.normal == glm::vec3(0)) continue;
      EXPECT_NEAR(test::lightAt(light, glm::round(glm::dvec3(foot.position))), 2, 0.0025)
          << foot.position.x << " " << foot.position.y << " " << foot.position.z;
    }
  }
}

TEST(Translucency, ThreadsDoNotChangeABit) {
  // One and two threads give the same bits.
  const SweptScene scene = ball(9);
  const auto sweep = [&](int threads) {
    setThreadCount(threads);
    return translucencyOf(scene, 5);
  };
  const Translucency one = sweep(1), two = sweep(2);
  setThreadCount(0);
  EXPECT_EQ(one.light.full, two.light.full);
  EXPECT_EQ(one.thickness.full, two.thickness.full);
  EXPECT_EQ(test::paddedNumbers(one.light.values), test::paddedNumbers(two.light.values));
  EXPECT_EQ(test::paddedNumbers(one.thickness.values), test::paddedNumbers(two.thickness.values));
}

TEST(Translucency, AndOpennessReadNothingBeyondABandOfOneVoxel) {
  // A band of one voxel gives the openness and the thickness of the whole field, bit for bit: for both solvers, of
  // smooth sheets and noise, at equal spacings and where one is longer than the band is thick.
  const auto sheets = [](glm::dvec3 p) { return std::sin(p.x * .4) + std::cos(p.y * .35) + std::sin(p.z * .3) - .4; };
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1.2, 3.5)})
    for (const bool smooth : {true, false})
      for (const DistanceSolver solver : {DistanceSolver::godunov, DistanceSolver::closest}) {
        const glm::ivec3 size(40, 37, 33);
        const Grid<float> level =
            smooth ? test::sampleLevel(size, spacing, sheets) : test::noiseLevel(size, spacing, 5);
        const auto read = [&](DistanceExtent extent) {
          const SweptFields swept = sweepOcclusion(level.view(), {.visibility = VisibilityStorage::none,
                                                                  .solver = solver,
                                                                  .extent = extent,
                                                                  .bandVoxels = kSurfaceBandVoxels});
          const GridView<const float> distance = swept.distance.view();
          const SurfaceRays rays(level.view(), distance, 1);
          return std::pair(sweepOpenness(level.view(), distance, {.ordinates = 72}),
                           sweepThickness(rays, distance, 72));
        };
        const auto band = read(DistanceExtent::band), full = read(DistanceExtent::full);
        EXPECT_EQ(band.second.full, full.second.full);
        const auto numbers = test::paddedNumbers(band.first);
        ASSERT_GT(std::count_if(numbers.begin(), numbers.end(), [](auto number) { return number != 0; }), 1000);
        EXPECT_EQ(numbers, test::paddedNumbers(full.first)) << "smooth " << smooth;
        EXPECT_EQ(test::paddedNumbers(band.second.values), test::paddedNumbers(full.second.values));
      }
}

}  // namespace
}  // namespace isolume
