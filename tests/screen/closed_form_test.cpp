// Estimators against the integrals that they approximate, on scenes whose integrals are known: in C++, from any side.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "screen/estimate.h"

namespace isolume::test {
namespace {

// Lead away from the eye; each sees floor and walls of half_spaces.h.
const std::array<glm::dvec3, 3> kViews{glm::dvec3(1, 1, -1), glm::dvec3(0.5, 0.2, -1), glm::dvec3(1, 0.6, -0.4)};

ScreenOcclusion many(ScreenEstimator estimator) {
  ScreenOcclusion settings;
  settings.estimator = estimator;
  settings.samples = kMostScreenSamples;
  return settings;
}

/// What an estimator gives on a plane: 1, but the balls that reach below the surface are half full.
double openPlane(const ScreenOcclusion& settings) {
  const bool wholeBall =
      settings.estimator == ScreenEstimator::crytek || (isLoos10(settings.estimator) && !settings.clampedToTangent);
  return wholeBall ? 0.5 : 1;
}

/// All estimators, loos10 with and without the tangent plane.
std::vector<ScreenOcclusion> allEstimators() {
  std::vector<ScreenOcclusion> all;
  for (const ScreenEstimator each : screenEstimators()) {
    if (each == ScreenEstimator::loosArea) continue;  // has a test of its own
    all.push_back(many(each));
    for (const BentSource source : {BentSource::crytek2d, BentSource::hbao}) {
      if (each != ScreenEstimator::klehm11) break;
      all.push_back(many(each));
      all.back().bentFrom = source;
    }
    if (!isLoos10(each)) continue;
    all.push_back(many(each));
    all.back().clampedToTangent = false;
  }
  return all;
}

// Of 256 samples in 32 turns: what is left of the error of the sets, whose sums over a half-space are off by about one
// sample in 256 for each of the radii and polar angles that turning does not change.
constexpr double kSetError = 0.012;
// gpu-importance draws its samples independently: three standard deviations of a mean of 256 that are 0 or 1.
constexpr double kRandomError = 3 * 0.5 / 16;
double setError(const ScreenOcclusion& settings) {
  return settings.estimator == ScreenEstimator::gpuImportance ? kRandomError : kSetError;
}

TEST(ScreenClosedForm, PlaneIsOpen) {
  // On a plane nothing occludes: 1 to rounding, and 1/2 to the error of a set where the ball reaches below the surface.
  constexpr double kRounding = 2e-5;
  for (const ScreenOcclusion& settings : allEstimators())
    for (const glm::dvec3& view : kViews)
      EXPECT_NEAR(estimate(settings, plane(), view), openPlane(settings),
                  openPlane(settings) == 1 ? kRounding : kSetError)
          << screenEstimatorName(settings.estimator);
}

TEST(ScreenClosedForm, EdgeAndCornerCloseHalfAndThreeQuarters) {
  // In the very edge between floor and wall half of what a plane gives is left, in the corner between floor and two
  // walls a quarter, whatever the membership: the walls cut the neighbourhood at planes through its centre.
  for (const ScreenOcclusion& settings : allEstimators()) {
    for (const glm::dvec3& view : kViews) {
      EXPECT_NEAR(estimate(settings, edge(0), view), openPlane(settings) / 2, setError(settings))
          << screenEstimatorName(settings.estimator);
      EXPECT_NEAR(estimate(settings, corner(0), view), openPlane(settings) / 4, setError(settings))
          << screenEstimatorName(settings.estimator);
    }
  }
}

/// Midpoint sum over x in [low, 1].
template <class F>
double integral(double low, F f) {
  constexpr int kPoints = 20000;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) sum += f(low + (1 - low) * (i + 0.5) / kPoints);
  return sum * (1 - low) / kPoints;
}

/// O before a wall at distance a: of the unit disk that the directions project to, the strip at x meets the wall at a /
/// x.
double besideWall(Membership membership, double a) {
  return 1 - integral(a, [&](double x) { return (1 - membershipAt(membership, a / x)) * 2 * std::sqrt(1 - x * x); }) /
                 std::numbers::pi;
}

/// What each estimator approximates before a wall at distance a.
double wallTruth(const ScreenOcclusion& settings, double a) {
  switch (settings.estimator) {
    case ScreenEstimator::klehm11:
      if (settings.bentFrom == BentSource::crytek2d) return 1 - (1 - a) / 2;  // directions as of hbao, closed from a on
      if (settings.bentFrom == BentSource::hbao) return 1 - 0.5 * (1 - a + a * std::log(a));
      return 1 - (1 - a) * (1 - a) * (2 + a) / 4;  // of half a ball
    case ScreenEstimator::hbao:  // directions by solid angle have an x uniform in [-1, 1]; occluders weigh 1 - a / x
      return 1 - 0.5 * (1 - a + a * std::log(a));
    case ScreenEstimator::gtao:
    case ScreenEstimator::bitmask:
    case ScreenEstimator::envImportance:
      return besideWall(Membership::classical, a);
    case ScreenEstimator::ssdo:
      return besideWall(Membership::linear, a);
    case ScreenEstimator::gpuDisk:
      return besideWall(Membership::quartic, a);
    case ScreenEstimator::gpuTangent:
    case ScreenEstimator::szirmayVolumetric: {  // the cap that the wall cuts from the tangent sphere, pi h^2 (3/2 - h)
                                                // / 3
      const double h = std::max(0.0, 0.5 - a);
      return 1 - 2 * h * h * (1.5 - h);
    }
    case ScreenEstimator::crytek:
    case ScreenEstimator::loosPoint:
    case ScreenEstimator::loosLine:  // half of the cap of the ball, pi (1 - a)^2 (2 + a) / 3, of half a ball or a whole
                                     // one
      return openPlane(settings) * (1 - (1 - a) * (1 - a) * (2 + a) / 4);
    default:
      return besideWall(settings.membership, a);
  }
}

TEST(ScreenClosedForm, WallAtADistance) {
  // Before a wall at any distance each estimator gives its own integral, from any side that sees both floor and wall.
  for (const ScreenOcclusion& settings : allEstimators())
    for (const glm::dvec3& view : kViews)
      for (const double a : {0.1, 0.3, 0.6})
        EXPECT_NEAR(estimate(settings, edge(a), view), wallTruth(settings, a), setError(settings))
            << screenEstimatorName(settings.estimator) << " at " << a << " from " << view.x;
}

TEST(ScreenClosedForm, ExactNormalisationIsTheSame) {
  // Divided by the exact volume or light in place of the sampled one, each estimator that reads the choice gives the
  // same integral.
  for (ScreenOcclusion settings : allEstimators()) {
    if (!readsNormalisation(settings.estimator)) continue;
    settings.normalisedBySamples = false;
    // gpu-sphere: half of its samples lie below the surface, and the cosines of the others scatter.
    const double tolerance = settings.estimator == ScreenEstimator::gpuSphere ? 3 * kSetError : kSetError;
    for (const glm::dvec3& view : kViews)
      EXPECT_NEAR(estimate(settings, edge(0.3), view), wallTruth(settings, 0.3), tolerance)
          << screenEstimatorName(settings.estimator);
  }
}

TEST(ScreenClosedForm, EveryMembership) {
  // The estimators that leave the membership open follow each that they take: gpu-tangent is its own approximation.
  for (const ScreenEstimator estimator : {ScreenEstimator::gpuSphere, ScreenEstimator::gpuHemisphere,
                                          ScreenEstimator::gpuImportance, ScreenEstimator::szirmayContainment}) {
    for (const Membership membership : takenMemberships(estimator)) {
      ScreenOcclusion settings = many(estimator);
      settings.membership = membership;
      // The derivative of sqrt(r) over r^2 grows without bound at the centre: few samples carry the sum.
      const double tolerance = membership == Membership::squareRoot ? 5 * kSetError : setError(settings);
      EXPECT_NEAR(estimate(settings, edge(0.3), kViews[0]), besideWall(membership, 0.3), tolerance)
          << screenEstimatorName(estimator) << " " << static_cast<int>(membership);
    }
  }
}

TEST(ScreenClosedForm, StepOpensAboveItsTop) {
  // Before a step of a height, the share of the neighbourhood that is outside is that of a grid of points.
  const Blocks blocks = step(0.2, 0.3);
  for (const ScreenEstimator estimator :
       {ScreenEstimator::szirmayVolumetric, ScreenEstimator::loosLine, ScreenEstimator::loosPoint}) {
    const bool tangent = estimator == ScreenEstimator::szirmayVolumetric;
    const glm::dvec3 centre(0, 0, tangent ? 0.5 : 0);
    const double radius = tangent ? 0.5 : 1;
    constexpr int kGrid = 120;
    double open = 0, all = 0;
    for (int i = 0; i < kGrid * kGrid * kGrid; ++i) {
      const glm::dvec3 cell(i % kGrid, i / kGrid % kGrid, i / kGrid / kGrid);
      const glm::dvec3 p = (2.0 * cell + 1.0) / static_cast<double>(kGrid) - 1.0;
      const glm::dvec3 point = centre + radius * p;
      if (glm::length(p) > 1 || point.z < 0) continue;
      all += 1;
      open += isSolid(blocks, point) ? 0 : 1;
    }
    for (const glm::dvec3& view : kViews)
      EXPECT_NEAR(estimate(many(estimator), blocks, view), open / all, kSetError) << screenEstimatorName(estimator);
  }
}

TEST(ScreenClosedForm, UpperEdgeOfAStepIsOpen) {
  // At the upper edge of a step the ground falls away: nothing occludes.
  constexpr double kRounding = 2e-5;
  const Blocks blocks{{kFloor, {{-1, 0, 0}, -0.05}}, {below(-0.5)}};
  const glm::dvec3 view(-0.5, 0.2, -1);
  for (const ScreenOcclusion& settings : allEstimators()) {
    if (openPlane(settings) < 1) continue;
    EXPECT_NEAR(estimate(settings, blocks, view), 1, kRounding) << screenEstimatorName(settings.estimator);
  }
}

TEST(ScreenClosedForm, RollChangesNothingButTheSamples) {
  // Turned about the line of sight by any angle, each estimator gives the same to the error of its set.
  for (const ScreenOcclusion& settings : allEstimators())
    for (const double roll : {0.4, 2.0})
      EXPECT_NEAR(estimate(settings, step(0.2, 0.3), kViews[0], 32, roll),
                  estimate(settings, step(0.2, 0.3), kViews[0]), kSetError)
          << screenEstimatorName(settings.estimator);
}

TEST(ScreenClosedForm, AreasAreLinesThatSpread) {
  // On a plane across the view all depths of an area are one: 1. On a tilted one each line loses a quarter of the
  // deviation of its depths: slope * side / sqrt(12) of a square. Before a wall many areas come to lines, less that.
  ScreenOcclusion settings = many(ScreenEstimator::loosArea);
  EXPECT_NEAR(estimate(settings, plane(), {0, 0, -1}), 1, 1e-4);
  const glm::dvec3 tilted(1, 0, -1);
  const double deviation = std::sqrt(std::numbers::pi / kMostScreenSamples / 12);
  // The half ball has lines of mean length (2 pi / 3) / pi = 2/3; those at its rim are shorter than their loss.
  EXPECT_NEAR(estimate(settings, plane(), tilted), 1 - deviation / 4 / (2.0 / 3), kSetError / 2);
  const double lines = estimate(many(ScreenEstimator::loosLine), edge(0.3), {1, 0.6, -1});
  EXPECT_NEAR(estimate(settings, edge(0.3), {1, 0.6, -1}), lines, 2 * kSetError);
}

TEST(ScreenClosedForm, ThicknessOpensWhatLiesBehind) {
  // Behind a wall of a thickness the neighbourhood is open again: lines leave out a slab of the ball, whose volume
  // between x = a and x = b is pi [(b - a) - (b^3 - a^3) / 3], half of it above the floor. Seen along the wall's
  // normal.
  constexpr double kNear = 0.2, kThickness = 0.3, kFar = kNear + kThickness;
  ScreenOcclusion settings = many(ScreenEstimator::loosLine);
  settings.thicknessWorld = kThickness;
  // The floor is seen edge on, so the ball is cut at the wall alone; the normal is across the view.
  settings.clampedToTangent = false;
  const double slab = ((kFar - kNear) - (std::pow(kFar, 3) - std::pow(kNear, 3)) / 3) / (4.0 / 3);
  EXPECT_NEAR(estimate(settings, {{wallX(kNear)}}, {1, 0, 0}), 1 - slab, kSetError);
  settings.thicknessWorld.reset();
  EXPECT_LT(estimate(settings, {{wallX(kNear)}}, {1, 0, 0}), 1 - slab - 0.1);
}

}  // namespace
}  // namespace isolume::test
