#include "sweep/ordinates/surface_feet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>
#include <vector>

#include "support/random_grids.h"
#include "support/random_numbers.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"

namespace isolume {
namespace {

enum class Kind { away, outside, filled, cap };

// What a sample is by definition: solid on the border; or with a sample of the other side among the 26 around it, and
// if it is outside, one of the six along an axis.
Kind kindOf(GridView<const float> level, glm::ivec3 at) {
  const auto solid = [&](glm::ivec3 p) { return level(p.x, p.y, p.z) > 0; };
  bool border = false, mixed = false, beside = false;
  for (int axis = 0; axis < 3; ++axis) border = border || at[axis] == 0 || at[axis] == level.size[axis] - 1;
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1), p = at + step;
    const bool exists =
        p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < level.size.x && p.y < level.size.y && p.z < level.size.z;
    const bool differs = exists && solid(p) != solid(at);
    mixed = mixed || differs;
    beside = beside || (differs && std::abs(step.x) + std::abs(step.y) + std::abs(step.z) == 1);
  }
  if (solid(at) && border) return Kind::cap;
  return !mixed ? Kind::away : solid(at) || !beside ? Kind::filled : Kind::outside;
}

// Checks all there is against the definition.
void expectFeetByDefinition(GridView<const float> level) {
  const Grid<float> distance = closestDistance(level);
  const SurfaceFeet surface(level, distance.view());
  const std::vector<SurfaceFoot>& feet = surface.feet();
  const double reach = glm::length(level.spacing) * (1 + 1e-6);
  std::vector<std::uint16_t> numbers(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) numbers[i] = static_cast<std::uint16_t>(i % 60000 + 1);
  Grid<std::uint16_t> values(level.size, level.spacing);
  surface.spread(numbers, values.view());
  std::size_t next = 0;
  for (int z = 0; z < level.size.z; ++z)
    for (int y = 0; y < level.size.y; ++y)
      for (int x = 0; x < level.size.x; ++x) {
        const glm::ivec3 at(x, y, z);
        SCOPED_TRACE(testing::Message() << x << " " << y << " " << z);
        const Kind kind = kindOf(level, at);
        const std::uint16_t value = values.view()(x, y, z);
        ASSERT_EQ(value != 0, kind != Kind::away);
        if (kind != Kind::outside && kind != Kind::cap) continue;
        ASSERT_LT(next, feet.size());
        ASSERT_EQ(value, numbers[next]);
        const SurfaceFoot& foot = feet[next++];
        ASSERT_LE(glm::length((glm::dvec3(foot.position) - glm::dvec3(at)) * level.spacing), reach);
        const float length = glm::length(foot.normal);
        ASSERT_TRUE(length == 0 || std::abs(length - 1) < 1e-6F) << length;
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_GE(foot.position[axis], 0);
          ASSERT_LE(foot.position[axis], static_cast<float>(level.size[axis] - 1));
        }
        if (kind == Kind::cap) {
          ASSERT_EQ(foot.position, glm::vec3(at));
        }
      }
  EXPECT_EQ(next, feet.size());
}

TEST(SurfaceFeet, AreThoseOfTheDefinition) {
  // Feet stand for the outside samples beside solid ones and for the caps, in the order of the samples and within a
  // cell's diagonal of them; each sample next to the surface takes a value from some of them, all others hold 0.
  for (int i = 0; i < 400; ++i) {
    const test::RandomGrid grid = test::randomGrid(i);
    SCOPED_TRACE(grid.name);
    expectFeetByDefinition(grid.level.view());
  }
}

TEST(SurfaceFeet, AreThoseOfTheDefinitionInLongRows) {
  // The same where rows fill a word of 64 samples, or just not: rare single samples of the other side on both sides of
  // the words' ends.
  std::uint64_t seed = 0;
  for (const glm::ivec3& size : {glm::ivec3(63, 5, 4), glm::ivec3(64, 5, 4), glm::ivec3(65, 5, 4),
                                 glm::ivec3(127, 4, 4), glm::ivec3(128, 4, 4), glm::ivec3(130, 4, 4)})
    for (const int rarity : {2, 30, 300})
      for (const float background : {-1.0F, 1.0F}) {
        SCOPED_TRACE(testing::Message() << size.x << " by one in " << rarity << " in " << background);
        test::RandomNumbers numbers(++seed);
        Grid<float> level(size);
        for (std::size_t i = 0; i < level.count(); ++i)
          level.data()[i] = numbers.below(rarity) == 0 ? -background : background;
        for (const int x : {0, 62, 63, 64, 65, 127})
          if (x < size.x) level.view()(x, 2, 2) = -background;
        expectFeetByDefinition(level.view());
      }
}

TEST(SurfaceFeet, LieOnABallWithItsNormals) {
  // Around a ball with its exact distance every foot lies on the sphere, and its normal points out of the centre.
  const glm::dvec3 centre(20.3, 19.8, 20.1);
  constexpr double kRadius = 14;
  const Grid<float> level = test::ballLevel(41, kRadius, centre);
  Grid<float> distance(level.size());
  for (std::size_t i = 0; i < level.count(); ++i) distance.data()[i] = -level.data()[i];
  const SurfaceFeet surface(level.view(), distance.view());
  ASSERT_GT(surface.feet().size(), 2000U);
  double farthest = 0, leastCosine = 1;
  for (const SurfaceFoot& foot : surface.feet()) {
    const glm::dvec3 out = glm::dvec3(foot.position) - centre;
    farthest = std::max(farthest, std::abs(glm::length(out) - kRadius));
    leastCosine = std::min(leastCosine, glm::dot(glm::normalize(out), glm::dvec3(foot.normal)));
  }
  EXPECT_LT(farthest, 0.01);
  EXPECT_GT(leastCosine, std::cos(glm::radians(1.0)));
}

TEST(SurfaceFeet, SamplesWithoutAFootTakeThoseThatHaveOne) {
  // All feet equal: every sample next to the surface holds that value.
  const Grid<float> level = test::ballLevel(41, 14, {20.3, 19.8, 20.1});
  const Grid<float> distance = closestDistance(level.view());
  const SurfaceFeet surface(level.view(), distance.view());
  Grid<std::uint16_t> values(level.size());
  surface.spread(std::vector<std::uint16_t>(surface.feet().size(), 12345), values.view());
  int filled = 0;
  for (int z = 0; z < 41; ++z)
    for (int y = 0; y < 41; ++y)
      for (int x = 0; x < 41; ++x) {
        const Kind kind = kindOf(level.view(), {x, y, z});
        ASSERT_EQ(values.view()(x, y, z), kind == Kind::away ? 0 : 12345) << x << " " << y << " " << z;
        filled += kind == Kind::filled ? 1 : 0;
      }
  EXPECT_GT(filled, 4000);
}

}  // namespace
}  // namespace isolume
