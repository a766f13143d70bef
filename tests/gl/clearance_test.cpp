#include "raymarch/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "sweep/half.h"
#include "sweep/level.h"
#include "sweep/parallel.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

// Kind and side of a cell from its corners.
int cornersInside(GridView<const float> level, glm::ivec3 cell) {
  int inside = 0;
  for (int c = 0; c < 8; ++c) inside += level(cell.x + (c & 1), cell.y + ((c >> 1) & 1), cell.z + (c >> 2)) > 0;
  return inside;
}

// The code of every cell by brute force over all mixed cells, as shaders/shared/clearance_code.h says, written again.
std::vector<std::uint8_t> bruteForce(GridView<const float> level) {
  const glm::ivec3 cells = level.size - 1;
  std::vector<glm::ivec3> mixed;
  const auto forAll = [&](const auto& body) {
    for (int z = 0; z < cells.z; ++z)
      for (int y = 0; y < cells.y; ++y)
        for (int x = 0; x < cells.x; ++x) body(glm::ivec3(x, y, z));
  };
  forAll([&](glm::ivec3 cell) {
    if (cornersInside(level, cell) % 8 != 0) mixed.push_back(cell);
  });
  std::vector<std::uint8_t> codes;
  forAll([&](glm::ivec3 cell) {
    int nearest = 127;
    for (const glm::ivec3& other : mixed) {
      const glm::ivec3 apart = glm::abs(cell - other);
      nearest = std::min(nearest, std::max({apart.x, apart.y, apart.z}));
    }
    codes.push_back(static_cast<std::uint8_t>(nearest | (nearest > 0 && cornersInside(level, cell) == 8 ? 0x80 : 0)));
  });
  return codes;
}

TEST(Clearance, IsTheChessboardDistanceToTheNearestMixedCell) {
  // Every code equals brute force: kind, side and radius, on scenes with thin and thick parts.
  for (const char* name : {"corner", "gyroid", "capsules", "spheres"}) {
    SCOPED_TRACE(name);
    Grid<float> level = sampleScene(*findScene(name), 28);
    makeLevel(level.view(), 0, Inside::below);
    EXPECT_EQ(buildClearance(level.view()), bruteForce(level.view()));
  }
}

TEST(Clearance, HoldsForLoneSamplesFlatGridsAndAnyThreads) {
  // Two lone samples in grids of any shape, one cell thick included; one thread and many give the same bytes.
  for (const glm::ivec3 size : {glm::ivec3(36, 36, 36), glm::ivec3(2, 2, 2), glm::ivec3(2, 70, 9),
                                glm::ivec3(150, 2, 5), glm::ivec3(9, 140, 2), glm::ivec3(3, 2, 140)}) {
    SCOPED_TRACE(testing::Message() << size.x << "x" << size.y << "x" << size.z);
    Grid<float> level(size);
    std::fill_n(level.data(), level.count(), -1.0f);
    level.data()[level.count() / 3] = 0.01f;
    level.data()[level.count() - 1] = 5;
    setThreadCount(1);
    const std::vector<std::uint8_t> one = buildClearance(level.view());
    setThreadCount(5);
    const std::vector<std::uint8_t> many = buildClearance(level.view());
    setThreadCount(0);
    EXPECT_EQ(one, bruteForce(level.view()));
    EXPECT_EQ(many, one);
  }
}

TEST(Clearance, WithoutASurfaceIsTheLargestRadius) {
  // Nothing inside: 127 everywhere; all inside: the same with the inside bit.
  Grid<float> level(glm::ivec3(3));
  std::fill_n(level.data(), level.count(), -1.0f);
  for (std::uint8_t code : buildClearance(level.view())) EXPECT_EQ(code, 0x7f);
  std::fill_n(level.data(), level.count(), 1.0f);
  for (std::uint8_t code : buildClearance(level.view())) EXPECT_EQ(code, 0xff);
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
