// Hits whose place is known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "reference/random_rays.h"
#include "support/test_levels.h"
#include "sweep/reference/surface_tracer.h"

namespace isolume::test {
namespace {

constexpr std::uint64_t kRays = 100'000;

// Solid below a tilted plane; every sample, and so the interpolant, is exact.
const glm::dvec3 kPlaneGradient(0.25, 0.5, -1);
Grid<float> planeLevel() {
  return sampleLevel({20, 17, 33}, glm::dvec3(1), [](glm::dvec3 p) { return 4.375 + glm::dot(kPlaneGradient, p); });
}

TEST(PlaneHits, ClosedForm) {
  // On a plane the hit lies where the plane is, to the rounding of coordinates, and the gradients are the plane's.
  const Grid<float> level = planeLevel();
  const SurfaceTracer tracer(level.view());
  int hits = 0;
  for (std::uint64_t i = 0; i < kRays; ++i) {
    const GridRay ray = randomRay(level.size(), i);
    const auto hit = tracer.firstHit(ray);
    if (!hit || hit->capAxis >= 0) continue;
    ++hits;
    const double slope = glm::dot(kPlaneGradient, ray.direction);
    const double t = -(4.375 + glm::dot(kPlaneGradient, ray.origin)) / slope;
    // 2^-52 of the largest coordinate of a ray, 2^14, on either side, over the sine of the angle to the plane.
    ASSERT_NEAR(hit->t, t, 1e-11 / std::abs(slope)) << i;
    ASSERT_NEAR(tracer.levelAt(hit->position), 0, 1e-12) << i;
    ASSERT_NEAR(glm::distance(tracer.cellGradient(hit->position), kPlaneGradient), 0, 1e-13) << i;
    ASSERT_NEAR(glm::distance(tracer.smoothGradient(hit->position), kPlaneGradient), 0, 1e-12) << i;
  }
  EXPECT_GT(hits, 15'000);
}

TEST(PlaneHits, NextHitNeverMeetsItsOwnPlane) {
  // From a point of a plane every ray that does not go into the solid is open, tangents too, and every other is blocked
  // at once.
  const Grid<float> level = planeLevel();
  const SurfaceTracer tracer(level.view());
  const glm::dvec3 tangents[] = {{2, 1, 1}, {4, 0, 1}, {0, 2, 1}, {-2, 1, 0}, {-8, 2, -1}};
  int open = 0, blocked = 0;
  for (std::uint64_t i = 0; i < kRays; ++i) {
    const auto hit = tracer.firstHit(randomRay(level.size(), i));
    if (!hit || hit->capAxis >= 0) continue;
    Random random(~i);
    GridRay ray;
    ray.origin = hit->position;
    // Half at any angle, half nearly or just along the plane; the coarse tangents are exact.
    ray.direction = random.direction();
    if (i % 2 == 0) {
      const double lift = i % 4 == 0 ? 0 : std::exp(random.uniform(-30, -10));
      ray.direction = tangents[random.below(5)] - lift * kPlaneGradient;
    }
    const double inwards = glm::dot(kPlaneGradient, ray.direction);
    // At its end in the box, some 40 voxels on, a ray flatter than this is not above the rounding of points.
    if (inwards > 0 && inwards < 1e-9) continue;
    const auto next = tracer.nextHit(ray, *hit);
    ASSERT_EQ(tracer.isBlocked(ray, *hit), next.has_value());
    if (inwards <= 0) {
      ASSERT_FALSE(next) << i << ": blocked at " << next->t << " with " << inwards;
      ++open;
    } else if (next) {
      ASSERT_LE(next->t * inwards, 1e-9) << i;
      ++blocked;
    } else {
      // Nothing but the box may let it go: it leaves there at once.
      const glm::dvec3 high(level.size() - 1), on = ray.origin + 1e-9 * ray.direction;
      ASSERT_TRUE(on != glm::clamp(on, glm::dvec3(0), high)) << i;
    }
  }
  EXPECT_GT(open, 10'000);
  EXPECT_GT(blocked, 3'000);
}

TEST(BallHits, ClosedForm) {
  // Rays at a sampled ball hit it where the ball is, to the error of interpolation; they miss where they pass it.
  const double radius = 12;
  const glm::dvec3 centre(15.3, 14.6, 15.1);
  const Grid<float> level = ballLevel(31, radius, centre);
  const SurfaceTracer tracer(level.view());
  // An eighth of the sum of the second derivatives of the distance, 2 / r, where r > radius - 1; and float samples.
  const double bound = 1 / (4 * (radius - 1)) + 1e-6;
  int hits = 0, passes = 0;
  for (std::uint64_t i = 0; i < kRays; ++i) {
    const GridRay ray = randomRay(level.size(), i);
    if (glm::distance(ray.origin, centre) < radius + bound) continue;
    const double toNearest = glm::dot(centre - ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
    const double nearest = glm::distance(centre, ray.origin + std::max(0.0, toNearest) * ray.direction);
    const auto hit = tracer.firstHit(ray);
    if (nearest > radius + bound) {
      ASSERT_FALSE(hit) << i;
      ++passes;
    } else if (nearest < radius - bound) {
      ASSERT_TRUE(hit) << i;
      ASSERT_NEAR(glm::distance(hit->position, centre), radius, bound) << i;
      ASSERT_LT(hit->t, toNearest) << i << ": the far side of the ball";
      ++hits;
    }
  }
  EXPECT_GT(hits, 10'000);
  EXPECT_GT(passes, 10'000);
}

TEST(BallHits, FromInside) {
  // From the centre of a ball every ray leaves it at the radius.
  const double radius = 12;
  const Grid<float> level = ballLevel(31, radius, glm::dvec3(15));
  const SurfaceTracer tracer(level.view());
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    GridRay ray;
    ray.origin = glm::dvec3(15);
    ray.direction = Random(i).direction();
    const auto hit = tracer.firstHit(ray);
    ASSERT_TRUE(hit);
    ASSERT_EQ(hit->capAxis, -1);
    ASSERT_NEAR(hit->t, radius, 1 / (4 * (radius - 1)) + 1e-6) << i;
  }
}

TEST(CapHits, SolidBox) {
  // A grid that is all solid is a box: hit from outside and left from inside on its faces; a ray from a cap is blocked
  // unless it leaves the box.
  const Grid<float> level = sampleLevel({5, 9, 4}, glm::dvec3(1), [](glm::dvec3) { return 1; });
  const SurfaceTracer tracer(level.view());
  for (std::uint64_t i = 0; i < kRays; ++i) {
    const GridRay ray = randomRay(level.size(), i);
    const auto hit = tracer.firstHit(ray);
    if (!hit) continue;
    const int axis = hit->capAxis;
    ASSERT_GE(axis, 0) << i;
    const double high = level.size()[axis] - 1;
    ASSERT_TRUE(hit->position[axis] == 0 || hit->position[axis] == high) << i;
    ASSERT_NEAR(glm::distance(ray.origin + hit->t * ray.direction, hit->position), 0, 1e-11) << i;
    GridRay on;
    on.origin = hit->position;
    on.direction = Random(~i).direction();
    bool leaves = false;
    for (int k = 0; k < 3; ++k)
      leaves |= on.direction[k] > 0 ? hit->position[k] == level.size()[k] - 1 : hit->position[k] == 0;
    ASSERT_EQ(tracer.isBlocked(on, *hit), !leaves) << i;
    const auto next = tracer.nextHit(on, *hit);
    ASSERT_EQ(next.has_value(), !leaves) << i;
    if (next) {
      ASSERT_EQ(next->t, 0) << i;
    }
    on.direction[axis] = 0;
    on.direction[(axis + 1) % 3] = 0;
    const int along = (axis + 2) % 3;
    const bool inside = hit->position[along] > 0 && hit->position[along] < level.size()[along] - 1;
    if (inside) {
      ASSERT_TRUE(tracer.isBlocked(on, *hit)) << "along the cap " << i;
    }
  }
}

TEST(FlatHits, SamplesAtTheIsovalue) {
  // A face of samples at the isovalue is outside: a ray within it meets nothing, one a hair on the solid side of it
  // enters at the border, and one across hits it exactly.
  const Grid<float> level = sampleLevel(glm::ivec3(9), glm::dvec3(1), [](glm::dvec3 p) { return 4 - p.z; });
  const SurfaceTracer tracer(level.view());
  EXPECT_FALSE(tracer.firstHit({{-3, 2.5, 4}, {1, 0, 0}}));
  EXPECT_FALSE(tracer.firstHit({{-3, 2, 4}, {1, 0, 0}}));
  const auto below = tracer.firstHit({{-3, 2.5, 4 - 0x1p-40}, {1, 0, 0}});
  ASSERT_TRUE(below);
  EXPECT_EQ(below->capAxis, 0);
  EXPECT_EQ(below->t, 3);
  const auto across = tracer.firstHit({{2.25, 2, 20}, {0, 0, -1}});
  ASSERT_TRUE(across);
  EXPECT_EQ(across->position, glm::dvec3(2.25, 2, 4));
  EXPECT_EQ(across->t, 16);
  EXPECT_FALSE(tracer.nextHit({across->position, {1, 0.5, 0}}, *across)) << "along the face";
  EXPECT_FALSE(tracer.nextHit({across->position, {0, 0, 1}}, *across));
  EXPECT_TRUE(tracer.isBlocked({across->position, {0, 0, -1}}, *across));
}

TEST(RayRange, StartAndEnd) {
  // A hit counts within [start, end] alone, and a longer direction only makes t shorter.
  const Grid<float> level = ballLevel(31, 9, glm::dvec3(15));
  const SurfaceTracer tracer(level.view());
  GridRay ray{{-20, 13.7, 16.1}, {1, 0.0625, -0.03125}};
  const auto whole = tracer.firstHit(ray);
  ASSERT_TRUE(whole);
  ray.end = whole->t - 1e-9;
  EXPECT_FALSE(tracer.firstHit(ray));
  ray.end = whole->t + 1e-9;
  const auto cut = tracer.firstHit(ray);
  ASSERT_TRUE(cut);
  EXPECT_NEAR(cut->t, whole->t, 1e-12);
  ray.end = 1e9;
  ray.start = whole->t + 1;
  const auto behind = tracer.firstHit(ray);
  ASSERT_TRUE(behind) << "a start inside finds the far side";
  EXPECT_GT(behind->t, whole->t + 10);
  ray.start = behind->t + 1e-9;
  EXPECT_FALSE(tracer.firstHit(ray));
  const auto twice = tracer.firstHit({{-20, 13.7, 16.1}, {2, 0.125, -0.0625}});
  ASSERT_TRUE(twice);
  EXPECT_EQ(twice->t * 2, whole->t);
  EXPECT_EQ(twice->position, whole->position);
}

TEST(RayRange, EndOfARayOn) {
  // Between a floor and a ceiling a ray on is blocked by the other one if that lies before its end.
  const Grid<float> level =
      sampleLevel(glm::ivec3(17), glm::dvec3(1), [](glm::dvec3 p) { return std::abs(p.z - 8) - 3.25; });
  const SurfaceTracer tracer(level.view());
  const auto floor = tracer.firstHit({{7.5, 8.25, 8}, {0, 0, -1}});
  ASSERT_TRUE(floor);
  EXPECT_EQ(floor->position.z, 4.75);
  GridRay up{floor->position, {0.5, -0.25, 1}};
  const auto ceiling = tracer.nextHit(up, *floor);
  ASSERT_TRUE(ceiling);
  EXPECT_NEAR(ceiling->t, 6.5, 1e-10) << "2^-38 of a corner of .75, and rounding";
  EXPECT_TRUE(tracer.isBlocked(up, *floor));
  up.end = 6.5 - 1e-6;
  EXPECT_FALSE(tracer.isBlocked(up, *floor));
  EXPECT_FALSE(tracer.nextHit(up, *floor));
  up.end = 6.5 + 1e-6;
  EXPECT_TRUE(tracer.isBlocked(up, *floor));
}

TEST(EmptyHits, NoSolidNoHit) {
  // Where no sample is inside, no ray hits anything, on the smallest grid too.
  for (const glm::ivec3 size : {glm::ivec3(2), glm::ivec3(70, 3, 66)}) {
    const Grid<float> level = sampleLevel(size, glm::dvec3(1), [](glm::dvec3 p) { return -p.x; });
    const SurfaceTracer tracer(level.view());
    for (std::uint64_t i = 0; i < 10'000; ++i) ASSERT_FALSE(tracer.firstHit(randomRay(size, i))) << i;
  }
}

}  // namespace
}  // namespace isolume::test
