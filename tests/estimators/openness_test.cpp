// Openness where it is known in closed form.
#include <gtest/gtest.h>

#include <array>
#include <glm/trigonometric.hpp>

#include "estimators/closed_form.h"

namespace isolume::test {
namespace {

constexpr int kRays = 1 << 16;

TEST(Openness, OpenPlaneIsOne) {
  // No ray that leaves a plane meets it again, whatever its tilt: 1 to the last bit, with error 0.
  for (const glm::dvec3 normal : {glm::dvec3(0, 0, 1), glm::dvec3(0.3, -0.2, 0.9), glm::dvec3(-2, 1, 0.1)}) {
    const glm::dvec3 n = glm::normalize(normal), centre(10.3, 9.7, 10.1);
    const TestScene scene(glm::ivec3(21), glm::dvec3(1), [&](glm::dvec3 p) { return glm::dot(n, centre - p); });
    // From above the centre down onto the plane: a hit as the pictures have it.
    const auto hit = scene.tracer.firstHit({centre + 5.0 * n, -n});
    ASSERT_TRUE(hit);
    const ShadedPoint point{*hit, shadingNormal(scene.tracer, *hit, ReferenceNormals::data, n)};
    // Levels are floats: the interpolated plane is off by 2^-24 of the largest, and so is its normal.
    EXPECT_LT(glm::length(point.normal - n), 1e-6);
    // Directions closer to the plane than that normal's error may enter it: none of 65536 does.
    const Openness got = openness(scene, point, kRays);
    EXPECT_EQ(got.value, 1);
    EXPECT_EQ(got.error, 0);
  }
}

TEST(Openness, FootOfAWallIsHalf) {
  // In the corner between floor and wall every direction towards the wall enters it at once: half the light is left.
  const TestScene scene(glm::ivec3(17), glm::dvec3(1),
                        [](glm::dvec3 p) { return std::max(floorLevel(p, 4), 5 - p.x); });
  const Openness got = openness(scene, pointOn({5, 8, 4}), kRays);
  EXPECT_NEAR(got.value, 0.5, allowed(got.error));
  EXPECT_LT(got.error, 1e-3);  // a straight edge through the square: low-discrepancy points do far better than 1/512
}

TEST(Openness, FloorBeforeAWall) {
  // At distance c from a wall of known size the closed form of the upright rectangle holds, to the left and right of
  // the point; the wall ends at the faces of the grid.
  constexpr int kSize = 33, kWall = 5, kFloor = 4, kY = 12;
  const TestScene scene(glm::ivec3(kSize), glm::dvec3(1),
                        [](glm::dvec3 p) { return std::max(floorLevel(p, kFloor), kWall - p.x); });
  for (const double distance : {0.25, 1.0, 3.5, 10.0}) {
    const double height = kSize - 1 - kFloor;
    const double want = 1 - uprightRectangle(kY, height, distance) - uprightRectangle(kSize - 1 - kY, height, distance);
    const Openness got = openness(scene, pointOn({kWall + distance, kY, kFloor}), kRays);
    EXPECT_NEAR(got.value, want, allowed(got.error)) << distance;
    EXPECT_LT(got.error, 1e-3);
  }
}

TEST(Openness, FloorUnderAParallelRectangle) {
  // Under a corner of a slab the closed form of the parallel rectangle holds.
  constexpr int kFloor = 2, kSlab = 9, kFrom = 8, kTo = 22;
  const TestScene scene({33, 33, 17}, glm::dvec3(1), [](glm::dvec3 p) {
    const double slab = std::min({p.x - kFrom, kTo - p.x, p.y - kFrom, kTo - p.y, p.z - kSlab, kSlab + 3 - p.z});
    return std::max(floorLevel(p, kFloor), slab);
  });
  const double side = kTo - kFrom;
  // The sides of the slab stand upright over the corner: none of them is seen from there.
  const Openness corner = openness(scene, pointOn({kFrom, kFrom, kFloor}), kRays);
  EXPECT_NEAR(corner.value, 1 - parallelRectangle(side, side, kSlab - kFloor), allowed(corner.error));
  const Openness middle = openness(scene, pointOn({(kFrom + kTo) / 2.0, (kFrom + kTo) / 2.0, kFloor}), kRays);
  EXPECT_NEAR(middle.value, 1 - 4 * parallelRectangle(side / 2, side / 2, kSlab - kFloor), allowed(middle.error));
  EXPECT_LT(middle.error, 1e-3);
}

TEST(Openness, FloorUnderADisc) {
  // Under the centre of a disc of radius R at height h: 1 - R^2 / (R^2 + h^2). The rim of the interpolated disc lies
  // within one sample inside R (where it rounds the lower edge), so that the closed forms of R - 1 and R enclose it.
  constexpr double kRadius = 60, kHeight = 30;
  const glm::dvec2 centre(64, 64);
  const TestScene scene({129, 129, 40}, glm::dvec3(1), [&](glm::dvec3 p) {
    const double disc = std::min(kRadius - glm::length(glm::dvec2(p) - centre), p.z - (kHeight + 2));
    return std::max(floorLevel(p, 2), disc);
  });
  const auto open = [](double radius) { return 1 - radius * radius / (radius * radius + kHeight * kHeight); };
  const Openness got = openness(scene, pointOn({64, 64, 2}), kRays);
  EXPECT_GE(got.value, open(kRadius) - allowed(got.error));
  EXPECT_LE(got.value, open(kRadius - 1) + allowed(got.error));
  EXPECT_LT(got.error, 1e-3);
}

TEST(Openness, FloorUnderASphere) {
  // While the sphere stays above the horizon: 1 - (r / d)^2 cos(theta). The interpolated sphere is smaller by at most
  // 1 / (4 r) samples (the linear interpolant's error on a second derivative of 2 / r), so its share of light by
  // 1 / (2 r^2) of itself.
  constexpr double kRadius = 16;
  const glm::dvec3 centre(40, 40, 30);
  const TestScene scene({81, 81, 50}, glm::dvec3(1),
                        [&](glm::dvec3 p) { return std::max(floorLevel(p, 2), kRadius - glm::length(p - centre)); });
  for (const double aside : {0.0, 12.5, 30.0}) {
    const glm::dvec3 point(centre.x + aside, centre.y, 2);
    const double distance = glm::length(centre - point), cosine = (centre.z - point.z) / distance;
    const double blocked = kRadius * kRadius / (distance * distance) * cosine;
    const Openness got = openness(scene, pointOn(point), kRays);
    EXPECT_NEAR(got.value, 1 - blocked, allowed(got.error) + blocked / (2 * kRadius * kRadius)) << aside;
    EXPECT_LT(got.error, 1e-3);
  }
}

TEST(Openness, ClosedBoxIsZero) {
  // Inside a hollow box nothing is open: 0 to the last bit, on floor, wall and in the corner.
  const TestScene scene(glm::ivec3(17), glm::dvec3(1), [](glm::dvec3 p) {
    const glm::dvec3 wall = glm::abs(p - 8.0) - 5.0;
    return std::max({wall.x, wall.y, wall.z});
  });
  for (const ShadedPoint& point :
       {pointOn({8.25, 6.5, 3}), pointOn({3, 6.5, 7}, {1, 0, 0}), pointOn({3, 3, 3}, glm::normalize(glm::dvec3(1)))}) {
    const Openness got = openness(scene, point, 4096);
    EXPECT_EQ(got.value, 0);
    EXPECT_EQ(got.error, 0);
  }
}

TEST(Openness, DependsOnThePhysicalShapeAlone) {
  // The same solid on a grid of spacing 1 and on one of spacing (1/2, 2, 4): the same rays in world units, the same
  // openness, with and without a radius; 3 of the rays may pass an edge on the other side by rounding.
  const auto shape = [](glm::dvec3 p) {
    const double box = std::min({p.x - 8, 12 - p.x, p.y - 8, 16 - p.y, p.z - 8, 16 - p.z});
    return std::max({floorLevel(p, 4), 4 - p.x, box});
  };
  const glm::dvec3 spacing(0.5, 2, 4), world(7.5, 14, 4);
  const TestScene plain(glm::ivec3(33), glm::dvec3(1), shape), stretched({65, 17, 9}, spacing, shape);
  constexpr int kFew = 4096;
  IntegrandSettings linear;
  linear.radiusWorld = 9;
  linear.membership = Membership::linear;
  for (const IntegrandSettings& settings : {IntegrandSettings{}, linear}) {
    const double want = openness(plain, pointOn(world), kFew, settings).value;
    EXPECT_GT(want, 0.1);
    EXPECT_LT(want, 0.9);
    EXPECT_NEAR(openness(stretched, pointOn(world / spacing), kFew, settings).value, want, 3.0 / kFew);
  }
}

TEST(Openness, MirroredSolidHasTheSameOpenness) {
  // Mirroring the data and the point changes the samples but not what they estimate.
  const auto shape = [](glm::dvec3 p) {
    const double box = std::min({p.x - 18, 24 - p.x, p.y - 10, 20 - p.y, p.z - 10, 16 - p.z});
    return std::max({floorLevel(p, 4), p.x - 28, box});
  };
  const TestScene scene(glm::ivec3(33), glm::dvec3(1), shape);
  const TestScene mirrored(glm::ivec3(33), glm::dvec3(1), [&shape](glm::dvec3 p) {
    return shape({32 - p.x, p.y, p.z});
  });
  const Openness want = openness(scene, pointOn({20.3, 11.2, 4}), kRays);
  const Openness got = openness(mirrored, pointOn({32 - 20.3, 11.2, 4}), kRays);
  EXPECT_NEAR(got.value, want.value, allowed(std::hypot(got.error, want.error)));
  EXPECT_LT(want.error, 1e-3);
}

}  // namespace
}  // namespace isolume::test
