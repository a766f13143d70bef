#include "raymarch/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "gl/gl_scene.h"
#include "raymarch/half.h"
#include "support/cpu_tracer.h"
#include "sweep/level.h"
#include "sweep/occlusion_sweep.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

// What shaders/shared/clearance_code.h says, written again.
bool isMixed(std::uint8_t code) { return (code & 0x7f) == 0; }
double radiusOf(std::uint8_t code) { return ((code & 0x7f) - 1) * 0.5; }

struct CellCheck {
  int mixed = 0, balls = 0, wrongKind = 0, wrongSide = 0, overlapping = 0;
};

// Points of the surface in a cell: where the interpolant changes sign along lines parallel to the axes.
std::vector<glm::dvec3> surfacePoints(GridView<const float> level, glm::ivec3 cell) {
  constexpr int kLines = 4;
  std::vector<glm::dvec3> points;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i <= kLines; ++i) {
      for (int j = 0; j <= kLines; ++j) {
        glm::dvec3 low(cell), high(cell);
        low[(axis + 1) % 3] += static_cast<double>(i) / kLines;
        low[(axis + 2) % 3] += static_cast<double>(j) / kLines;
        high = low;
        high[axis] += 1;
        const double a = test::levelAt(level, low), b = test::levelAt(level, glm::max(high - 1e-12, low));
        if ((a > 0) != (b > 0)) points.push_back(low + (high - low) * (a / (a - b)));  // linear along an axis
      }
    }
  }
  return points;
}

// Brute force: every ball against the surface in every cell that it reaches, in units of the smallest spacing.
CellCheck checkCells(GridView<const float> level, const std::vector<std::uint8_t>& codes) {
  const glm::ivec3 cells = level.size - 1;
  const double smallest = std::min({level.spacing.x, level.spacing.y, level.spacing.z});
  const glm::dvec3 scale = level.spacing / smallest;
  const auto at = [&](glm::ivec3 c) { return static_cast<std::size_t>((c.z * cells.y + c.y) * cells.x + c.x); };
  const auto forAll = [](glm::ivec3 low, glm::ivec3 high, const auto& body) {
    for (int z = low.z; z <= high.z; ++z) {
      for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) body(glm::ivec3(x, y, z));
      }
    }
  };
  std::vector<std::vector<glm::dvec3>> surface(codes.size());
  CellCheck check;
  forAll(glm::ivec3(0), cells - 1, [&](glm::ivec3 cell) {
    int inside = 0;
    for (int c = 0; c < 8; ++c) inside += level(cell.x + (c & 1), cell.y + ((c >> 1) & 1), cell.z + (c >> 2)) > 0;
    const bool mixed = inside != 0 && inside != 8;
    check.mixed += mixed;
    check.wrongKind += mixed != isMixed(codes[at(cell)]);
    check.wrongSide += !mixed && (inside == 8) != ((codes[at(cell)] & 0x80) != 0);
    if (mixed) surface[at(cell)] = surfacePoints(level, cell);
  });
  forAll(glm::ivec3(0), cells - 1, [&](glm::ivec3 cell) {
    const double radius = radiusOf(codes[at(cell)]);
    if (isMixed(codes[at(cell)]) || radius == 0) return;
    ++check.balls;
    bool overlapping = false;
    const glm::ivec3 reach = glm::ivec3(glm::ceil(radius / scale));
    forAll(glm::max(cell - reach, 0), glm::min(cell + reach, cells - 1), [&](glm::ivec3 other) {
      for (const glm::dvec3& p : surface[at(other)]) {
        overlapping = overlapping || glm::length((p - (glm::dvec3(cell) + 0.5)) * scale) < radius;
      }
    });
    check.overlapping += overlapping;
  });
  return check;
}

void expectSafe(GridView<const float> level, GridView<const float> distance) {
  const CellCheck check = checkCells(level, buildClearance(level, distance));
  EXPECT_GT(check.mixed, 0);
  EXPECT_GT(check.balls, 100);
  EXPECT_EQ(check.wrongKind, 0);
  EXPECT_EQ(check.wrongSide, 0);
  EXPECT_EQ(check.overlapping, 0);
}

