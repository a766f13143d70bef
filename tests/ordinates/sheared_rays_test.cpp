#include "sweep/ordinates/sheared_rays.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "ordinates/random_feet.h"
#include "support/plain_rays.h"
#include "support/simd_targets.h"
#include "sweep/near_sets.h"

namespace isolume {
namespace {

using test::RandomNumbers;

constexpr glm::dvec3 kSpacing(1, 0.7, 1.3);

// A level of single solid samples, one in `rarity`.
Grid<float> specks(glm::ivec3 size, int rarity, RandomNumbers& numbers) {
  Grid<float> level(size);
  for (std::size_t i = 0; i < level.count(); ++i) level.data()[i] = numbers.below(rarity) == 0 ? 1.0F : -1.0F;
  return level;
}

// Directions whose rays cross most layers of the axis, some along it and some along its diagonals.
std::vector<RayDirection> directionsAlong(int axis, int towards, int count, RandomNumbers& numbers) {
  const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
  std::vector<RayDirection> directions;
  while (static_cast<int>(directions.size()) < count) {
    glm::dvec3 w = numbers.direction();
    const int kind = numbers.below(6);
    if (kind == 0) w = glm::sign(w) / glm::sqrt(3.0);
    if (kind == 1) w[axes.row] = 0;
    const double size = glm::abs(w[axis]);
    if (size < glm::abs(w[axes.bit]) || size < glm::abs(w[axes.row]) || (w[axis] > 0) != (towards > 0)) continue;
    directions.push_back({static_cast<float>(w[axes.bit]), static_cast<float>(w[axes.row]), static_cast<float>(w[axis]),
                          w[axes.bit] / w[axis], w[axes.row] / w[axis], static_cast<float>(0.5 / size)});
  }
  return directions;
}

struct RayCase {
  SolidLattice lattice;
  std::vector<SurfaceFoot> feet;
  int axis = 0, towards = 1;
  std::vector<RayDirection> directions;
};

RayCase randomCase(int i) {
  // Rows that fill words, vectors and whole rows of 512 bits, or just not.
  constexpr glm::ivec3 kSizes[] = {{20, 17, 13}, {64, 9, 12}, {65, 40, 5}, {63, 64, 7},  {1, 30, 9},
                                   {30, 1, 1},   {2, 2, 2},   {511, 6, 9}, {512, 5, 20}, {7, 520, 4}};
  RandomNumbers numbers(static_cast<std::uint64_t>(i));
  const glm::ivec3 size = kSizes[i % 10];
  RayCase made;
  const Grid<float> level = specks(size, 1 << (1 + numbers.below(9)), numbers);
  made.lattice = makeSolidLattice(level.view(), insideSamples(level.view()), 1);
  made.feet = test::randomFeet(size, 300 + numbers.below(20), numbers);
  made.axis = i / 10 % 3;
  made.towards = i / 30 % 2 == 0 ? 1 : -1;
  made.directions = directionsAlong(made.axis, made.towards, 1 + numbers.below(kRayGroup), numbers);
  return made;
}
constexpr int kCases = 180;  // 10 sizes, 3 axes, 2 senses, 3 of each

// The sums must equal those of the plain rays. Returns how many points lost something.
int expectPlainSums(const RayCase& given) {
  constexpr float kScale = 1 << 20;
  RayPoints points(given.feet.size());
  points.sort(given.feet, given.lattice, kSpacing, given.axis);
  const std::vector<std::int32_t> want =
      test::plainRays(given.lattice, kSpacing, given.axis, given.towards, given.directions, points, kScale);
  std::vector<std::int32_t> got(points.count() + kRayPadding, 0);
  sweepRays(layersOf(given.lattice, kSpacing, given.axis), given.towards, given.directions, points,
            {.scale = kScale, .sums = got.data()});
  int blocked = 0, wrong = 0;
  for (std::size_t i = 0; i < points.count(); ++i) {
    blocked += want[i] != 0 ? 1 : 0;
    wrong += want[i] != got[i] ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0) << "of " << points.count() << " points";
  for (std::size_t i = points.count(); i < got.size(); ++i) EXPECT_EQ(got[i], 0) << "beyond the points";
  return blocked;
}

TEST(ShearedRays, EqualPlainRays) {
  // The sums of random points over random lattices are those of rays walked one at a time, to the last bit, for all
  // axes and senses, from within the lattice and from beyond each of its faces.
  int blocked = 0;
  for (int i = 0; i < kCases; ++i) {
    SCOPED_TRACE(testing::Message() << "case " << i);
    blocked += expectPlainSums(randomCase(i));
  }
  EXPECT_GT(blocked, kCases * 20);  // of about 300 points each: the comparison sees both outcomes
  EXPECT_LT(blocked, kCases * 250);
}

TEST(ShearedRays, EqualPlainRaysOnEveryInstructionSet) {
  // Every SIMD target that this machine can run gives the bits of the plain rays.
  const int tried = test::onEverySimdTarget([] {
    for (int i = 0; i < kCases; i += 7) {
      SCOPED_TRACE(testing::Message() << "case " << i);
      expectPlainSums(randomCase(i));
    }
  });
  EXPECT_GE(tried, 1);
}

TEST(ShearedRays, AddToWhatIsThere) {
  // A second sweep doubles the sums.
  const RayCase given = randomCase(0);
  RayPoints points(given.feet.size());
  points.sort(given.feet, given.lattice, kSpacing, given.axis);
  std::vector<std::int32_t> sums(points.count() + kRayPadding, 0);
  const auto sweep = [&] {
    sweepRays(layersOf(given.lattice, kSpacing, given.axis), given.towards, given.directions, points,
              {.scale = 1 << 20, .sums = sums.data()});
  };
  sweep();
  const std::vector<std::int32_t> once = sums;
  sweep();
  for (std::size_t i = 0; i < sums.size(); ++i) ASSERT_EQ(sums[i], 2 * once[i]);
}

}  // namespace
}  // namespace isolume
