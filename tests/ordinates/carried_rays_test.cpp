#include "sweep/ordinates/carried_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ordinates/random_feet.h"
#include "ordinates/random_rays.h"
#include "support/plain_rays.h"
#include "support/simd_targets.h"
#include "support/test_levels.h"
#include "sweep/near_sets.h"

namespace isolume {
namespace {

using test::RandomNumbers;
using Kind = CarriedTally::Kind;

struct CarriedCase {
  glm::dvec3 spacing{1};
  SolidLattice lattice;
  std::vector<SurfaceFoot> feet;
  int axis = 0, towards = 1;
  std::vector<RayDirection> directions;
  SampleLayers samples;              // those that have a value of their own
  std::vector<std::uint8_t> values;  // of these
  Grid<std::uint8_t> met;            // of every point, as plainCarried() takes it
};

// Three of four samples that may have a value have one: nearest: solid ones, length: all. The others are solid through
// and through, or empty.
void giveValues(CarriedCase& made, GridView<const float> level, Kind kind, RandomNumbers& numbers) {
  constexpr int kWithout = 4;  // one in so many
  const bool nearest = kind == Kind::nearest;
  made.met = Grid<std::uint8_t>(level.size);
  std::vector<NearSample> samples;
  for (int z = 0; z < level.size.z; ++z)
    for (int y = 0; y < level.size.y; ++y)
      for (int x = 0; x < level.size.x; ++x) {
        const bool solid = level(x, y, z) > 0;
        std::uint8_t& met = made.met.view()(x, y, z);
        met = nearest ? (solid ? 0 : test::kNothingMet) : (solid ? kSolidShare : 0);
        if ((nearest && !solid) || numbers.below(kWithout) == 0) continue;
        samples.push_back({{x, y, z}, 0});
        met = static_cast<std::uint8_t>(numbers.below((nearest ? kLargestCarried : kSolidShare) + 1));
        made.values.push_back(met);
      }
  made.samples = layersOfSamples(samples, level.size, made.axis);
}

// 1 to 70 points along each axis, at least one of the axes short; every fifth case has one point along an axis, and
// every eleventh rows that just fill a vector.
CarriedCase randomCase(int i, Kind kind, bool gathered) {
  RandomNumbers numbers(static_cast<std::uint64_t>(i) * 2 + (kind == Kind::length ? 1 : 0));
  glm::ivec3 size(1 + numbers.below(70), 1 + numbers.below(70), 1 + numbers.below(20));
  if (i % 5 == 1) size.x = 1;
  if (i % 11 == 2) size = {64, 16 + numbers.below(2), 32};
  for (int turn = numbers.below(3); turn > 0; --turn) size = {size.y, size.z, size.x};
  CarriedCase made;
  made.spacing = i % 2 == 0 ? glm::dvec3(1, 0.7, 1.3) : glm::dvec3(0.5, 2, 1);
  made.axis = i % 3;
  made.towards = i / 3 % 2 == 0 ? 1 : -1;
  Grid<float> level = test::specks(size, 1 << (1 + numbers.below(gathered ? 1 : 4)), numbers);
  made.feet = test::randomFeet(size, 150 + numbers.below(20), numbers);
  if (gathered) test::gather(level, made.feet, numbers);
  const auto view = std::as_const(level).view();
  made.lattice = makeSolidLattice(view, insideSamples(view), 1);
  made.directions = test::directionsAlong(made.axis, made.towards, 1 + numbers.below(6), numbers);
  for (RayDirection& each : made.directions) each.value[0] = static_cast<float>(numbers.uniform());
  giveValues(made, view, kind, numbers);
  return made;
}
constexpr int kCases = 120;  // 3 axes and 2 senses, 20 of each

// The sums must equal those of the plain rays. Returns how many of them are not 0.
int expectPlainSums(const CarriedCase& given, Kind kind) {
  constexpr std::size_t kGap = 3;  // between what is written
  RayPoints points(given.feet.size());
  points.sort(test::chunksOf(given.feet), given.lattice, given.spacing, given.axis);
  const std::size_t channels = kind == Kind::length ? 2 : 1, stride = points.count() + kRayPadding + kGap;
  CarriedTally tally{.kind = kind,
                     .scale = kind == Kind::length ? 0x1p22F : 0x1p14F,
                     .lengthScale = 1 << 12,
                     .meanFreePath = 3,
                     .stride = static_cast<std::ptrdiff_t>(stride)};
  const std::vector<std::int32_t> want = test::plainCarried(given.lattice, given.spacing, given.axis, given.towards,
                                                            given.directions, points, given.met.view(), tally);
  std::vector<std::int32_t> got(stride * channels, 1);
  tally.sums = got.data();
  sweepCarriedRays(layersOf(given.lattice, given.spacing, given.axis), given.towards, given.directions, points,
                   given.samples, given.values, tally);
  int nonzero = 0, wrong = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const std::size_t point = i % stride;
    const std::int32_t expected = point < points.count() ? want[i / stride * points.count() + point] : 0;
    nonzero += expected != 0 ? 1 : 0;
    wrong += got[i] - 1 != expected ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0) << "of " << points.count() << " points";
  return nonzero;
}

int expectPlainSums(Kind kind, int step, bool gathered = false) {
  int nonzero = 0;
  for (int i = 0; i < kCases; i += step) {
    SCOPED_TRACE(testing::Message() << "case " << i);
    nonzero += expectPlainSums(randomCase(i, kind, gathered), kind);
  }
  return nonzero;
}

TEST(CarriedRays, NearestEqualsPlainRays) {
  // What random points read from random lattices is what rays walked one at a time meet first, to the last bit: all
  // axes and senses, unequal spacings, points within the lattice and beyond each of its faces.
  const int nonzero = expectPlainSums(Kind::nearest, 1);
  EXPECT_GT(nonzero, kCases * 20);  // of about 160 points each: the comparison sees both outcomes
  EXPECT_LT(nonzero, kCases * 140);
}

TEST(CarriedRays, EqualPlainRaysWhereMostOfTheLatticeIsEmpty) {
  // What is solid and the points fill small parts, apart from each other.
  EXPECT_GT(expectPlainSums(Kind::nearest, 1, true), kCases);
  expectPlainSums(Kind::length, 1, true);
}

TEST(CarriedRays, LengthEqualsPlainRays) {
  // The same for the solid on the way of a ray, what is left of its light, and the mean length of those that look
  // inwards.
  EXPECT_GT(expectPlainSums(Kind::length, 1), kCases * 160);
}

TEST(CarriedRays, LongestLengthIsTheLargestNumber) {
  // From the middle of its first point through a solid column of 4094 points a ray has the length of the other 4093 and
  // half a point, and through one of 5000 that of 65535 / 16 points and a half, not one that starts anew.
  for (const int height : {4094, 5000}) {
    const Grid<float> level = test::sampleLevel({1, 1, height}, glm::dvec3(1), [](glm::dvec3) { return 1; });
    const SolidLattice lattice = makeSolidLattice(level.view(), insideSamples(level.view()), 1);
    RayPoints points(1);
    const std::vector<SurfaceFoot> feet{{{0, 0, 0}, {0, 0, -1}}};
    points.sort(test::chunksOf(feet), lattice, glm::dvec3(1), 2);
    std::vector<std::int32_t> sums(2 * kRayPadding);
    const RayDirection up{.weightLayer = 1, .risePerCosine = 1};
    sweepCarriedRays(layersOf(lattice, glm::dvec3(1), 2), 1, {up}, points, layersOfSamples({}, level.size(), 2), {},
                     {.kind = Kind::length, .scale = 1, .lengthScale = 16, .stride = kRayPadding, .sums = sums.data()});
    EXPECT_EQ(sums[kRayPadding], std::min((height - 1) * kSolidShare, 65535) + kSolidShare / 2);
  }
}

TEST(CarriedRays, EqualPlainRaysOnEveryInstructionSet) {
  // Every SIMD target that this machine can run gives the bits of the plain rays.
  const int tried = test::onEverySimdTarget([] {
    for (const Kind kind : {Kind::nearest, Kind::length}) expectPlainSums(kind, 7);
  });
  EXPECT_GE(tried, 1);
}

}  // namespace
}  // namespace isolume
