#include "sweep/ordinates/inter_reflection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ordinates/reference_points.h"
#include "ordinates/swept_scene.h"
#include "sweep/ordinates/openness_sweep.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

using test::SweptScene;

constexpr int kOrdinates = 512;

// What a white sky gives each foot, and what of it is blocked.
struct WhiteSky {
  explicit WhiteSky(const SweptScene& scene) : blocked(blockedShares(scene.rays, kOrdinates)) {
    for (const float each : blocked) direct.push_back(std::clamp(1 - each, 0.0F, 1.0F));
  }
  std::vector<float> blocked, direct;
};

// A box of walls 7 voxels thick around 11 voxels of space.
double boxLevel(glm::dvec3 p) {
  const glm::dvec3 wall = glm::abs(p - 12.0) - 5.0;
  return std::max({wall.x, wall.y, wall.z});
}
SweptScene closedBox() { return SweptScene(glm::ivec3(25), glm::dvec3(1), 1, boxLevel); }
// The same without a lid.
SweptScene openBox() {
  return SweptScene({25, 25, 16}, glm::dvec3(1), 1, [](glm::dvec3 p) {
    const glm::dvec3 wall = glm::abs(p - 12.0) - 5.0;
    return std::max({wall.x, wall.y, 7 - p.z});
  });
}

void expectFurnace(const SweptScene& scene, const char* name) {
  const WhiteSky sky(scene);
  const ReflectedLight got =
      InterReflection(scene.rays, ReflectionOptions().ordinates).reflect(sky.direct, sky.blocked, 1, 1, {});
  double farthest = 0;
  for (std::size_t i = 0; i < got.light.size(); ++i)
    farthest = std::max(farthest, std::abs(double{got.light[i]} + double{sky.direct[i]} - 1));
  EXPECT_LT(farthest, 1e-3) << name;
  EXPECT_GT(got.light.size(), 500U) << name;
}

TEST(InterReflection, FurnaceGivesOne) {
  // With albedo 1 under a white sky as much light leaves as arrives: every foot has 1, in the open, in an open box and
  // in a closed one, which no light enters.
  expectFurnace(SweptScene(test::sceneLevel("corner", 40), 1), "corner");
  expectFurnace(SweptScene(test::sceneLevel("capsules", 40), 1), "capsules");
  expectFurnace(openBox(), "open box");
  expectFurnace(closedBox(), "closed box");
}

TEST(InterReflection, ABlackSurfaceSendsNothing) {
  // Albedo 0 adds nothing, whatever the light, and takes no iteration.
  const SweptScene scene = openBox();
  const WhiteSky sky(scene);
  for (const int bounces : {0, 3}) {
    const ReflectedLight got =
        InterReflection(scene.rays, 72).reflect(sky.direct, sky.blocked, 0, 1, {.bounces = bounces});
    EXPECT_EQ(got.bounces, 0);
    EXPECT_EQ(got.light, std::vector<float>(sky.direct.size(), 0));
  }
}

TEST(InterReflection, ACavityIsAGeometricSeries) {
  // In a closed box whose walls all have the direct light 1/2, n reflections of albedo a add (a + ... + a^n) / 2, and
  // all of them a / (1 - a) / 2, from any start above: to the rounding of what is carried, a step of 1 / 254 at random
  // per reflection and direction, of which 72 are added; all of them to .01 of it on the mean.
  const SweptScene scene = closedBox();
  constexpr float kAlbedo = 0.75F;
  // Feet inside the box: those of the outer faces are caps, and see nothing of each other.
  std::vector<float> direct, blocked;
  std::vector<bool> inner;
  for (const SurfaceFoot& foot : scene.feet()) {
    inner.push_back(scene.isWithin(foot, 2));
    direct.push_back(inner.back() ? 0.5F : 0);
    blocked.push_back(inner.back() ? 1.0F : 0);
  }
  const InterReflection reflection(scene.rays, 72);
  const auto meanOf = [&](const ReflectedLight& got, double want, double tolerance) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < inner.size(); ++i) {
      if (!inner[i]) continue;
      EXPECT_NEAR(got.light[i], want, tolerance);
      sum += got.light[i];
      ++count;
    }
    EXPECT_GT(count, 500);
    return sum / count;
  };
  double want = 0;
  for (int bounces = 1; bounces <= 5; ++bounces) {
    want += 0.5 * std::pow(kAlbedo, bounces);
    const ReflectedLight got = reflection.reflect(direct, blocked, kAlbedo, 1, {.bounces = bounces});
    EXPECT_EQ(got.bounces, bounces);
    EXPECT_NEAR(meanOf(got, want, 0.01 * want), want, 2e-3 * want) << bounces;
  }
  const double all = 0.5 * kAlbedo / (1 - kAlbedo);
  for (const float start : {2.0F, 4.0F}) {
    const ReflectedLight got = reflection.reflect(direct, blocked, kAlbedo, start, {});
    EXPECT_NEAR(meanOf(got, all, 0.02 * all), all, 0.01 * all) << start;
    EXPECT_LT(got.bounces, ReflectionOptions().mostBounces);
  }
}

