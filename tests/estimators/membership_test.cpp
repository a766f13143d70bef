// Openness within a radius: the membership functions and the integral over them.
#include <gtest/gtest.h>

#include <array>

#include "estimators/closed_form.h"
#include "sweep/reference/directions.h"

namespace isolume::test {
namespace {

constexpr std::array<Membership, 6> kAll{Membership::exponential, Membership::classical,  Membership::squareRoot,
                                         Membership::linear,      Membership::volumetric, Membership::quartic};

TEST(MembershipFunction, HasThePapersValues) {
  // Half way to R the five functions of [Szirmay10] Fig. 3 are 1 - exp(-1/2), 0, sqrt(1/2), 1/2 and 1/8, and the
  // quartic one is 1/16.
  constexpr double kTolerance = 1e-15;  // rounding
  EXPECT_NEAR(membershipAt(Membership::exponential, 0.5), 1 - std::exp(-0.5), kTolerance);
  EXPECT_EQ(membershipAt(Membership::classical, 0.5), 0);
  EXPECT_NEAR(membershipAt(Membership::squareRoot, 0.5), std::sqrt(0.5), kTolerance);
  EXPECT_EQ(membershipAt(Membership::linear, 0.5), 0.5);
  EXPECT_EQ(membershipAt(Membership::volumetric, 0.5), 0.125);
  EXPECT_EQ(membershipAt(Membership::quartic, 0.5), 0.0625);
}

TEST(MembershipFunction, RisesFromZeroToOne) {
  // Each is 0 at the surface and never falls; the local ones are 1 from R on, the exponential one at infinity.
  for (const Membership membership : kAll) {
    EXPECT_EQ(membershipAt(membership, 0), 0);
    for (double share = 0; share < 2; share += 0.01)
      EXPECT_LE(membershipAt(membership, share), membershipAt(membership, share + 0.01));
    EXPECT_EQ(membershipAt(membership, INFINITY), 1);
    EXPECT_EQ(membershipAt(membership, 1) == 1, isLocal(membership));
  }
}

TEST(MembershipFunction, IntegratesOverTheHemisphere) {
  // Before a wall, where the distance to it is known for every direction, the estimate of [Szirmay10] Eq. 2 agrees with
  // a midpoint sum over the hemisphere, for each function, on an anisotropic grid and in world units.
  constexpr double kRadius = 6, kDistance = 2, kHeight = 12, kWidth = 10;  // world; the wall is kWidth to either side
  const glm::dvec3 spacing(0.5, 1, 2);
  const TestScene scene({41, 21, 9}, spacing, [](glm::dvec3 p) { return std::max(floorLevel(p, 4), 5 - p.x); });
  const ShadedPoint point = pointOn(glm::dvec3(5 + kDistance, kWidth, 4) / spacing);
  for (const Membership membership : kAll) {
    // Area-preserving, so that the plain mean over the square is the integral over the hemisphere.
    const double want = squareMean(1024, [membership](double u, double v) {
      const glm::dvec3 direction = cosineDirection({u, v});
      const double reach = direction.x < 0 ? -kDistance / direction.x : INFINITY;
      const bool hits = std::abs(direction.y) * reach < kWidth && direction.z * reach < kHeight;
      return hits ? membershipAt(membership, reach / kRadius) : 1.0;
    });
    IntegrandSettings settings;
    settings.radiusWorld = kRadius;
    settings.membership = membership;
    const Openness got = openness(scene, point, 1 << 16, settings);
    // The midpoint sum errs where the edge of the wall or of the radius passes: in some of the 4 * 1024 squares that
    // an edge crosses, by a random share of each: sqrt(4 * 1024) / 2 / 1024^2.
    constexpr double kMidpoint = 3.1e-5;
    EXPECT_NEAR(got.value, want, allowed(got.error) + kMidpoint) << static_cast<int>(membership);
    EXPECT_LT(got.error, 1e-3);
    EXPECT_LT(got.value, 0.95);
  }
}

}  // namespace
}  // namespace isolume::test
