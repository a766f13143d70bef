// Openness by ordinates at the border of the grid, in degenerate grids, and the same for all threads and vectors.
#include <gtest/gtest.h>

#include <cmath>

#include "ordinates/swept_openness.h"
#include "support/random_grids.h"
#include "support/simd_targets.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

using test::opennessOf;

// A solid that fills the grid's lower half, and is cut by five faces of the border.
constexpr int kSize = 17, kHeight = 8;
Grid<float> halfFull(glm::dvec3 spacing) {
  return test::sampleLevel(glm::ivec3(kSize), spacing, [&](glm::dvec3 p) { return kHeight + 0.3 - p.z / spacing.z; });
}
bool isCap(glm::ivec3 at) {
  return at.z == 0 || (at.z <= kHeight && (at.x == 0 || at.y == 0 || at.x == kSize - 1 || at.y == kSize - 1));
}
bool isNextToItsSurface(glm::ivec3 at) { return at.z == kHeight || at.z == kHeight + 1; }

template <class Visit>
void forEachHalfFull(const Visit& visit) {
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 2, 3)})
    for (const int refinement : {1, 2}) visit(halfFull(spacing), OrdinateOptions{.refinement = refinement});
}

TEST(OpennessSweep, HasValuesOnCapsAndNextToTheSurfaceAlone) {
  // Where the border cuts a half full grid: more than 0 next to the surface and on the caps, and 0 at all
  // other samples.
  forEachHalfFull([](const Grid<float>& level, const OrdinateOptions& options) {
    const Grid<std::uint16_t> values = bySample(opennessOf(level.view(), options), level.view());
    test::forEachWithin(level.size(), 0, [&](glm::ivec3 at) {
      const std::uint16_t value = values.view()(at.x, at.y, at.z);
      EXPECT_EQ(value != 0, isCap(at) || isNextToItsSurface(at)) << at.x << " " << at.y << " " << at.z;
    });
  });
}

TEST(OpennessSweep, CapsAreOpen) {
  // Caps, their edges and corners are open to .01.
  forEachHalfFull([](const Grid<float>& level, const OrdinateOptions& options) {
    const Grid<std::uint16_t> values = bySample(opennessOf(level.view(), options), level.view());
    double least = 1;
    test::forEachWithin(level.size(), 0, [&](glm::ivec3 at) {
      if (isCap(at)) least = std::min(least, values.view()(at.x, at.y, at.z) / test::kOpen);
    });
    EXPECT_GT(least, 0.99) << "refinement " << options.refinement << ", spacing " << level.view().spacing.y;
  });
}

TEST(OpennessSweep, TakesDegenerateGrids) {
  // Single samples, lines, planes and boxes of samples, extreme levels and spacings: no crash, and all 0 where there is
  // no surface.
  for (int i = 0; i < 400; ++i) {
    const test::RandomGrid grid = test::randomGrid(i);
    SCOPED_TRACE(grid.name);
    for (const int refinement : {1, 2}) {
      const Grid<std::uint16_t> values =
          bySample(opennessOf(grid.level.view(), {.ordinates = 8, .refinement = refinement}), grid.level.view());
      ASSERT_EQ(values.size(), grid.level.size());
      bool anyInside = false;
      int above = 0;
      for (std::size_t k = 0; k < grid.level.count(); ++k) anyInside = anyInside || grid.level.data()[k] > 0;
      for (std::size_t k = 0; k < values.count(); ++k) above += values.data()[k] != 0 ? 1 : 0;
      if (!anyInside) {
        ASSERT_EQ(above, 0);
      }
    }
  }
}

TEST(OpennessSweep, ThinGridsThatAreAllInsideAreOpen) {
  // Single samples, lines and the smallest cell: exactly 1 if all inside, 0 if all outside.
  for (const glm::ivec3& size :
       {glm::ivec3(1), glm::ivec3(1, 1, 9), glm::ivec3(1, 9, 1), glm::ivec3(9, 1, 1), glm::ivec3(2)})
    for (const float value : {-1.0F, 1.0F})
      for (const int refinement : {1, 2}) {
        const Grid<float> level = test::sampleLevel(size, glm::dvec3(1), [&](glm::dvec3) { return value; });
        const Grid<std::uint16_t> values = bySample(opennessOf(level.view(), {.refinement = refinement}), level.view());
        for (std::size_t i = 0; i < values.count(); ++i)
          ASSERT_EQ(values.data()[i], value > 0 ? 65535 : 0) << size.x << " " << size.y << " " << size.z;
      }
}

// Two balls and a floor, uneven in all axes; rows of more than one word when refined.
Grid<float> clutteredLevel() {
  return test::sampleLevel({70, 37, 29}, {1, 1.2, 0.8}, [](glm::dvec3 p) {
    const double floor = 5.3 - p.z;
    const double one = 7 - glm::length(p - glm::dvec3(20, 18, 13)), two = 9 - glm::length(p - glm::dvec3(45, 25, 12));
    return std::max({floor, one, two});
  });
}

TEST(OpennessSweep, ThreadsAndVectorsDoNotChangeABit) {
  // One and four threads, and every SIMD target that this machine can run, give the same bits.
  const Grid<float> level = clutteredLevel();
  const Grid<float> distance = closestDistance(level.view());
  for (const int refinement : {1, 2}) {
    const OrdinateOptions options{.ordinates = 200, .refinement = refinement};
    setThreadCount(1);
    const SurfaceField want = sweepOpenness(level.view(), distance.view(), options);
    const auto expectSame = [&] {
      const SurfaceField got = sweepOpenness(level.view(), distance.view(), options);
      EXPECT_EQ(test::paddedNumbers(got), test::paddedNumbers(want));
    };
    setThreadCount(4);
    expectSame();
    EXPECT_GE(test::onEverySimdTarget(expectSame), 1);
    setThreadCount(0);
  }
}

}  // namespace
}  // namespace isolume
