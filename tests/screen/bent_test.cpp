// Bent normals of floors and walls in closed form, and the light that they look up.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "raymarch/screen/sky_convolution.h"
#include "screen/estimate.h"
#include "support/random_numbers.h"

namespace isolume::glsl {
namespace {

using namespace glm;

std::function<vec3(vec3 direction, float layer)> askedConeLight;
vec3 coneLight(vec3 direction, float layer) { return askedConeLight(direction, layer); }

#include "shaders/screen/bent_light.glsl"

}  // namespace
}  // namespace isolume::glsl

namespace isolume::test {
namespace {

using std::numbers::pi;

const std::array<glm::dvec3, 3> kViews{glm::dvec3(1, 1, -1), glm::dvec3(0.5, 0.2, -1), glm::dvec3(1, 0.6, -0.4)};
const std::array kSources{BentSource::crytek2d, BentSource::crytek3d, BentSource::hbao};
// As in closed_form_test.cpp: what is left of the error of 256 samples in 32 turns.
constexpr double kSetError = 0.012;

ScreenOcclusion many(BentSource source) {
  return {.estimator = ScreenEstimator::klehm11, .samples = kMostScreenSamples, .bentFrom = source};
}

double offBy(glm::dvec4 got, glm::dvec4 want) { return glm::length(got - want); }

TEST(BentNormal, PlaneKeepsItsNormal) {
  // On a plane nothing bends, to rounding, however few the samples and without any turn of them.
  for (const BentSource source : kSources)
    for (const glm::dvec3& view : kViews)
      for (const int samples : {1, 4, 32}) {
        ScreenOcclusion settings = many(source);
        settings.samples = samples;
        EXPECT_LT(offBy(estimateBend(settings, plane(), view, 1), {0, 0, 0, 1}), 2e-5) << bentSourceName(source);
      }
}

TEST(BentNormal, EdgeAndCornerLeanOut) {
  // The open quarter sphere of an edge has the mean (-1/2, 0, 1/2), the octant of a corner (-1/2, -1/2, 1/2): less N /
  // 2, times the open share.
  for (const BentSource source : kSources)
    for (const glm::dvec3& view : kViews) {
      EXPECT_LT(offBy(estimateBend(many(source), edge(0), view), {-0.25, 0, 0, 0.5}), 2 * kSetError)
          << bentSourceName(source) << " " << glm::length(view);
      EXPECT_LT(offBy(estimateBend(many(source), corner(0), view), {-0.125, -0.125, 0, 0.25}), 2 * kSetError)
          << bentSourceName(source);
    }
}

/// How much of the directions that meet a wall at distance d each source closes.
double closedAt(BentSource source, double d) {
  if (d >= 1) return 0;
  if (source == BentSource::crytek2d) return 1;
  return source == BentSource::hbao ? 1 - d : 1 - d * d * d;
}

/// share (N_b - N / 2) and share before a wall at x = a. Over the hemisphere the x of directions is uniform in [-1, 1],
/// those with an x have the mean height (2 / pi) sqrt(1 - x^2), and meet the wall at the distance a / x.
glm::dvec4 wallTruth(BentSource source, double a) {
  constexpr int kPoints = 20000;
  glm::dvec4 closed(0);
  for (int i = 0; i < kPoints; ++i) {
    const double x = a + (1 - a) * (i + 0.5) / kPoints;
    closed += (1 - a) / kPoints / 2 * closedAt(source, a / x) * glm::dvec4(x, 0, 2 / pi * std::sqrt(1 - x * x), 1);
  }
  const double share = 1 - closed.w;
  return {-closed.x, 0, 0.5 - closed.z - share / 2, share};
}

TEST(BentNormal, WallAtADistance) {
  // Before a wall each source gives the mean of the directions that it leaves open, from any side.
  for (const BentSource source : kSources)
    for (const glm::dvec3& view : kViews)
      for (const double a : {0.1, 0.3, 0.6})
        EXPECT_LT(offBy(estimateBend(many(source), edge(a), view), wallTruth(source, a)), 2 * kSetError)
            << bentSourceName(source) << " at " << a << " from " << view.x;
}

TEST(BentNormal, RollChangesNothingButTheSamples) {
  // Turned about the line of sight the mean open direction stays where it is in the scene.
  for (const BentSource source : kSources)
    for (const double roll : {0.4, 2.0})
      EXPECT_LT(offBy(estimateBend(many(source), edge(0.2), kViews[2], 32, roll),
                      estimateBend(many(source), edge(0.2), kViews[2])),
                2 * kSetError)
          << bentSourceName(source);
}

TEST(BentNormal, OpennessAloneIsTheSame) {
  // What klehm11 has over hbao is hbao's openness to the last bit.
  const ScreenOcclusion hbao{.estimator = ScreenEstimator::hbao, .samples = 16};
  for (const glm::dvec3& view : kViews)
    EXPECT_EQ(estimate(many(BentSource::hbao), edge(0.3), view), estimate(hbao, edge(0.3), view));
}

TEST(BentNormal, StepsSeeWhatStandsOnTheWay) {
  // Behind a fence of a thickness it is open again: without steps to the samples beyond it, with them less and less.
  ScreenOcclusion settings = many(BentSource::crytek3d);
  settings.thicknessWorld = 0.15;
  const Blocks fence{{kFloor}, {wallX(0.3)}};
  const glm::dvec3 view(1, 0, -0.3);
  std::array<double, 3> open{};
  for (std::size_t i = 0; i < open.size(); ++i) {
    settings.steps = std::array{0, 1, 3}[i];  // the points of each are among those of the next
    open[i] = estimateBend(settings, fence, view).w;
  }
  EXPECT_LT(open[1], open[0] - 0.02);
  EXPECT_LT(open[2], open[1] - 0.02);
}

TEST(BentNormal, FarInFrontClosesNothing) {
  // With a thickness crytek-2d leaves open what is seen farther than that in front of the plane.
  ScreenOcclusion settings = many(BentSource::crytek2d);
  const glm::dvec3 view(0.5, 0.2, -1);
  EXPECT_LT(estimateBend(settings, edge(0.3), view).w, 0.8);
  settings.thicknessWorld = 0.01;
  EXPECT_GT(estimateBend(settings, edge(0.3), view).w, 0.95);
}

constexpr int kCap = static_cast<int>(BentLight::cap);

TEST(BentLookup, EvenSkyGivesOpenness) {
  // Under an even sky light is the openness whatever is looked up by, also where nothing or no direction is open.
  glsl::askedConeLight = [](glm::vec3, float) { return glm::vec3(1, 2, 3); };
  for (const glm::vec4 stored : {glm::vec4(-0.25f, 0, 0, 0.5f), glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, -0.2f, 0.4f),
                                 glm::vec4(0.1f, 0.1f, 0, 0)})
    for (int by = 0; by <= kCap; ++by)
      EXPECT_LT(glm::distance(glsl::bentLight(by, false, {0, 0, 1}, stored), stored.w * glm::vec3(1, 2, 3)), 1e-6f);
}

TEST(BentLookup, ConesAreThoseOfTheMean) {
  // An open point has the hemisphere; a right-angled edge, of mean length sqrt(1/2), the paper's (2 - sqrt(2)) pi / 2
  // and the cap acos(sqrt(2) - 1); a single direction none.
  EXPECT_NEAR(glsl::bentCone({0, 0, 0.5f}), pi / 2, 1e-6);
  EXPECT_NEAR(glsl::bentCap({0, 0, 0.5f}), pi / 2, 1e-6);
  EXPECT_NEAR(glsl::bentCone({-0.5f, 0, 0.5f}), (2 - std::sqrt(2)) * pi / 2, 1e-6);
  EXPECT_NEAR(glsl::bentCap({-0.5f, 0, 0.5f}), std::acos(std::sqrt(2) - 1), 1e-6);
  EXPECT_NEAR(glsl::bentCone({0, 1, 0}), 0, 1e-6);
  EXPECT_NEAR(glsl::bentCap({0, 1, 0}), 0, 1e-6);
  EXPECT_NEAR(glsl::bentCone({0, 0, 0.2f}), pi / 2, 1e-6);
}

TEST(BentLookup, AnglesAreInterpolated) {
  // Between the angles of two layers light is linear; narrower cones than the first take that one, and L_p is the last.
  glsl::askedConeLight = [](glm::vec3, float layer) { return glm::vec3(layer); };
  for (const double layer : {0.0, 0.25, 3.5, 6.0, 7.0}) {
    const auto cone = static_cast<float>((layer + 1) / kConeAngles * pi / 2);
    EXPECT_NEAR(glsl::lightWithin({0, 0, 1}, cone).r, layer, 1e-5);
  }
  EXPECT_EQ(glsl::lightWithin({0, 0, 1}, 0.01f).r, 0);
  EXPECT_EQ(glsl::openLight({0, 0, 1}).r, kConeAngles - 1);
}

TEST(BentLookup, EachLooksAlongItsOwnDirection) {
  // By none light comes about the normal, by all others about the mean open direction.
  glsl::askedConeLight = [](glm::vec3 direction, float) { return direction; };
  const glm::vec4 stored(-0.25f, 0, 0, 0.5f);
  const float lean = std::sqrt(0.5f);
  EXPECT_LT(glm::distance(glsl::bentLight(0, false, {0, 0, 1}, stored), glm::vec3(0, 0, 0.5f)), 1e-6f);
  for (int by = 1; by <= kCap; ++by)
    EXPECT_LT(glm::distance(glsl::bentLight(by, false, {0, 0, 1}, stored), 0.5f * glm::vec3(-lean, 0, lean)), 1e-6f);
}

TEST(BentLookup, GeometricTermIsThePapers) {
  // With the term the sum over the cone has the paper's t = 1 / (1 - cos C) in place of 1 / sin^2 C, times N_b . N: 1
  // in the open.
  glsl::askedConeLight = [](glm::vec3, float) { return glm::vec3(1); };
  EXPECT_NEAR(glsl::bentLight(2, true, {0, 0, 1}, {0, 0, 0, 1}).r, 1, 1e-6);
  const double cone = (2 - std::sqrt(2)) * pi / 2;
  EXPECT_NEAR(glsl::bentLight(2, true, {0, 0, 1}, {-0.25f, 0, 0, 0.5f}).r,
              0.5 * std::sqrt(0.5) * std::pow(std::sin(cone), 2) / (1 - std::cos(cone)), 1e-6);
}

/// Root mean square error of the light in an edge, or in a corner, under skies that are white about a direction and
/// black about its opposite, over many directions.
double halfSkyError(int by, bool corner) {
  constexpr int kSkies = 300, kDirections = 4000;
  const glm::vec4 stored = corner ? glm::vec4(-0.125f, -0.125f, 0, 0.25f) : glm::vec4(-0.25f, 0, 0, 0.5f);
  RandomNumbers numbers(5);
  double squares = 0;
  for (int s = 0; s < kSkies; ++s) {
    const glm::dvec3 d = numbers.direction();
    // Even directions over a hemisphere, by a spiral about z; the sum over a cone, weighed by the cosine.
    const auto mean = [&](glm::dvec3 axis, double angle, auto&& open) {
      const glm::dmat3 frame = frameAlong(axis, 0);
      double sum = 0, whole = 0;
      for (int i = 0; i < kDirections; ++i) {
        const double z = 1 - (1 - std::cos(angle)) * (i + 0.5) / kDirections, turn = 2 * pi * i / std::numbers::phi;
        const glm::dvec3 w =
            frame * glm::dvec3(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
        sum += open(w) && glm::dot(w, d) > 0 ? z : 0;
        whole += z;
      }
      return sum / whole;
    };
    const double truth = mean({0, 0, 1}, pi / 2, [&](glm::dvec3 w) { return w.x < 0 && (!corner || w.y < 0); });
    glsl::askedConeLight = [&](glm::vec3 direction, float layer) {
      return glm::vec3(static_cast<float>(
          mean(glm::dvec3(direction), (layer + 1) / kConeAngles * pi / 2, [](glm::dvec3) { return true; })));
    };
    squares += std::pow(glsl::bentLight(by, false, {0, 0, 1}, stored).r - truth, 2);
  }
  return std::sqrt(squares / kSkies);
}

TEST(BentLookup, ConesBeatBentNormals) {
  // With the exact openness and bend of an edge and of a corner, under a sky of two halves that lie anyhow, bent
  // normals err less than the normal, cones less than bent normals ([Klehm11] Sec. 5), and caps less than cones. Seen:
  // .092, .052, .046, .045 and .063, .039, .032, .026.
  const int normal = static_cast<int>(BentLight::normal), cone = static_cast<int>(BentLight::cone);
  for (const bool corner : {false, true}) {
    const double bent = halfSkyError(normal, corner);
    EXPECT_LT(bent, 0.7 * halfSkyError(static_cast<int>(BentLight::none), corner)) << corner;
    EXPECT_LT(halfSkyError(cone, corner), 0.9 * bent) << corner;
    EXPECT_LT(halfSkyError(kCap, corner), halfSkyError(cone, corner)) << corner;
  }
}

}  // namespace
}  // namespace isolume::test
