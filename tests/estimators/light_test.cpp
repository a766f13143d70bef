// Light from a direction, from a disc, from a map, and by way of the surface.
#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>
#include <vector>

#include "estimators/closed_form.h"
#include "sweep/level.h"
#include "volumes/scenes.h"

namespace isolume::test {
namespace {

constexpr int kRays = 1 << 14;

// A floor at z = 2 under half a slab: the slab covers x < 16 from z = 22 to the top of the grid, and all of y.
constexpr double kFloor = 2, kEdge = 16, kUnderside = 22;
const TestScene& eaves() {
  static const TestScene scene(glm::ivec3(33), glm::dvec3(1), [](glm::dvec3 p) {
    return std::max(floorLevel(p, kFloor), std::min(kEdge - p.x, p.z - kUnderside));
  });
  return scene;
}

TEST(Shadow, IsSharpAtTheEdge) {
  // The shadow of the slab's lower edge ends where the ray from there towards the light's opposite meets the floor: 10
  // samples towards -x under a light that rises by 2 for each 1 towards +x. The lit side gets the cosine.
  IntegrandSettings settings;
  settings.integrand = Integrand::shadow;
  settings.lightDirection = {1, 0, 2};
  const double rim = kEdge - (kUnderside - kFloor) / 2;
  for (const double aside : {-1e-4, 1e-4}) {
    const ChannelEstimate got =
        estimateAt(eaves().scene(), settings, {}, pointOn({rim + aside, 16, kFloor}), 0).channels;
    EXPECT_EQ(got.value[0], aside > 0 ? 1 : 0);
    EXPECT_NEAR(got.value[1], aside > 0 ? 2 / std::sqrt(5.0) : 0, 1e-15);
    EXPECT_EQ(got.standardError[0], 0);
  }
}

TEST(Light, PenumbraIsTheVisibleShareOfItsDisc) {
  // A straight edge passes the disc at an angle d from its centre: at angular distance t from the centre a share
  // acos(-tan(d) / tan(t)) / pi of the circle is beyond it. Under the slab its lower edge counts.
  constexpr double kLightRadius = 8;  // degrees
  IntegrandSettings settings;
  settings.integrand = Integrand::light;
  settings.lightDirection = {0, 0, 5};
  settings.lightRadiusDegrees = kLightRadius;
  const double radius = glm::radians(kLightRadius);
  for (const double under : {0.1, 1.0, 2.5}) {
    const double angle = -std::atan(under / (kUnderside - kFloor));  // the centre is covered
    constexpr int kSteps = 100000;                                   // the midpoint sum errs by 1e-8 of the whole
    double want = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double t = radius * (i + 0.5) / kSteps;
      const double share = std::acos(std::clamp(-std::tan(angle) / std::tan(t), -1.0, 1.0)) / kPi;
      want += share * std::sin(t) * radius / kSteps / (1 - std::cos(radius));
    }
    const ChannelEstimate got =
        estimateAt(eaves().scene(), settings, {.rays = kRays}, pointOn({kEdge - under, 16, kFloor}), 0).channels;
    EXPECT_NEAR(got.value[0], want, allowed(got.standardError[0])) << under;
    EXPECT_LT(got.standardError[0], 2e-3);
    EXPECT_GT(want, 0.01);
  }
}

TEST(Light, WholeDiscGivesItsMeanCosine) {
  // Unobstructed, a disc about the normal gives the mean cosine over its cap, (1 + cos(radius)) / 2.
  IntegrandSettings settings;
  settings.integrand = Integrand::light;
  settings.lightRadiusDegrees = 60;
  const TestScene plane(glm::ivec3(9), glm::dvec3(1), [](glm::dvec3 p) { return floorLevel(p, 4); });
  const ChannelEstimate got = estimateAt(plane.scene(), settings, {.rays = kRays}, pointOn({4, 4, 4}), 0).channels;
  EXPECT_EQ(got.value[0], 1);
  EXPECT_NEAR(got.value[1], 0.75, allowed(got.standardError[1]));
  EXPECT_LT(got.standardError[1], 1e-4);
}

TEST(Light, TurnsWithTheWorld) {
  // The light's direction is the world's: in a world whose x is the grid's -x it comes from the other side.
  IntegrandSettings settings;
  settings.integrand = Integrand::shadow;
  settings.lightDirection = {1, 0, 2};
  const ShadedPoint point = pointOn({kEdge - 2, 16, kFloor});
  const glm::dmat3 mirror(glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1));
  EXPECT_EQ(estimateAt(eaves().scene(), settings, {}, point, 0).channels.value[0], 1);
  EXPECT_EQ(estimateAt({eaves().tracer, mirror}, settings, {}, point, 0).channels.value[0], 0);
}

