// Start values next to the surface: their error, their bounds, and degenerate levels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/vec2.hpp>

#include "support/test_levels.h"
#include "sweep/godunov/surface_start.h"

namespace isolume {
namespace {

using test::sampleLevel;
using Distance = std::function<double(glm::dvec3)>;

Grid<float> startOf(GridView<const float> level, DistanceStart start) {
  Grid<float> distance(level.size, level.spacing);
  startDistance(level, distance.view(), start);
  return distance;
}

struct StartError {
  double mean = 0, max = 0;
  int count = 0;
};

// In smallest spacings, against the closed form; `steepen` is a monotone map of distances to levels.
StartError errorOf(glm::dvec3 spacing, const Distance& exact, const std::function<double(double)>& steepen,
                   DistanceStart start) {
  const Grid<float> level = sampleLevel(glm::ivec3(64), spacing, [&](glm::dvec3 p) { return steepen(-exact(p)); });
  const Grid<float> values = startOf(level.view(), start);
  const double unit = smallestSpacing(spacing);
  StartError error;
  for (int z = 1; z < 63; ++z)
    for (int y = 1; y < 63; ++y)
      for (int x = 1; x < 63; ++x) {
        const float value = values.view()(x, y, z);
        if (!isFixed(value)) continue;
        const double off = std::abs(value - exact(glm::dvec3(x, y, z) * spacing) / unit);
        error.mean += off;
        error.max = std::max(error.max, off);
        ++error.count;
      }
  error.mean /= error.count;
  return error;
}

double ball(glm::dvec3 p) { return glm::length(p - glm::dvec3(31.2, 32.1, 30.7)) - 24; }
double torus(glm::dvec3 p) {
  const glm::dvec3 q = p - glm::dvec3(31.2, 32.1, 30.7);
  return glm::length(glm::dvec2(glm::length(glm::dvec2(q)) - 18, q.z)) - 8;
}
double same(double level) { return level; }

TEST(Start, BetterIsWithinHundredthsOfAVoxelOfASmoothSurface) {
  // On a ball and a torus the better start is off by at most .01 voxel on average and .05 anywhere, where the axis
  // minimum is off by .05 and more on average. The interpolant of a distance lies up to an eighth of the sum of both
  // curvatures inside: .0104 on the ball, .029 at the inner rim of the torus.
  for (const Distance& exact : {Distance(ball), Distance(torus)}) {
    const StartError better = errorOf(glm::dvec3(1), exact, same, DistanceStart::better);
    EXPECT_GT(better.count, 5000);
    EXPECT_LT(better.mean, 0.01);
    EXPECT_LT(better.max, 0.05);
    EXPECT_GT(errorOf(glm::dvec3(1), exact, same, DistanceStart::paper).mean, 0.05);
  }
}

TEST(Start, BetterDoesNotDependOnTheSteepnessOfTheData) {
  // Levels of any slope and magnitude that are not distances, and curved along the normal, give the same accuracy.
  const auto curved = [](double d) { return std::expm1(d / 8); };
  EXPECT_LT(errorOf(glm::dvec3(1), ball, curved, DistanceStart::better).mean, 0.02);
  for (const double scale : {1e-30, 1e30}) {
    const StartError error = errorOf(
        glm::dvec3(1), ball, [&](double d) { return scale * d; }, DistanceStart::better);
    EXPECT_LT(error.mean, 0.01) << scale;
    EXPECT_LT(error.max, 0.05) << scale;
  }
}

TEST(Start, BetterIsExactForPlanes) {
  // A plane across all axes at any spacing: distance to rounding, of levels of up to 200 in float.
  const glm::dvec3 spacing(1, 1.5, 0.75);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, -0.7, 0.6));
  const Distance plane = [&](glm::dvec3 p) { return glm::dot(p - glm::dvec3(30, 45, 22), normal); };
  const StartError error = errorOf(spacing, plane, same, DistanceStart::better);
  EXPECT_GT(error.count, 5000);
  EXPECT_LT(error.max, 2e-5);
}

TEST(Start, BetterIsNeverMoreThanTheAxisMinimum) {
  // On noise the better start has the same fixed samples and signs, and no larger magnitude.
  const Grid<float> level = test::noiseLevel({40, 23, 31}, {1, 2, 1.25}, 4);
  const Grid<float> paper = startOf(level.view(), DistanceStart::paper);
  const Grid<float> better = startOf(level.view(), DistanceStart::better);
  int smaller = 0;
  for (std::size_t i = 0; i < level.count(); ++i) {
    ASSERT_EQ(isFixed(better.data()[i]), isFixed(paper.data()[i]));
    ASSERT_EQ(std::signbit(better.data()[i]), std::signbit(paper.data()[i]));
    ASSERT_LE(std::abs(better.data()[i]), std::abs(paper.data()[i]));
    smaller += std::abs(better.data()[i]) < std::abs(paper.data()[i]) ? 1 : 0;
  }
  EXPECT_GT(smaller, 10000);
}

}  // namespace
}  // namespace isolume