TEST(Clearance, BallsOfTheSweptDistanceHoldNoSurface) {
  // With the distance as swept, which overestimates, no ball holds a point of the surface.
  for (const char* name : {"corner", "gyroid", "capsules", "spheres"}) {
    SCOPED_TRACE(name);
    Grid<float> level = sampleScene(*findScene(name), 32);
    makeLevel(level.view(), 0, Inside::below);
    expectSafe(level.view(), sweepOcclusion(level.view(), {VisibilityStorage::none}).distance.view());
  }
}

TEST(Clearance, LoneSamplesAndStretchedVoxels) {
  // Point-like solids, where upwinding overestimates most, in voxels of 1 : 0.5 : 4.
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 0.5, 4)}) {
    Grid<float> level(glm::ivec3(36), spacing);
    std::fill_n(level.data(), level.count(), -1.0f);
    level.view()(3, 5, 4) = 0.01f;
    level.view()(30, 20, 33) = 5;
    expectSafe(level.view(), sweepOcclusion(level.view(), {VisibilityStorage::none}).distance.view());
  }
}

TEST(Clearance, CheckFindsAnUnsafeBall) {
  // The brute-force check above fails for balls one step too large.
  const test::GlScene scene = test::makeSphere(24, 7.3);
  std::vector<std::uint8_t> codes = buildClearance(scene.level.view(), scene.distance.view());
  for (std::uint8_t& code : codes) {
    if (!isMixed(code)) code = static_cast<std::uint8_t>(code + 6);
  }
  EXPECT_GT(checkCells(scene.level.view(), codes).overlapping, 0);
}

TEST(Clearance, NoSurfaceAndNoNumber) {
  // Infinite distances give the largest ball, NaN the cell alone.
  Grid<float> level(glm::ivec3(3)), distance(glm::ivec3(3));
  std::fill_n(level.data(), level.count(), -1.0f);
  std::fill_n(distance.data(), distance.count(), std::numeric_limits<float>::infinity());
  for (std::uint8_t code : buildClearance(level.view(), distance.view())) EXPECT_EQ(code, 0x7f);
  distance.data()[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(buildClearance(level.view(), distance.view())[0], 1);
}

// Reference: the value of a half.
double valueOf(std::uint16_t half) {
  const int exponent = (half >> 10) & 31, mantissa = half & 1023;
  const double magnitude = exponent ? std::ldexp(1024 + mantissa, exponent - 25) : std::ldexp(mantissa, -24);
  return half & 0x8000 ? -magnitude : magnitude;
}

TEST(Half, RoundsToNearestEven) {
  // Each finite half is kept; just below, at and just above the middle of two neighbours go down, to even, up.
  for (std::uint16_t half = 0; half < 0x7bff; ++half) {
    const float low = static_cast<float>(valueOf(half)), high = static_cast<float>(valueOf(half + 1));
    const float middle = static_cast<float>((valueOf(half) + valueOf(half + 1)) / 2);
    ASSERT_EQ(halfFromFloat(low), half);
    ASSERT_EQ(halfFromFloat(-low), half | 0x8000);
    ASSERT_EQ(halfFromFloat(std::nextafter(middle, low)), half);
    ASSERT_EQ(halfFromFloat(middle), (half & 1) ? half + 1 : half);
    ASSERT_EQ(halfFromFloat(std::nextafter(middle, high)), half + 1);
  }
}

TEST(Half, LimitsWhatHasNoHalf) {
  // Infinities, NaN and large numbers become the largest half.
  EXPECT_EQ(halfFromFloat(std::numeric_limits<float>::infinity()), 0x7bff);
  EXPECT_EQ(halfFromFloat(-1e30f), 0xfbff);
  EXPECT_EQ(halfFromFloat(std::numeric_limits<float>::quiet_NaN()) & 0x7fff, 0x7bff);
}

}  // namespace
}  // namespace isolume
