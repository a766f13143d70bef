// Light of discs and skies where it is known in closed form, and bent normals.
#include "sweep/ordinates/light_sweeps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "estimators/closed_form.h"
#include "ordinates/swept_scene.h"
#include "support/random_numbers.h"
#include "sweep/ordinates/sky_ordinates.h"

namespace isolume::test {
namespace {

TEST(CapDirections, FillTheCapEvenly) {
  // Unit vectors within the radius of the axis, whose mean is the axis times (1 + cos r) / 2: along the axis to a
  // rounding, since the heights are midpoints of equal steps, and across it to 1 / count of the radius.
  RandomNumbers numbers(1);
  for (const double radius : {0.25, 5.0, 45.0, 90.0})
    for (const int count : {1, 32, 500}) {
      const glm::dvec3 axis = numbers.direction();
      glm::dvec3 mean(0);
      for (const glm::dvec3& each : capDirections(axis, radius, count)) {
        EXPECT_NEAR(glm::length(each), 1, 1e-12);
        EXPECT_GE(glm::dot(each, axis), std::cos(glm::radians(radius)) - 1e-12);
        mean += each / static_cast<double>(count);
      }
      const double along = glm::dot(mean, axis);
      EXPECT_NEAR(along, (1 + std::cos(glm::radians(radius))) / 2, 1e-12);
      EXPECT_LT(glm::length(mean - along * axis), std::sin(glm::radians(radius)) / count) << radius << " by " << count;
    }
}

// A plane through the middle of the grid, between samples.
SweptScene plane(glm::dvec3 normal, glm::dvec3 spacing, int refinement) {
  constexpr int kSize = 24;
  const glm::dvec3 centre = (glm::dvec3((kSize - 1) / 2.0) + glm::dvec3(0.1, 0.23, 0.31)) * spacing;
  return SweptScene(glm::ivec3(kSize), spacing, refinement, [=](glm::dvec3 p) { return glm::dot(normal, centre - p); });
}

TEST(DiscLight, AnOpenPlaneSeesAllOfIt) {
  // Every sample next to a plane, four and more voxels from the border, sees all of a disc of any size, down to the
  // horizon; its light is the mean clamped cosine, and with the whole disc above the horizon that of the closed form.
  RandomNumbers numbers(2);
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 normal = numbers.direction(), spacing = i % 2 == 0 ? glm::dvec3(1) : glm::dvec3(1, 1.5, 2);
    glm::dvec3 towards = numbers.direction();
    towards *= glm::dot(towards, normal) < 0 ? -1 : 1;
    constexpr double kRadii[] = {0.5, 5, 30, 90};
    const double radius = kRadii[i % 4];
    SCOPED_TRACE(testing::Message() << "tilt " << i << " radius " << radius);
    const SweptScene scene = plane(normal, spacing, 1 + i / 2 % 2);
    const SurfaceLight disc = sweepDisc(scene.rays, 3.0 * towards, radius, 200);
    EXPECT_EQ(disc.field.full, 1);
    const double cosine = glm::dot(towards, normal);
    for (std::size_t f = 0; f < scene.feet().size(); ++f) {
      const SurfaceFoot& foot = scene.feet()[f];
      if (!scene.isWithin(foot, 4)) continue;
      const glm::ivec3 at(glm::round(foot.position));
      EXPECT_NEAR(lightAt(disc.field, glm::dvec3(at)), 1, 0.01);
      if (cosine > std::sin(glm::radians(radius)) + 0.01) {
        EXPECT_NEAR(disc.light[f], cosine * (1 + std::cos(glm::radians(radius))) / 2, 0.01);
      }
    }
  }
}

TEST(DiscLight, IsDarkBelowTheHorizon) {
  // A disc that lies below a plane lights none of its feet, and what lies half below it does as much as is above.
  const SweptScene scene = plane({0, 0, 1}, glm::dvec3(1), 1);
  const SurfaceLight below = sweepDisc(scene.rays, {1, 0, -1}, 40, 200),
                     across = sweepDisc(scene.rays, {1, 0, 0}, 40, 200);
  // Half a disc on the horizon: the mean of max(cos, 0) over it, (r - sin r cos r) / (2 pi (1 - cos r)).
  const double r = glm::radians(40.0), half = (r - std::sin(r) * std::cos(r)) / (2 * kPi * (1 - std::cos(r)));
  int feet = 0;
  for (std::size_t f = 0; f < scene.feet().size(); ++f) {
    if (!scene.isWithin(scene.feet()[f], 2)) continue;
    ++feet;
    EXPECT_EQ(below.light[f], 0);
    EXPECT_NEAR(across.light[f], half, 0.005);
  }
  EXPECT_GT(feet, 100);
}

TEST(DiscLight, GivesTheWholeCapAtTheTopOfTheGridItsLight) {
  // A solid that fills the lower half of the grid or all of it: caps see a disc straight over them as planes do, on all
  // six faces.
  for (int face = 0; face < 6; ++face) {
    glm::dvec3 normal(0);
    normal[face / 2] = face % 2 == 0 ? 1 : -1;
    const SweptScene scene(glm::ivec3(9), glm::dvec3(1), 1, [](glm::dvec3) { return 1; });
    const SurfaceLight disc = sweepDisc(scene.rays, normal, 5, 40);
    const glm::dvec3 middle = glm::dvec3(4) + 4.0 * normal;
    EXPECT_NEAR(lightAt(disc.field, middle), 1, 1e-4) << face;
  }
}

TEST(DiscLight, ABallHasNoDarkRim) {
  // The share of a small sun that a ball sees is 1 up to where the normal turns away from its centre: samples beyond
  // take what their neighbours have, so that none darkens the rim by interpolation. To .02.
  const SweptScene scene(ballLevel(33, 11, {16.3, 15.8, 16.1}), 1);
  const glm::dvec3 towards = glm::normalize(glm::dvec3(1, 0.4, -0.3));
  const SurfaceLight disc = sweepDisc(scene.rays, towards, 2, 64);
  int rim = 0;
  for (const SurfaceFoot& foot : scene.feet()) {
    const double cosine = glm::dot(glm::dvec3(foot.normal), towards);
    if (cosine < 0) continue;
    EXPECT_GT(lightAt(disc.field, glm::dvec3(foot.position)), 0.98) << cosine;
    rim += cosine < 0.05 ? 1 : 0;
  }
  EXPECT_GT(rim, 20);
}

// A floor at z = 4 under a slab that covers x < 24.5, a voxel thick above z = 24, over all of y.
constexpr double kFloor = 4, kEdge = 24.5, kUnderside = 24;
SweptScene eaves(int refinement) {
  return SweptScene({49, 25, 33}, glm::dvec3(1), refinement, [](glm::dvec3 p) {
    return std::max(floorLevel(p, kFloor), std::min({kEdge - p.x, p.z - kUnderside, kUnderside + 4 - p.z}));
  });
}

// Of a disc of angular radius r whose centre a straight edge passes at an angle d on the visible side: the share of
// its light, for a disc over the surface, that is seen. At angle t from the centre acos(-tan(d) / tan(t)) / pi of a
// circle.
double seenShare(double d, double radius) {
  constexpr int kSteps = 20000;
  double sum = 0, all = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = radius * (i + 0.5) / kSteps, weight = std::sin(t) * std::cos(t);
    sum += weight * std::acos(std::clamp(-std::tan(d) / std::tan(t), -1.0, 1.0)) / kPi;
    all += weight;
  }
  return sum / all;
}

