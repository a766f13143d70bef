// Distances in a band alone: the same as those of the whole domain, cut off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_grids.h"
#include "support/test_levels.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// The number of samples that the bound cuts off.
int expectBandIsTheCutField(GridView<const float> level, int bandVoxels, int rounds) {
  SweepOptions options{.visibility = VisibilityStorage::none, .rounds = rounds};
  const SweptFields full = sweepOcclusion(level, options);
  options.extent = DistanceExtent::band;
  options.bandVoxels = bandVoxels;
  const SweptFields band = sweepOcclusion(level, options);
  const auto smallest = static_cast<float>(smallestSpacing(level.spacing));
  // The bound, to the rounding of the largest spacing in units of the smallest; all that lies beyond has the same.
  const double atLeast =
      std::max((bandVoxels + 1.0) * smallest, std::max({level.spacing.x, level.spacing.y, level.spacing.z}));
  float bound = static_cast<float>(atLeast);
  for (std::size_t i = 0; i < level.count(); ++i) bound = std::max(bound, std::abs(band.distance.data()[i]));
  EXPECT_LE(bound, atLeast * (1 + 1e-6));
  int cut = 0, wrong = 0;
  for (std::size_t i = 0; i < level.count(); ++i) {
    const float whole = full.distance.data()[i];
    const float want = std::copysign(std::min(std::abs(whole), bound), whole);
    wrong += band.distance.data()[i] == want && std::signbit(band.distance.data()[i]) == std::signbit(want) ? 0 : 1;
    cut += std::abs(whole) > bound ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0);
  return cut;
}

TEST(Band, IsTheWholeFieldCutOff) {
  // |D| in a band of k voxels is min(|D| of the whole domain, the larger of k + 1 smallest spacings and the largest
  // spacing), bit for bit: on smooth surfaces and noise, for any spacing, k and number of rounds.
  for (const int bandVoxels : {0, 1, 3, 7})
    for (const int rounds : {1, 2}) {
      SCOPED_TRACE(testing::Message() << bandVoxels << " voxels, " << rounds << " rounds");
      EXPECT_GT(
          expectBandIsTheCutField(test::ballLevel(70, 21, glm::dvec3(34.2, 35.1, 33.7)).view(), bandVoxels, rounds),
          100000);
      expectBandIsTheCutField(test::noiseLevel({41, 37, 29}, {1, 1.5, 0.8}, 6).view(), bandVoxels, rounds);
      const auto sheet = test::sampleLevel({60, 53, 47}, glm::dvec3(2, 0.7, 1.1), [](glm::dvec3 p) {
        return 0.4 - std::abs(p.x * 0.3 + p.y - 0.2 * p.z - 11);  // thinner than a voxel in places
      });
      EXPECT_GT(expectBandIsTheCutField(sheet.view(), bandVoxels, rounds), 10000);
    }
}

TEST(Band, IsTheWholeFieldCutOffBesideWallsAtEveryPlace) {
  // The same beside a wall across each axis at every place of a grid of a few tiles: the band reaches into tiles that
  // hold no start value, on either side.
  for (int axis = 0; axis < 3; ++axis)
    for (int place = 3; place < 36; ++place) {
      SCOPED_TRACE(testing::Message() << "axis " << axis << ", wall at " << place);
      const auto wall =
          test::sampleLevel(glm::ivec3(40), glm::dvec3(1), [&](glm::dvec3 p) { return p[axis] - place - .3; });
      expectBandIsTheCutField(wall.view(), 3, 1);
    }
}

TEST(Band, IsTheWholeFieldCutOffOnDegenerateGrids) {
  // The same on small grids of every degenerate kind; without a surface all is beyond the band.
  for (int i = 0; i < 2000; ++i) {
    const test::RandomGrid grid = test::randomGrid(i);
    SCOPED_TRACE(grid.name);
    expectBandIsTheCutField(grid.level.view(), i % 3, 1 + i % 2);
    if (HasFailure()) break;
  }
}

TEST(Band, DoesNotDependOnThreads) {
  // One and five threads give the same bits.
  const Grid<float> level = test::ballLevel(80, 23, glm::dvec3(41.2, 38.1, 40.7));
  const SweepOptions options{.visibility = VisibilityStorage::none, .extent = DistanceExtent::band};
  setThreadCount(1);
  const SweptFields one = sweepOcclusion(level.view(), options);
  setThreadCount(5);
  const SweptFields five = sweepOcclusion(level.view(), options);
  setThreadCount(0);
  EXPECT_TRUE(std::equal(one.distance.data(), one.distance.data() + level.count(), five.distance.data()));
}

TEST(Band, GivesTheVisibilityOfTheWholeField) {
  // Light depends on distances below half a voxel alone, so a band gives the visibility through the full distances.
  const Grid<float> level = test::noiseLevel({33, 40, 27}, {1, 1.2, 1}, 12);
  SweepOptions options{.visibility = VisibilityStorage::float32};
  const SweptFields full = sweepOcclusion(level.view(), {.visibility = VisibilityStorage::none});
  const OctantVisibility through = sweepVisibility(full.distance.view(), VisibilityStorage::float32);
  options.extent = DistanceExtent::band;
  const SweptFields band = sweepOcclusion(level.view(), options);
  for (std::size_t s = 0; s < kOctants.size(); ++s)
    EXPECT_TRUE(std::equal(through.octants[s].data(), through.octants[s].data() + level.count(),
                           band.visibility.octants[s].data()));
}

}  // namespace
}  // namespace isolume
