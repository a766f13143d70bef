// Light that goes straight through a translucent solid, and how thick the solid is, against closed forms.
#include <gtest/gtest.h>

#include <functional>

#include "estimators/closed_form.h"

namespace isolume::test {
namespace {

constexpr int kRays = 1 << 14;

struct Translucent {
  double light = 0, thickness = 0, lightError = 0, thicknessError = 0;
};
Translucent translucent(const TestScene& scene, const ShadedPoint& point, double opacity, int rays = kRays) {
  IntegrandSettings settings;
  settings.integrand = Integrand::translucent;
  settings.opacity = opacity;
  const ChannelEstimate got = estimateAt(scene.scene(), settings, {.rays = rays}, point, 0).channels;
  return {got.value[0], got.value[1], got.standardError[0], got.standardError[1]};
}

// E_3(x) = integral over mu from 0 to 1 of mu exp(-x / mu), by its recursion from E_1 (x > 0).
double expIntegral3(double x) { return (std::exp(-x) * (1 - x) + x * x * -std::expint(-x)) / 2; }

// Two slabs with faces on samples: 2 thick with its top at z = 10, and 4 thick from z = 14 on.
constexpr double kThin = 2, kThick = 4, kTop = 10, kAbove = 14;
const TestScene& slabs() {
  static const TestScene scene({65, 65, 25}, glm::dvec3(1), [](glm::dvec3 p) {
    return std::max(kThin / 2 - std::abs(p.z - (kTop - kThin / 2)), kThick / 2 - std::abs(p.z - (kAbove + kThick / 2)));
  });
  return scene;
}
const ShadedPoint kOnThin = pointOn({32, 32, kTop});

// The cosine-weighted mean of f over directions below the horizon. Where f has kinks, at the edges of boxes, the sum
// over 1024^2 points errs by their length over 1024^2.
constexpr double kMidpoint = 1e-5;
double meanBelow(const std::function<double(glm::dvec3)>& f) {
  return squareMean(1024, [&f](double u, double v) {
    const double across = std::sqrt(u);
    return f({across * std::cos(2 * kPi * v), across * std::sin(2 * kPi * v), -std::sqrt(1 - u)});
  });
}

// Along a unit direction downwards from a point of the top of a box: to its bottom or to the first of its sides.
double wayOut(glm::dvec3 point, glm::dvec3 direction, glm::dvec3 low, glm::dvec3 high) {
  double way = (low.z - point.z) / direction.z;
  for (int axis = 0; axis < 2; ++axis)
    if (direction[axis] != 0)
      way = std::min(way, ((direction[axis] > 0 ? high : low)[axis] - point[axis]) / direction[axis]);
  return way;
}

TEST(Translucent, SlabsAttenuateByTheExponentialIntegral) {
  // Through a slab of thickness d light falls off as E_3(s d), s = -ln(1 - opacity) per voxel: so does that from below.
  // From above comes what goes through the upper slab, and between the slabs to the sides of the grid.
  constexpr double kSides = 1e-16;  // exp(-32 s): the lower slab as far as its sides
  for (const double opacity : {0.7, 0.9, 0.99}) {
    const double perVoxel = -std::log(1 - opacity);
    const double above = meanBelow([&](glm::dvec3 direction) {  // mirrored
      const auto wayTo = [&](double height) {
        return wayOut({32, 32, 0}, direction, glm::dvec3(0, 0, -height), glm::dvec3(64, 64, 0));
      };
      return std::exp(-perVoxel * (wayTo(kAbove + kThick - kTop) - wayTo(kAbove - kTop)));
    });
    const Translucent got = translucent(slabs(), kOnThin, opacity);
    const double want = 2 * expIntegral3(perVoxel * kThin) + above;
    EXPECT_NEAR(got.light, want, allowed(got.lightError) + kSides + kMidpoint) << opacity;
    EXPECT_LT(got.lightError, 6e-4);
  }
}

TEST(Translucent, BoxGivesItsMeanWayOut) {
  // From the top of a box whose faces lie on samples, with uneven spacing: thickness and light are means over the exact
  // ways out of it, in world units, and the opacity is that of the smallest spacing. The lower half is a cap: the grid
  // ends there.
  const glm::dvec3 spacing(0.5, 1, 2);
  const glm::dvec3 low(6 * 0.5, 7, 0), high(22 * 0.5, 25, 5 * 2);
  const TestScene box({33, 33, 9}, spacing, [&](glm::dvec3 p) {
    return std::min({p.x - low.x, high.x - p.x, p.y - low.y, high.y - p.y, high.z - p.z});
  });
  const glm::dvec3 point(4, 12, 10);
  constexpr double kOpacity = 0.2;
  const double perUnit = -std::log(1 - kOpacity) / spacing.x;
  const auto way = [&](glm::dvec3 direction) { return wayOut(point, direction, low, high); };
  const double thickness = meanBelow(way);
  const double light = meanBelow([&](glm::dvec3 direction) { return std::exp(-perUnit * way(direction)); });
  const Translucent got = translucent(box, pointOn(point / spacing), kOpacity);
  EXPECT_NEAR(got.thickness, thickness, allowed(got.thicknessError) + kMidpoint * thickness);
  EXPECT_NEAR(got.light, 1 + light, allowed(got.lightError) + kMidpoint);
  EXPECT_LT(got.thicknessError, 2e-3 * thickness);
  EXPECT_LT(got.lightError, 4e-4);
}

TEST(Translucent, BallGivesFourThirdsOfItsRadius) {
  // Chords 2 r cos(theta) have the cosine-weighted mean 4 r / 3, and let through (1 - (1 + k) e^-k) / k^2 of the light
  // from behind, k = 2 r s. The interpolant of r^2 - p^2 lies 0 to 3/4 below it, so its surface lies between two balls
  // with that difference of their squared radii, which bounds each way through it.
  constexpr double kRadius = 20, kLower = 0.75, kOpacity = 0.05;
  const TestScene ball(glm::ivec3(49), glm::dvec3(1),
                       [](glm::dvec3 p) { return kRadius * kRadius - glm::dot(p - 24.0, p - 24.0); });
  const double perVoxel = -std::log(1 - kOpacity), k = 2 * kRadius * perVoxel;
  double thicknessSlack = 0, lightSlack = 0;
  constexpr int kSteps = 10000;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = (i + 0.5) / kSteps, half = kRadius * cosine;
    const double longest = half + std::sqrt(half * half + kLower);
    const double shortest = 2 * std::sqrt(std::max((1 - kLower / (kRadius * kRadius)) * half * half - kLower, 0.0));
    thicknessSlack += 2 * cosine * (longest - shortest) / kSteps;
    lightSlack += 2 * cosine * (std::exp(-perVoxel * shortest) - std::exp(-perVoxel * longest)) / kSteps;
  }
  for (const glm::dvec3 normal : {glm::dvec3(0, 0, 1), glm::normalize(glm::dvec3(1, -2, 0.7))}) {
    const auto hit = ball.tracer.firstHit({24.0 + 40.0 * normal, -normal});
    ASSERT_TRUE(hit);
    const Translucent got = translucent(ball, {*hit, normal}, kOpacity);
    EXPECT_NEAR(got.thickness, 4 * kRadius / 3, allowed(got.thicknessError) + thicknessSlack);
    EXPECT_NEAR(got.light, 1 + 2 * (1 - (1 + k) * std::exp(-k)) / (k * k), allowed(got.lightError) + lightSlack);
    EXPECT_LT(got.thicknessError, 0.01);
    EXPECT_LT(got.lightError, 2e-4);
  }
  EXPECT_LT(thicknessSlack, 0.2);
  EXPECT_LT(lightSlack, 4e-3);
}

TEST(Translucent, ClearLetsAllThroughAndOpaqueIsTheOpenness) {
  // Opacity 0 gives exactly 2 wherever the point is, opacity 1 the openness, bit for bit: the same rays, of
  // which those into the solid bring nothing. The thickness is that of the solid, whatever its opacity.
  constexpr int kFew = 1024;
  const Translucent clear = translucent(slabs(), kOnThin, 0, kFew);
  const Translucent opaque = translucent(slabs(), kOnThin, 1, kFew);
  EXPECT_EQ(clear.light, 2);
  EXPECT_EQ(clear.lightError, 0);
  EXPECT_EQ(opaque.light, openness(slabs(), kOnThin, kFew).value);
  EXPECT_GT(opaque.light, 0.002);
  EXPECT_LT(opaque.light, 0.4);
  EXPECT_EQ(clear.thickness, opaque.thickness);
}

TEST(Translucent, CapIsLitFromOutsideUnhindered) {
  // On a cap half of the light comes from outside of the grid; the other half goes through the solid below, which ends
  // at the other faces of the grid and 16 voxels down.
  const TestScene block({41, 41, 21}, glm::dvec3(1), [](glm::dvec3 p) { return p.z - 4; });
  constexpr double kOpacity = 0.1;
  const Translucent got = translucent(block, {{0, {20, 20, 20}, 2}, {0, 0, 1}}, kOpacity);
  const auto way = [](glm::dvec3 direction) { return wayOut({20, 20, 20}, direction, {0, 0, 4}, {40, 40, 20}); };
  const double through = meanBelow([&](glm::dvec3 direction) { return std::pow(1 - kOpacity, way(direction)); });
  EXPECT_NEAR(got.light, 1 + through, allowed(got.lightError) + kMidpoint);
  EXPECT_NEAR(got.thickness, meanBelow(way), allowed(got.thicknessError) + kMidpoint * 16);
  EXPECT_GT(through, 0.05);
}

}  // namespace
}  // namespace isolume::test