TEST(Light, FollowsARotatedGrid) {
  // A quarter turn takes the grid's x to the world's y: a light from the world's (0, 1, 2) is the grid's (1, 0, 2). The
  // turn is not its own inverse, so a transposed matrix puts the light at the world's -y, where the slab hides it.
  IntegrandSettings settings;
  settings.integrand = Integrand::shadow;
  settings.lightDirection = {0, 1, 2};
  const ShadedPoint point = pointOn({kEdge - 2, 16, kFloor});
  const glm::dmat3 turn(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
  const ChannelEstimate got = estimateAt({eaves().tracer, turn}, settings, {}, point, 0).channels;
  EXPECT_EQ(got.value[0], 1);
  EXPECT_NEAR(got.value[1], 2 / std::sqrt(5.0), 1e-15);
  settings.lightDirection = {0, -1, 2};
  EXPECT_EQ(estimateAt({eaves().tracer, turn}, settings, {}, point, 0).channels.value[0], 0);
}

TEST(Bounce, FurnaceGivesOne) {
  // Albedo 1 under a white sky: as much light leaves as arrives, so that every path that escapes brings 1. In the
  // corner of floor and wall fewer than 6 of 10 rays meet the solid again: none of these stays for 64 bounces.
  const TestScene corner(glm::ivec3(17), glm::dvec3(1),
                         [](glm::dvec3 p) { return std::max(floorLevel(p, 4), 5 - p.x); });
  IntegrandSettings settings;
  settings.integrand = Integrand::bounce;
  settings.bounces = 64;
  const ChannelEstimate got = estimateAt(corner.scene(), settings, {.rays = 4096}, pointOn({5.5, 8, 4}), 0).channels;
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(got.value[c], 1);
    EXPECT_EQ(got.standardError[c], 0);
  }
}

TEST(Bounce, PathsLeaveWhateverSurfaceTheyMeet) {
  // The same on surfaces at all angles to the grid, where no hit is a round number: a path that met the spot it stands
  // on again would stay for ever. Of a few hundred points and 64 reflections one path in a thousand may be that long.
  Grid<float> level = sampleScene(*findScene("corner"), 40);
  makeLevel(level.view(), 0, Inside::below);
  const SurfaceTracer tracer(level.view());
  IntegrandSettings settings;
  settings.integrand = Integrand::bounce;
  settings.bounces = 64;
  double sum = 0;
  int points = 0;
  for (int i = 0; i < 400; ++i) {
    const GridRay down{{8.3 + i % 20 * 1.45, 8.1 + i / 20 * 1.35, 39}, {0.01, 0.02, -1}, 0, 100};
    const std::optional<SurfacePoint> hit = tracer.firstHit(down);
    if (!hit) continue;
    const ShadedPoint point{*hit, shadingNormal(tracer, *hit, ReferenceNormals::exact, {0, 0, 1})};
    sum += estimateAt({tracer}, settings, {.rays = 32}, point, static_cast<std::uint64_t>(i)).channels.value[0];
    ++points;
  }
  ASSERT_GT(points, 300);
  EXPECT_GT(sum / points, 0.999);
}