TEST(InterReflection, FewReflectionsAreNeverMoreThanAll) {
  // More reflections never take light away, and some are never more than all of them, to what the rounding of what is
  // carried and the tolerance of all may do at a foot (.01 of the light of an open point).
  const SweptScene scene = openBox();
  const WhiteSky sky(scene);
  const InterReflection reflection(scene.rays, 72);
  const ReflectedLight all = reflection.reflect(sky.direct, sky.blocked, 0.8F, 1, {});
  std::vector<float> before(sky.direct.size(), 0);
  for (const int bounces : {1, 2, 4, 8, 16}) {
    const ReflectedLight some = reflection.reflect(sky.direct, sky.blocked, 0.8F, 1, {.bounces = bounces});
    for (std::size_t i = 0; i < before.size(); ++i) {
      ASSERT_GE(some.light[i], 0);
      ASSERT_GE(some.light[i], before[i] - 0.01F) << bounces;
      ASSERT_LE(some.light[i], all.light[i] + 0.01F) << bounces;
    }
    before = some.light;
  }
  // And 16 are nearly all: of light that meets the walls with 4 / 5 at most, .8^16 is left.
  double rest = 0;
  for (std::size_t i = 0; i < before.size(); ++i) rest += all.light[i] - before[i];
  EXPECT_NEAR(rest / static_cast<double>(before.size()), 0, 0.01);
}

TEST(InterReflection, OneReflectionAsTheReference) {
  // On the sample scene `corner` the light of one reflection alone is that of the reference's paths with one, to an
  // RMSE of .02 at random points of the surface (albedo .8).
  constexpr float kAlbedo = 0.8F;
  const SweptScene scene(test::sceneLevel("corner", 64), 1);
  const WhiteSky sky(scene);
  const ReflectedLight reflected =
      InterReflection(scene.rays, 72).reflect(sky.direct, sky.blocked, kAlbedo, 1, {.bounces = 1});
  const SweptLight light = lightOfFeet(scene.rays.surface(), reflected.light.data());
  const SurfaceTracer tracer(scene.level.view());
  std::vector<double> want, got;
  double mean = 0;
  for (const ShadedPoint& point : test::randomSurfacePoints(tracer, 300)) {
    const auto traced = [&](int bounces) {
      IntegrandSettings settings;
      settings.integrand = Integrand::bounce;
      settings.bounces = bounces;
      settings.albedo = glm::dvec3(kAlbedo);
      // Standard error of the difference about 5e-3.
      return estimateAt({tracer, glm::dmat3(1)}, settings, {.rays = 4096}, point, want.size()).channels.value[0];
    };
    want.push_back(traced(1) - traced(0));
    got.push_back(test::lightAt(light, point.hit.position));
    mean += want.back() / 300;
  }
  EXPECT_LT(test::rmsDifference(got, want), 0.02);
  EXPECT_GT(mean, 0.1);
}

TEST(InterReflection, ThreadsDoNotChangeABit) {
  // One and two threads give the same bits, of one reflection and of all.
  const SweptScene scene(test::sceneLevel("corner", 40), 1);
  const WhiteSky sky(scene);
  const auto reflect = [&](int threads, int bounces) {
    setThreadCount(threads);
    return InterReflection(scene.rays, 72).reflect(sky.direct, sky.blocked, 0.7F, 1, {.bounces = bounces});
  };
  for (const int bounces : {0, 1}) {
    const ReflectedLight one = reflect(1, bounces), two = reflect(2, bounces);
    EXPECT_EQ(one.light, two.light);
    EXPECT_EQ(one.bounces, two.bounces);
  }
  setThreadCount(0);
}

}  // namespace
}  // namespace isolume
