// The colour maps, as eyes see them.
#include "src/compare/color_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <vector>

namespace isolume::test {
namespace {

/// CIELAB (D65) of linear sRGB.
glm::dvec3 labOf(glm::dvec3 rgb) {
  const glm::dmat3 xyzFromSrgb(.4124564, .2126729, .0193339, .3575761, .7151522, .1191920, .1804375, .0721750,
                               .9503041);
  const glm::dvec3 t = xyzFromSrgb * rgb / glm::dvec3(.95047, 1, 1.08883);
  const auto f = [](double v) { return v > 216.0 / 24389 ? std::cbrt(v) : (24389.0 / 27 * v + 16) / 116; };
  return {116 * f(t.y) - 16, 500 * (f(t.x) - f(t.y)), 200 * (f(t.y) - f(t.z))};
}

/// Full protanopia, deuteranopia and tritanopia of linear sRGB, [Machado09] Table 1, severity 1; columns.
const std::array<glm::dmat3, 3> kBlindness{
    {{.152286, .114503, -.003882, 1.052583, .786281, -.048116, -.204868, .099216, 1.051998},
     {.367322, .280085, -.011820, .860646, .672501, .042940, -.227968, .047413, .968881},
     {1.255528, -.078411, .004733, -.076749, .930809, .691367, -.178779, .147602, .303900}}};

double deltaE(glm::dvec3 a, glm::dvec3 b) { return glm::distance(labOf(a), labOf(b)); }  // CIE 1976

TEST(ColorMap, EndsStayApartForColourBlindEyes) {
  // Both ends, and the colours half way to them, differ by at least 40 in CIELAB, with and without [Machado09]'s colour
  // blindness; each also differs that much from the middle of the scale, at the ends.
  constexpr double kClearlyApart = 40;
  std::vector<glm::dmat3> eyes(kBlindness.begin(), kBlindness.end());
  eyes.emplace_back(1);
  for (const glm::dmat3& eye : eyes) {
    const auto seen = [&eye](double t) { return glm::max(glm::dvec3(0), eye * glm::dvec3(divergingColor(t))); };
    EXPECT_GE(deltaE(seen(-1), seen(1)), kClearlyApart);
    EXPECT_GE(deltaE(seen(-0.5), seen(0.5)), kClearlyApart);
    for (const double end : {-1.0, 1.0}) EXPECT_GE(deltaE(seen(end), seen(0)), kClearlyApart);
  }
}

TEST(ColorMap, LightnessFallsEvenlyOnBothSides) {
  // Lightness is 96 - 58 |t| within the rounding of the two matrices (1e-3): no step, no band, the same on both sides.
  for (int i = -100; i <= 100; ++i) {
    const double t = i / 100.0;
    EXPECT_NEAR(labOf(glm::dvec3(divergingColor(t))).x, 96 - 58 * std::abs(t), 1e-3) << t;
  }
}

TEST(ColorMap, HuesAreBlueAndOrange) {
  // Below 0 blue leads, above 0 red does; 0 is grey; beyond the ends nothing changes.
  for (int i = 1; i <= 10; ++i) {
    const glm::vec3 below = divergingColor(-i / 10.0), above = divergingColor(i / 10.0);
    EXPECT_GT(below.b, below.g);
    EXPECT_GT(below.g, below.r);
    EXPECT_GT(above.r, above.g);
    EXPECT_GT(above.g, above.b);
  }
  const glm::vec3 zero = divergingColor(0);
  EXPECT_NEAR(zero.r, zero.g, 1e-3);  // the rounding of the published matrix and white point
  EXPECT_NEAR(zero.b, zero.g, 1e-3);
  EXPECT_EQ(divergingColor(-5), divergingColor(-1));
  EXPECT_EQ(divergingColor(5), divergingColor(1));
}

TEST(ColorMap, LiesWithinSrgb) {
  // No channel is cut off at 0 or 1, which would bend hue and lightness.
  for (int i = -100; i <= 100; ++i)
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(divergingColor(i / 100.0)[c], 0) << i;
      EXPECT_LT(divergingColor(i / 100.0)[c], 1) << i;
    }
}

TEST(ColorMap, SequentialLightnessRisesEvenly) {
  // Lightness is 20 + 71 t within the rounding of the two matrices, so that values can be read without colour; no
  // channel is cut off; beyond the ends nothing changes.
  for (int i = 0; i <= 200; ++i) {
    const glm::vec3 color = sequentialColor(i / 200.0);
    EXPECT_NEAR(labOf(glm::dvec3(color)).x, 20 + 71 * i / 200.0, 1e-3) << i;
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(color[c], 0) << i;
      EXPECT_LT(color[c], 1) << i;
    }
  }
  EXPECT_EQ(sequentialColor(-1), sequentialColor(0));
  EXPECT_EQ(sequentialColor(2), sequentialColor(1));
}

TEST(ColorMap, SequentialStepsAreSeenByAllEyes) {
  // A tenth of the map is at least 7 in CIELAB, the part of lightness, with and without [Machado09]'s colour blindness
  // (which keeps lightness roughly: at least 5).
  for (int i = 0; i < 10; ++i) {
    const glm::dvec3 a(sequentialColor(i / 10.0)), b(sequentialColor((i + 1) / 10.0));
    EXPECT_GE(deltaE(a, b), 7) << i;
    for (const glm::dmat3& eye : kBlindness)
      EXPECT_GE(deltaE(glm::max(glm::dvec3(0), eye * a), glm::max(glm::dvec3(0), eye * b)), 5) << i;
  }
}

}  // namespace
}  // namespace isolume::test
