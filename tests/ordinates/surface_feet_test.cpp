#include "sweep/ordinates/surface_feet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>
#include <vector>

#include "ordinates/swept_openness.h"
#include "support/random_grids.h"
#include "support/random_numbers.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"

namespace isolume {
namespace {

enum class Kind { away, outside, filled };

bool isSolid(GridView<const float> level, glm::ivec3 at) { return level(at.x, at.y, at.z) > 0; }
bool exists(GridView<const float> level, glm::ivec3 at) {
  return glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, level.size));
}

// visit(sample) for those of the 26 around.
template <class Visit>
void forEachAround(GridView<const float> level, glm::ivec3 at, const Visit& visit) {
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 p = at + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (i != 13 && exists(level, p)) visit(p);
  }
}

// What a sample is by definition: with a sample of the other side among the 26 around it, and if it is outside, one of
// the six along an axis.
Kind kindOf(GridView<const float> level, glm::ivec3 at) {
  bool mixed = false, beside = false;
  forEachAround(level, at, [&](glm::ivec3 p) {
    const glm::ivec3 step = glm::abs(p - at);
    const bool differs = isSolid(level, p) != isSolid(level, at);
    mixed = mixed || differs;
    beside = beside || (differs && step.x + step.y + step.z == 1);
  });
  return !mixed ? Kind::away : isSolid(level, at) || !beside ? Kind::filled : Kind::outside;
}

void expectWallsByDefinition(GridView<const float> level, const std::vector<SurfaceFoot>& feet,
                             const std::vector<std::uint16_t>& numbers, const SurfaceField& field, std::size_t& next) {
  const double reach = glm::length(level.spacing) * (1 + 1e-6);
  test::forEachWithin(level.size, 0, [&](glm::ivec3 at) {
    SCOPED_TRACE(testing::Message() << at.x << " " << at.y << " " << at.z);
    const Kind kind = kindOf(level, at);
    ASSERT_EQ(field.wall(at) != 0, kind != Kind::away);
    if (kind != Kind::outside) return;
    ASSERT_LT(next, feet.size());
    ASSERT_EQ(field.wall(at), numbers[next]);
    const SurfaceFoot& foot = feet[next++];
    ASSERT_LE(glm::length((glm::dvec3(foot.position) - glm::dvec3(at)) * level.spacing), reach);
    const float length = glm::length(foot.normal);
    ASSERT_TRUE(length == 0 || std::abs(length - 1) < 1e-6F) << length;
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_GE(foot.position[axis], 0);
      ASSERT_LE(foot.position[axis], static_cast<float>(level.size[axis] - 1));
    }
  });
}

void expectCapsByDefinition(GridView<const float> level, const std::vector<SurfaceFoot>& feet,
                            const std::vector<std::uint16_t>& numbers, const SurfaceField& field, std::size_t& next) {
  for (int f = 0; f < kFaceCount; ++f) {
    const GridFace face = faceOf(f);
    const int border = placeOf(face, level.size);
    glm::vec3 normal(0);
    normal[face.axis] = face.side == 0 ? -1.0F : 1.0F;
    test::forEachWithin(level.size, 0, [&](glm::ivec3 at) {
      if (at[face.axis] != border) return;
      SCOPED_TRACE(testing::Message() << at.x << " " << at.y << " " << at.z << " face " << f);
      bool beside = false;
      forEachAround(level, at, [&](glm::ivec3 p) { beside = beside || (p[face.axis] == border && isSolid(level, p)); });
      ASSERT_EQ(field.cap(face, at) != 0, beside || isSolid(level, at));
      if (!isSolid(level, at)) return;
      ASSERT_LT(next, feet.size());
      ASSERT_EQ(field.cap(face, at), numbers[next]);
      ASSERT_EQ(feet[next].position, glm::vec3(at));
      ASSERT_EQ(feet[next++].normal, normal);
    });
  }
}

// Checks all there is against the definition.
void expectFeetByDefinition(GridView<const float> level) {
  const Grid<float> distance = closestDistance(level);
  const SurfaceFeet surface(level, distance.view());
  const std::vector<SurfaceFoot> feet = surface.makeFeet();
  ASSERT_EQ(feet.size(), surface.count());
  std::vector<std::uint16_t> numbers(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) numbers[i] = static_cast<std::uint16_t>(i % 60000 + 1);
  const SurfaceField field = surface.spread(numbers);
  std::size_t next = 0;
  expectWallsByDefinition(level, feet, numbers, field, next);
  expectCapsByDefinition(level, feet, numbers, field, next);
  EXPECT_EQ(next, feet.size());
}

TEST(SurfaceFeet, AreThoseOfTheDefinition) {
  // Feet stand for the outside samples beside solid ones, in the order of the samples and within a cell's diagonal of
  // them, and after them for the solid samples of each face; each sample next to the isosurface takes a value from the
  // first, each of a face that is solid or beside such a one from the others, and the rest hold 0.
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
  ASSERT_GT(surface.count(), 2000U);
  double farthest = 0, leastCosine = 1;
  for (const SurfaceFoot& foot : surface.makeFeet()) {
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
  const SurfaceField field = surface.spread(std::vector<std::uint16_t>(surface.count(), 12345));
  int filled = 0;
  test::forEachWithin(level.size(), 0, [&](glm::ivec3 at) {
    const Kind kind = kindOf(level.view(), at);
    ASSERT_EQ(field.wall(at), kind == Kind::away ? 0 : 12345) << at.x << " " << at.y << " " << at.z;
    filled += kind == Kind::filled ? 1 : 0;
  });
  EXPECT_GT(filled, 4000);
}

}  // namespace
}  // namespace isolume