TEST(Bounce, ClosedCavityStaysDark) {
  // No path leaves a closed box, however many reflections it may have.
  const TestScene box(glm::ivec3(17), glm::dvec3(1), [](glm::dvec3 p) {
    const glm::dvec3 wall = glm::abs(p - 8.0) - 5.0;
    return std::max({wall.x, wall.y, wall.z});
  });
  IntegrandSettings settings;
  settings.integrand = Integrand::bounce;
  settings.bounces = 32;
  EXPECT_EQ(estimateAt(box.scene(), settings, {.rays = 1024}, pointOn({8, 8, 3}), 0).channels.value[0], 0);
}

TEST(Bounce, AddsTheLightOfEachReflection) {
  // Without reflections it is the openness, bit for bit; the light of one reflection grows in proportion to the albedo
  // of its own channel (the same paths); and more reflections never take light away.
  const TestScene corner(glm::ivec3(17), glm::dvec3(1),
                         [](glm::dvec3 p) { return std::max(floorLevel(p, 4), 5 - p.x); });
  const ShadedPoint point = pointOn({6, 8, 4});
  const auto light = [&](int bounces) {
    IntegrandSettings settings;
    settings.integrand = Integrand::bounce;
    settings.bounces = bounces;
    settings.albedo = {0.25, 0.5, 1};
    return estimateAt(corner.scene(), settings, {.rays = 4096}, point, 0).channels.value;
  };
  const double open = openness(corner, point, 4096).value;
  const Channels none = light(0), one = light(1), two = light(2);
  EXPECT_EQ(none[0], open);
  constexpr double kRounding = 1e-12;  // sums of 4096 terms
  EXPECT_GT(one[2] - open, 0.1);
  EXPECT_NEAR((one[0] - open) * 4, one[2] - open, kRounding);
  EXPECT_NEAR((one[1] - open) * 2, one[2] - open, kRounding);
  for (int c = 0; c < 3; ++c) EXPECT_GT(two[c], one[c]);
}

TEST(Bounce, OneReflectionMatchesNestedIntegration) {
  // E_1 = E_0 + albedo / pi * integral over the wall of its own E_0: by hand, the wall's openness is known in closed
  // form, so a plain mean over directions gives the second term.
  constexpr int kSize = 33, kWall = 5, kFloor4 = 4, kY = 16;
  const TestScene corner(glm::ivec3(kSize), glm::dvec3(1),
                         [](glm::dvec3 p) { return std::max(floorLevel(p, kFloor4), kWall - p.x); });
  constexpr double kDistance = 3, kHeight = kSize - 1 - kFloor4, kReach = kSize - 1 - kWall;
  const auto wallOpenness = [](double y, double z) {  // above the floor of that reach; z above the floor
    return 1 - uprightRectangle(kY - y, kReach, z) - uprightRectangle(kY + y, kReach, z);
  };
  const double reflected = squareMean(512, [&](double u, double v) {
    const double height = std::sqrt(1 - u), across = std::sqrt(u);
    const double x = across * std::cos(2 * kPi * v), y = across * std::sin(2 * kPi * v);
    if (x >= 0) return 0.0;
    const double reach = -kDistance / x, hitY = y * reach, hitZ = height * reach;
    return std::abs(hitY) < kY && hitZ < kHeight ? wallOpenness(hitY, hitZ) : 0.0;
  });
  const double direct = 1 - 2 * uprightRectangle(kY, kHeight, kDistance);
  IntegrandSettings settings;
  settings.integrand = Integrand::bounce;
  settings.bounces = 1;
  settings.albedo = glm::dvec3(0.6);
  settings.normals = ReferenceNormals::exact;  // the smoothed gradient would turn the wall's normal next to the floor
  const ChannelEstimate got =
      estimateAt(corner.scene(), settings, {.rays = 1 << 16}, pointOn({kWall + kDistance, kY, kFloor4}), 0).channels;
  // The midpoint sum errs along the edge of the wall as in membership_test.cpp: sqrt(4 * 512) / 2 / 512^2.
  constexpr double kMidpoint = 9e-5;
  EXPECT_NEAR(got.value[1], direct + 0.6 * reflected, allowed(got.standardError[1]) + kMidpoint);
  EXPECT_LT(got.standardError[1], 2e-3);
  EXPECT_GT(0.6 * reflected, 0.03);
}

}  // namespace
}  // namespace isolume::test