TEST(DiscLight, PenumbraOfAnEdge) {
  // Under an edge 20 voxels up the share of a disc straight above follows the closed form across the whole penumbra:
  // everywhere between the values half a voxel to either side (and .02 for 1024 directions, which see an edge in
  // steps), and on the mean to .015.
  for (const int refinement : {1, 2})
    for (const double radius : {8.0, 15.0}) {
      const SweptScene scene = eaves(refinement);
      const SurfaceLight disc = sweepDisc(scene.rays, {0, 0, 1}, radius, 1024);
      const auto want = [&](double x) {
        return seenShare(std::atan((x - kEdge) / (kUnderside - kFloor)), glm::radians(radius));
      };
      double bias = 0;
      int count = 0;
      for (int x = 14; x <= 36; ++x) {
        const double got = lightAt(disc.field, {x, 12, kFloor});
        constexpr double kBlur = 0.5, kSteps = 0.02;
        EXPECT_GT(got, want(x - kBlur) - kSteps) << "x " << x << " radius " << radius << " by " << refinement;
        EXPECT_LT(got, want(x + kBlur) + kSteps) << "x " << x << " radius " << radius << " by " << refinement;
        bias += got - want(x);
        ++count;
      }
      EXPECT_NEAR(bias / count, 0, 0.015);
      EXPECT_LT(want(20), 0.2);
      EXPECT_GT(want(29), 0.8);
    }
}

