#include <gmock/gmock.h>

#include <cmath>

#include "sweep/parallel.h"
#include "volumes/nearest.h"
#include "volumes/random.h"
#include "volumes/scene_families.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

constexpr int kPoints = 20000;

TEST(ScenePrimitives, TaperedCapsule) {
  // The distance to a tapered capsule is that to the nearest of its balls: its definition, minimised by golden section.
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const TaperedCapsule capsule{random.inBox(0, 1), random.inBox(0, 1), random.uniform(0.01, 0.3),
                                 random.uniform(0.01, 0.3)};
    const glm::dvec3 p = random.inBox(-1, 2);
    const auto toBall = [&](double t) {
      return glm::length(p - glm::mix(capsule.a, capsule.b, t)) - glm::mix(capsule.radiusA, capsule.radiusB, t);
    };
    double low = 0, high = 1;  // toBall is convex in t
    for (int step = 0; step < 100; ++step) {
      const double third = (high - low) / 3;
      (toBall(low + third) < toBall(high - third) ? high : low) =
          toBall(low + third) < toBall(high - third) ? high - third : low + third;
    }
    // Inside the cone the formula measures to the cone's surface, which is what the least ball gives there as well.
    EXPECT_NEAR(distanceTo(capsule, p), toBall((low + high) / 2), 1e-9);
  }
}

TEST(ScenePrimitives, DegenerateCapsules) {
  // Without length, or with one ball inside the other, only the larger ball is left.
  const glm::dvec3 c(0.5), p(0.9, 0.5, 0.5);
  EXPECT_DOUBLE_EQ(distanceTo(TaperedCapsule{c, c, 0.1, 0.1}, p), 0.3);
  EXPECT_DOUBLE_EQ(distanceTo(TaperedCapsule{c, c + glm::dvec3(0, 0.05, 0), 0.2, 0.01}, p), 0.2);
}

