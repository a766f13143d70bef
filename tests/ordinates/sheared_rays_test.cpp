#include "sweep/ordinates/sheared_rays.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "ordinates/random_feet.h"
#include "ordinates/random_rays.h"
#include "support/plain_rays.h"
#include "support/simd_targets.h"
#include "sweep/near_sets.h"

namespace isolume {
namespace {

using test::RandomNumbers;

constexpr glm::dvec3 kSpacing(1, 0.7, 1.3);

struct RayCase {
  SolidLattice lattice;
  std::vector<SurfaceFoot> feet;
  int axis = 0, towards = 1;
  std::vector<RayDirection> directions;
};

RayCase randomCase(int i, bool gathered = false) {
  // Rows that fill words, vectors and whole rows of 512 bits, or just not.
  constexpr glm::ivec3 kSizes[] = {{20, 17, 13}, {64, 9, 12}, {65, 40, 5}, {63, 64, 7},  {1, 30, 9},
                                   {30, 1, 1},   {2, 2, 2},   {511, 6, 9}, {512, 5, 20}, {7, 520, 4}};
  RandomNumbers numbers(static_cast<std::uint64_t>(i));
  const glm::ivec3 size = gathered ? glm::ivec3(40, 50, 30) : kSizes[i % 10];
  RayCase made;
  Grid<float> level = test::specks(size, 1 << (1 + numbers.below(gathered ? 2 : 9)), numbers);
  made.feet = test::randomFeet(size, 300 + numbers.below(20), numbers);
  if (gathered) test::gather(level, made.feet, numbers);
  const auto view = std::as_const(level).view();
  made.lattice = makeSolidLattice(view, insideSamples(view), 1);
  made.axis = i / 10 % 3;
  made.towards = i / 30 % 2 == 0 ? 1 : -1;
  made.directions = test::directionsAlong(made.axis, made.towards, 1 + numbers.below(kRayGroup), numbers);
  return made;
}
constexpr int kCases = 180;  // 10 sizes, 3 axes, 2 senses, 3 of each

constexpr float kScale = 1 << 20;

// The sums must equal those of the plain rays. Returns how many points lost something.
int expectPlainSums(const RayCase& given, int channels = 1, bool visible = false) {
  // Sums stand that far apart, and whatever is there stays there.
  constexpr std::size_t kGap = 5;
  RayPoints points(given.feet.size());
  points.sort(test::chunksOf(given.feet), given.lattice, kSpacing, given.axis);
  RayTally tally{.channels = channels, .visible = visible, .scale = kScale};
  const std::vector<std::int32_t> want =
      test::plainRays(given.lattice, kSpacing, given.axis, given.towards, given.directions, points, tally);
  const std::size_t stride = points.count() + kRayPadding + kGap;
  std::vector<std::int32_t> got(stride * static_cast<std::size_t>(channels));
  for (std::size_t i = 0; i < got.size(); ++i) got[i] = static_cast<std::int32_t>(i);
  tally.stride = static_cast<std::ptrdiff_t>(stride);
  tally.sums = got.data();
  sweepRays(layersOf(given.lattice, kSpacing, given.axis), given.towards, given.directions, points, tally);
  int nonzero = 0, wrong = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const std::size_t channel = i / stride, point = i % stride;
    const std::int32_t added = got[i] - static_cast<std::int32_t>(i);
    if (point < points.count()) {
      const std::int32_t expected = want[channel * points.count() + point];
      nonzero += channel == 0 && expected != 0 ? 1 : 0;
      wrong += added != expected ? 1 : 0;
    } else {
      EXPECT_EQ(added, 0) << "beyond the points of channel " << channel;
    }
  }
  EXPECT_EQ(wrong, 0) << "of " << points.count() << " points in " << channels << " channels";
  return nonzero;
}

TEST(RaysAtATime, KeepWhatTheSecondCacheHolds) {
  const auto ofLayer = [](int rows, int words) {
    LatticeLayers layers;
    layers.rows = rows;
    layers.words = words;
    return raysAtATime(layers);
  };
  EXPECT_EQ(ofLayer(1, 1), kRayGroup);
  EXPECT_EQ(ofLayer(256, 5), kRayGroup);
  EXPECT_EQ(ofLayer(511, 9), 12);
  EXPECT_EQ(ofLayer(1023, 17), kRayGroup / 2);
}

// A random value in each channel, of either sign.
RayCase withValues(RayCase given, std::uint64_t seed) {
  RandomNumbers numbers(seed);
  for (RayDirection& each : given.directions)
    for (float& value : each.value) value = static_cast<float>(2 * numbers.uniform() - 1);
  return given;
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

TEST(ShearedRays, EqualPlainRaysWhereMostOfTheLatticeIsEmpty) {
  // What is solid and the points fill small parts, apart from each other: rows and layers that are left alone hold
  // nothing that a point asks for.
  int blocked = 0;
  for (int i = 0; i < kCases; ++i) {
    SCOPED_TRACE(testing::Message() << "case " << i);
    blocked += expectPlainSums(randomCase(i, true));
  }
  EXPECT_GT(blocked, kCases * 5);
}

// All numbers of channels, blocked and visible, for every `step`th case. Returns how many sums were not 0.
int expectPlainChannels(int step) {
  int nonzero = 0;
  for (int i = 0; i < kCases; i += step) {
    SCOPED_TRACE(testing::Message() << "case " << i);
    const RayCase given = withValues(randomCase(i), static_cast<std::uint64_t>(kCases + i));
    for (const int channels : {1, 3, 4})
      for (const bool visible : {false, true}) nonzero += expectPlainSums(given, channels, visible);
  }
  return nonzero;
}

TEST(ShearedRays, ChannelsEqualPlainRays) {
  // With one and three channels the sums are of values times cosines, with four of values alone, over what is blocked
  // or over what is visible; channels stand a stride apart, and nothing is written between them.
  EXPECT_GT(expectPlainChannels(1), kCases * 6 * 100);
}

TEST(ShearedRays, EqualPlainRaysOnEveryInstructionSet) {
  // Every SIMD target that this machine can run gives the bits of the plain rays.
  const int tried = test::onEverySimdTarget([] {
    for (int i = 0; i < kCases; i += 7) {
      SCOPED_TRACE(testing::Message() << "case " << i);
      expectPlainSums(randomCase(i));
    }
    expectPlainChannels(23);
  });
  EXPECT_GE(tried, 1);
}

TEST(ShearedRays, AddToWhatIsThere) {
  // A second sweep doubles the sums.
  const RayCase given = randomCase(0);
  RayPoints points(given.feet.size());
  points.sort(test::chunksOf(given.feet), given.lattice, kSpacing, given.axis);
  std::vector<std::int32_t> sums(points.count() + kRayPadding, 0);
  const auto sweep = [&] {
    sweepRays(layersOf(given.lattice, kSpacing, given.axis), given.towards, given.directions, points,
              {.scale = kScale, .sums = sums.data()});
  };
  sweep();
  const std::vector<std::int32_t> once = sums;
  sweep();
  for (std::size_t i = 0; i < sums.size(); ++i) ASSERT_EQ(sums[i], 2 * once[i]);
}

}  // namespace
}  // namespace isolume