TEST(SweptSky, AUniformSkyIsTheOpenness) {
  // What a uniform sky gives a floor before a wall is 1 less the rectangle's closed form, in one channel and in three.
  const SweptScene scene({33, 25, 33}, glm::dvec3(1), 2,
                         [](glm::dvec3 p) { return std::max(floorLevel(p, kFloor), 5 - p.x); });
  std::vector<Ordinate> sky = uniformSky(512);
  for (Ordinate& each : sky) each.value = {each.value[0], 2 * each.value[0], 0, 0};
  for (const int channels : {1, 3}) {
    const std::vector<SurfaceLight> light = sweepSky(scene.rays, sky, channels);
    ASSERT_EQ(light.size(), static_cast<std::size_t>(channels));
    for (const double distance : {1.0, 5.0, 10.0}) {
      const double want = 1 - 2 * uprightRectangle(12, 32 - kFloor, distance);
      const glm::dvec3 at(5 + distance, 12, kFloor);
      EXPECT_NEAR(lightAt(light[0].field, at), want, 0.02) << distance;
      if (channels == 1) continue;
      EXPECT_NEAR(lightAt(light[1].field, at), 2 * want, 0.04) << distance;
      EXPECT_EQ(lightAt(light[2].field, at), 0);
    }
  }
}

glm::dvec3 bentAt(const std::array<SurfaceField, 3>& bent, glm::dvec3 position) {
  glm::dvec3 found;
  for (int axis = 0; axis < 3; ++axis)
    found[axis] = bentComponent(static_cast<float>(surfaceValueAt(bent[static_cast<std::size_t>(axis)], position)));
  return found;
}

TEST(BentNormals, AnOpenPlaneHasItsNormal) {
  // The mean direction of a hemisphere is half its axis: N / 2 to .02, and the cone is a hemisphere, in any frame.
  RandomNumbers numbers(3);
  for (int i = 0; i < 10; ++i) {
    const glm::dvec3 normal = numbers.direction();
    const glm::dmat3 worldFromAxes(glm::rotate(glm::dmat4(1), 0.3 * i, numbers.direction()));
    const SweptScene scene = plane(normal, glm::dvec3(1), 1);
    const auto bent = sweepBentNormals(scene.rays, 512, worldFromAxes);
    for (const SurfaceFoot& foot : scene.feet()) {
      if (!scene.isWithin(foot, 4)) continue;
      const glm::dvec3 got = bentAt(bent, glm::round(foot.position));
      EXPECT_LT(glm::length(got - 0.5 * (worldFromAxes * normal)), 0.02) << i;
      EXPECT_GT(bentNormal(glm::vec3(got)).cone, 0.95 * kPi / 2);
    }
  }
}

TEST(BentNormals, FloorBeforeAWallAsTheReference) {
  // From one to eight voxels before a wall direction and cone are those of the reference to 1.5 degrees.
  const TestScene corner({33, 25, 33}, glm::dvec3(1),
                         [](glm::dvec3 p) { return std::max(floorLevel(p, kFloor), 5 - p.x); });
  Grid<float> level(corner.level.size());
  std::copy_n(corner.level.data(), level.count(), level.data());
  const SweptScene scene(std::move(level), 2);
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, 2, 3))));
  const auto bent = sweepBentNormals(scene.rays, 1024, turn);
  IntegrandSettings settings;
  settings.integrand = Integrand::bent;
  for (const double distance : {1.0, 2.0, 4.0, 8.0}) {
    const glm::dvec3 at(5 + distance, 12, kFloor);
    const Channels want = estimateAt({corner.tracer, turn}, settings, {.rays = 1 << 14}, pointOn(at), 0).channels.value;
    const glm::dvec3 got = bentAt(bent, at);
    const double tolerance = glm::radians(1.5);
    EXPECT_GT(glm::dot(glm::normalize(got), glm::dvec3(want[0], want[1], want[2])), std::cos(tolerance)) << distance;
    EXPECT_NEAR(bentNormal(glm::vec3(got)).cone, want[3], tolerance) << distance;
  }
}

TEST(BentNormals, AClosedCavityHasNone) {
  // Where nothing is open the vector is 0, to the step of 16 bits.
  const SweptScene scene(glm::ivec3(25), glm::dvec3(1), 1, [](glm::dvec3 p) {
    const glm::dvec3 wall = glm::abs(p - 12.0) - 5.0;
    return std::max({wall.x, wall.y, wall.z});
  });
  const auto bent = sweepBentNormals(scene.rays, 256, glm::dmat3(1));
  constexpr double kStep = 1 / 32767.5;
  for (const double x : {8.0, 12.0, 16.0}) EXPECT_LT(glm::length(bentAt(bent, {x, 12, 7})), 2 * kStep);
}

}  // namespace
}  // namespace isolume::test