TEST(ScenePrimitives, BoxCylinderTorus) {
  // Closed forms at points in front of a face, an edge and a corner, inside, and on the axis.
  const glm::dvec3 half(1, 2, 3);
  EXPECT_DOUBLE_EQ(boxDistance(glm::dvec3(3, 0, 0), half), 2);
  EXPECT_DOUBLE_EQ(boxDistance(glm::dvec3(4, 6, 0), half), 5);
  EXPECT_DOUBLE_EQ(boxDistance(glm::dvec3(3, -3, -5), half), 3);
  EXPECT_DOUBLE_EQ(boxDistance(glm::dvec3(0.5, 0, 0), half), -0.5);
  EXPECT_DOUBLE_EQ(cylinderDistance({3, 4, 0}, 2, 1), 3);
  EXPECT_DOUBLE_EQ(cylinderDistance({5, 0, 5}, 2, 1), 5);
  EXPECT_DOUBLE_EQ(cylinderDistance({0, 0, 0.25}, 2, 1), -0.75);
  EXPECT_DOUBLE_EQ(torusDistance({0, 0, 0}, 2, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(torusDistance({0, 2, 3}, 2, 0.5), 2.5);
}

template <class Primitive>
void expectSameAsBruteForce(const std::vector<Primitive>& primitives, double (*value)(glm::dvec3), int points) {
  Random random(2);
  for (int i = 0; i < points; ++i) {
    const glm::dvec3 p = random.inBox(-0.05, 1.05);
    ASSERT_EQ(value(p), nearestOfAll(primitives, p)) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(SceneDistances, SearchGivesBruteForceBitForBit) {
  // The cells with candidates give exactly what trying every primitive gives, outside the cube too.
  expectSameAsBruteForce(capsulesPrimitives(), capsulesValue, kPoints);
  expectSameAsBruteForce(spheresPrimitives(), spheresValue, kPoints);
  expectSameAsBruteForce(capillariesPrimitives(), capillariesValue, kPoints / 10);
}

glm::dvec3 gradientOf(double (*value)(glm::dvec3), glm::dvec3 p, double h) {
  const auto slope = [&](glm::dvec3 step) { return (value(p + step) - value(p - step)) / (2 * h); };
  return {slope({h, 0, 0}), slope({0, h, 0}), slope({0, 0, h})};
}

struct Exact {
  const char* name;
  double (*value)(glm::dvec3);
};
class ExactScene : public ::testing::TestWithParam<Exact> {};

TEST_P(ExactScene, GradientHasUnitLengthOutside) {
  // |grad f| = 1 at open points, except on the medial surface, where two solids are equally near.
  const auto [name, value] = GetParam();
  ASSERT_TRUE(findScene(name)->exactDistance);
  Random random(3);
  int open = 0, kinks = 0;
  constexpr double kStep = 1e-6;
  for (int i = 0; i < kPoints; ++i) {
    const glm::dvec3 p = random.inBox(0, 1);
    if (value(p) < 1e-3) continue;  // the steps must stay outside, and curvature radii above 1e-3
    ++open;
    // Rounding gives 1e-16 / 1e-6; curvature 1 / r at r >= 1e-3 gives (h / r)^2 = 1e-6.
    if (std::abs(glm::length(gradientOf(value, p, kStep)) - 1) > 1e-5) ++kinks;
  }
  EXPECT_GT(open, kPoints / 3);
  // Points within kStep of the medial surface: its area, below 100, times 2 steps, that is 2e-4 of all points.
  EXPECT_LE(kinks, kPoints / 5000);
}

TEST_P(ExactScene, BallOfThatRadiusIsEmpty) {
  // No point of the solid lies nearer than f says, and one lies at that distance: along -grad f.
  const auto [name, value] = GetParam();
  Random random(4);
  int checked = 0;
  for (int i = 0; i < kPoints; ++i) {
    const glm::dvec3 p = random.inBox(0, 1);
    const double distance = value(p);
    if (distance <= 1e-3) continue;
    constexpr double kInside = 1 - 1e-9;
    ASSERT_GT(value(p + kInside * distance * random.direction()), 0);
    const glm::dvec3 gradient = gradientOf(value, p, 1e-6);
    if (std::abs(glm::length(gradient) - 1) > 1e-6) continue;  // medial surface: no single nearest point
    ASSERT_NEAR(value(p - distance * gradient), 0, 1e-5);      // the gradient's error, 1e-6, times at most 1
    ++checked;
  }
  EXPECT_GT(checked, kPoints / 4);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExactScene,
                         ::testing::Values(Exact{"corner", cornerValue}, Exact{"capillaries", capillariesValue},
                                           Exact{"capsules", capsulesValue}, Exact{"spheres", spheresValue}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(SceneDistances, SamplesAreTheFunctionAtCellCentres) {
  // sampleScene stores value() at ((i, j, k) + 1/2) / N bit for bit, for any number of threads.
  constexpr int kSize = 20;
  for (const std::string_view name : sceneNames()) {
    const Scene& scene = *findScene(name);
    setThreadCount(1);
    const Grid<float> grid = sampleScene(scene, kSize);
    setThreadCount(0);
    const Grid<float> again = sampleScene(scene, kSize);
    const GridView<const float> view = grid.view(), viewAgain = again.view();
    EXPECT_EQ(view.size, glm::ivec3(kSize));
    EXPECT_EQ(view.spacing, glm::dvec3(1.0 / kSize));
    EXPECT_EQ(view.origin, glm::dvec3(0.5 / kSize));
    for (int z = 0; z < kSize; ++z)
      for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
          ASSERT_EQ(view(x, y, z), scene.value({(x + 0.5) / kSize, (y + 0.5) / kSize, (z + 0.5) / kSize})) << name;
          ASSERT_EQ(view(x, y, z), viewAgain(x, y, z)) << name;
        }
  }
}

}  // namespace
}  // namespace isolume
