// Properties of the closest-point distance on ten thousand small random grids of the kinds that break solvers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "support/plain_closest.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/mix_bits.h"

namespace isolume {
namespace {

// Deterministic draws.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) {}
  std::uint64_t below(std::uint64_t bound) { return mixBits(state_ += kSplitMixIncrement) % bound; }
  float value() {
    return static_cast<float>(static_cast<double>(mixBits(state_ += kSplitMixIncrement) >> 40) / (1 << 23) - 1);
  }

 private:
  std::uint64_t state_;
};

enum class Kind { noise, sheet, plateaus, extremes };

glm::ivec3 drawSize(Draw& draw) {
  glm::ivec3 size(1);
  switch (draw.below(8)) {
    case 0:
      size[static_cast<int>(draw.below(3))] = 1 + static_cast<int>(draw.below(8));
      break;  // 1 x 1 x N
    case 1:
      size = glm::ivec3(2);
      break;
    case 2:
      size = glm::ivec3(8, 7, 8);
      break;
    default:
      size = glm::ivec3(1 + draw.below(5), 1 + draw.below(5), 1 + draw.below(5));
  }
  return size;
}

Grid<float> drawLevel(Draw& draw, Kind kind) {
  constexpr glm::dvec3 kSpacings[] = {glm::dvec3(1), glm::dvec3(1, 1.5, .7), glm::dvec3(1, 1, 1000)};
  const glm::ivec3 size = drawSize(draw);
  Grid<float> level(size, kSpacings[draw.below(8) == 0 ? 2 : draw.below(2)]);
  constexpr float kExtremes[] = {1e-30F, -1e-30F, 1e30F, -1e30F, 1, -1, 0};
  const int sheet = static_cast<int>(draw.below(static_cast<std::uint64_t>(size.z)));
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        float& value = level.view()(x, y, z);
        switch (kind) {
          case Kind::plateaus:
            value = static_cast<float>(draw.below(3)) - 1;
            break;
          case Kind::extremes:
            value = kExtremes[draw.below(std::size(kExtremes))];
            break;
          case Kind::sheet:
            value = (z == sheet ? .2F : -1.0F) + .1F * draw.value();
            break;
          default:
            value = draw.value();
        }
      }
  return level;
}

struct Tally {
  std::size_t grids = 0, samples = 0, above = 0;
  double worst = 0;     // above the strewn points, in diagonals of a cell
  double steepest = 0;  // above a neighbour plus the spacing, relative
};

void check(GridView<const float> level, Tally& tally) {
  constexpr int kLines = 4;
  const Grid<float> distance = closestDistance(level);
  const std::vector<double> strewn = test::strewnDistance(level, kLines);
  const std::vector<double> withZeros = test::strewnDistance(level, kLines, true);
  const glm::dvec3 extent = level.spacing * glm::dvec3(glm::min(level.size - 1, glm::ivec3(1)));
  const double diagonal = std::max(glm::length(extent), 1e-12);
  ++tally.grids;
  for (int z = 0; z < level.size.z; ++z)
    for (int y = 0; y < level.size.y; ++y)
      for (int x = 0; x < level.size.x; ++x) {
        const std::size_t i = level.index(x, y, z);
        const double here = std::abs(distance.data()[i]);
        ASSERT_EQ(std::signbit(distance.data()[i]), level.data[i] > 0);
        ASSERT_EQ(std::isinf(here), std::isinf(strewn[i]));
        if (std::isinf(here)) continue;
        // A piece of surface in a box of the lines crosses one of its edges, so a strewn point is a diagonal away at
        // most.
        ASSERT_GE(here, withZeros[i] - diagonal / kLines - 1e-5 * (1 + here));
        ++tally.samples;
        const double above = (here - strewn[i]) / diagonal;
        tally.above += above > .05 ? 1 : 0;
        tally.worst = std::max(tally.worst, above);
        for (int axis = 0; axis < 3; ++axis)
          for (const int side : {-1, 1}) {
            glm::ivec3 q(x, y, z);
            q[axis] += side;
            if (q[axis] < 0 || q[axis] >= level.size[axis]) continue;
            const double there = std::abs(distance.view()(q.x, q.y, q.z)) + level.spacing[axis];
            tally.steepest = std::max(tally.steepest, here / there - 1);
          }
      }
}

// 2500 grids of one kind. `worst` in diagonals of a cell.
void checkKind(Kind kind, double worst) {
  Tally tally;
  Draw draw(static_cast<std::uint64_t>(kind) + 1);
  while (tally.grids < 2500 && !testing::Test::HasFatalFailure()) {
    const Grid<float> level = drawLevel(draw, kind);
    SCOPED_TRACE(testing::Message() << "grid " << tally.grids << " of " << level.size().x << "x" << level.size().y
                                    << "x" << level.size().z << ", spacing z " << level.view().spacing.z);
    check(level.view(), tally);
  }
  EXPECT_GT(tally.samples, 100000U);
  EXPECT_LT(tally.above * 50, tally.samples);
  EXPECT_LT(tally.worst, worst);
  EXPECT_LT(tally.steepest, 1e-3);
}

// What all four claim: sign of the data; infinite only where nothing is inside; never below points strewn over the
// surface by more than their gap; above them by a twentieth of a cell's diagonal at one sample in fifty and by `worst`
// nowhere; no distance more than a neighbour's plus the spacing, to a thousandth.

TEST(ClosestProperties, OfNoise) {
  // The properties hold on noise; a nearer sheet that no start led to costs less than half a diagonal.
  checkKind(Kind::noise, .5);
}

TEST(ClosestProperties, OfSheetsThinnerThanAVoxel) {
  // The properties hold on single planes of samples inside, at any place in the grid.
  checkKind(Kind::sheet, .5);
}

TEST(ClosestProperties, OfPlateaus) {
  // The properties hold on levels of -1, 0 and 1. Where the surface ends in a corner of level 0, the nearest crossed
  // edge may stand for it, which ends three quarters of a diagonal further at most.
  checkKind(Kind::plateaus, .75);
}

TEST(ClosestProperties, OfExtremes) {
  // The properties hold on levels of 1e-30 beside 1e30, and of 0: what is 0 beside the largest ends as on plateaus.
  checkKind(Kind::extremes, .75);
}

}  // namespace
}  // namespace isolume
