// Openness by ordinates where it is known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "estimators/closed_form.h"
#include "ordinates/swept_openness.h"

namespace isolume {
namespace {

using test::kOpen;
using test::opennessAt;
using test::opennessOf;
using test::sampleLevel;

struct Extremes {
  double least = 1, largest = 0;
};
// Of all samples next to the surface that do not lie on the border.
Extremes extremesOf(GridView<const float> level, const OrdinateOptions& options) {
  const SurfaceField values = opennessOf(level, options);
  Extremes found;
  test::forEachWithin(level.size, 1, [&](glm::ivec3 at) {
    if (!test::isNextToSurface(level, at)) return;
    const double value = values.wall(at) / kOpen;
    found.least = std::min(found.least, value);
    found.largest = std::max(found.largest, value);
  });
  return found;
}

constexpr glm::dvec3 kBallCentre(20.3, 19.8, 20.1);
constexpr int kBallGrid = 41;

TEST(OpennessSweep, ABallInEmptySpaceIsOpen) {
  // Every sample next to a ball in empty space is open to .01.
  for (const int refinement : {1, 2})
    for (const int ordinates : {64, 512, 2048})
      for (const double radius : {3.0, 8.0, 14.0}) {
        const Grid<float> ball = test::ballLevel(kBallGrid, radius, kBallCentre);
        EXPECT_GT(extremesOf(ball.view(), {.ordinates = ordinates, .refinement = refinement}).least, 0.99)
            << radius << " by " << refinement << ", " << ordinates << " ordinates";
      }
}

TEST(OpennessSweep, AClosedCavityIsDark) {
  // Inside a hollow ball and a hollow box nothing is open; what is left is how far the sum of the clamped cosines is
  // from K / 4, at most a quarter of a direction (ordinate_set_test.cpp): 1 / K.
  const Grid<float> ball = sampleLevel(glm::ivec3(33), glm::dvec3(1),
                                       [](glm::dvec3 p) { return glm::length(p - glm::dvec3(16.3, 15.8, 16.1)) - 10; });
  const Grid<float> box = sampleLevel(glm::ivec3(25), glm::dvec3(1), [](glm::dvec3 p) {
    const glm::dvec3 wall = glm::abs(p - 12.0) - 5.0;  // 7 voxels thick: light along a wall passes 3 of the next
    return std::max({wall.x, wall.y, wall.z});
  });
  for (const int refinement : {1, 2})
    for (const int ordinates : {64, 512, 2048})
      for (const Grid<float>* level : {&ball, &box}) {
        const Extremes found = extremesOf(level->view(), {.ordinates = ordinates, .refinement = refinement});
        EXPECT_LT(found.largest, 1.0 / ordinates) << (level == &ball ? "ball" : "box") << " by " << refinement;
      }
}

// World units: a floor and a wall in a cube, on a grid of any spacing that divides it.
constexpr int kSide = 32, kWall = 5, kFloor = 4, kY = 12;
Grid<float> floorAndWall(glm::dvec3 spacing = glm::dvec3(1)) {
  return sampleLevel(glm::ivec3(static_cast<double>(kSide) / spacing) + 1, spacing,
                     [](glm::dvec3 p) { return std::max(test::floorLevel(p, kFloor), kWall - p.x); });
}

TEST(OpennessSweep, FloorBeforeAWall) {
  // At samples of a floor, from one voxel before a wall on, the closed form of the upright rectangle holds to .02
  // (measured: .014; with 2048 ordinates .011 at refinement 2 and .019 at refinement 1), whatever the spacing.
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 2, 0.5), glm::dvec3(0.5, 1, 2)}) {
    const Grid<float> level = floorAndWall(spacing);
    for (const OrdinateOptions options : {OrdinateOptions{.refinement = 2},
                                          {.ordinates = 2048, .refinement = 2},
                                          {.ordinates = 2048, .refinement = 1}}) {
      const SurfaceField values = opennessOf(level.view(), options);
      for (const double distance : {1.0, 2.0, 5.0, 10.0}) {
        const double height = kSide - kFloor;
        const double want =
            1 - test::uprightRectangle(kY, height, distance) - test::uprightRectangle(kSide - kY, height, distance);
        const glm::dvec3 at = glm::dvec3(kWall + distance, kY, kFloor) / spacing;
        EXPECT_NEAR(opennessAt(values, at), want, 0.02)
            << distance << ", " << options.ordinates << " ordinates by " << options.refinement << ", spacing "
            << spacing.x << " " << spacing.y << " " << spacing.z;
      }
    }
  }
}

TEST(OpennessSweep, FootOfAWall) {
  // In the corner between floor and wall the gradient points halfway between both normals: with that normal the open
  // quarter of space gives cos(45 degrees), not the floor's 1/2. To .02 (measured: .0149).
  const SurfaceField values = opennessOf(floorAndWall().view());
  EXPECT_NEAR(opennessAt(values, {kWall, kY, kFloor}), std::sqrt(0.5), 0.02);
}

}  // namespace
}  // namespace isolume
