// Maps of light from all around.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "estimators/closed_form.h"
#include "sweep/reference/low_discrepancy.h"

namespace isolume::test {
namespace {

/// A dark map with one bright texel.
Environment sun(glm::ivec2 size, glm::ivec2 texel, float radiance, float rest) {
  std::vector<glm::vec3> map(static_cast<std::size_t>(size.x) * size.y, glm::vec3(rest));
  map[static_cast<std::size_t>(texel.y) * size.x + texel.x] = glm::vec3(radiance);
  return Environment(size, std::move(map));
}

TEST(Environment, LiesInTheWorldAsDocumented) {
  // 4 x 2 texels: the upper row is the sky; from left to right its quarters end at -y, -x, +y, +x and -y again.
  std::vector<glm::vec3> map;
  for (int i = 0; i < 8; ++i) map.emplace_back(static_cast<float>(i));
  const Environment environment({4, 2}, map);
  const auto at = [&](glm::dvec3 direction) { return environment.radiance(glm::normalize(direction)).x; };
  EXPECT_EQ(at({-1, -1, 1}), 0);
  EXPECT_EQ(at({-1, 1, 1}), 1);
  EXPECT_EQ(at({1, 1, 1}), 2);
  EXPECT_EQ(at({1, -1, 1}), 3);
  EXPECT_EQ(at({1, -1, -1}), 7);
  EXPECT_EQ(at({0, 0, 1}), 2);  // the pole belongs to the column of +y
  EXPECT_EQ(at({0, 0, -1}), 6);
}

TEST(Environment, DrawsWithTheDensityThatItTells) {
  // The mean of g / density over drawn directions is the integral of g over the texels that can be drawn, here with
  // g = radiance: the bright texels' radiance times their solid angles. All drawn directions fall into them.
  const glm::ivec2 size(8, 4);
  std::vector<glm::vec3> map(32, glm::vec3(1));
  map[10] = glm::vec3(50);  // row 1, column 2
  map[31] = glm::vec3(9);   // the last one
  const Environment environment(size, map);
  ASSERT_GT(environment.drawnShare(), 0);
  const auto angle = [](int row) { return kPi / 4 * (std::cos(kPi * row / 4) - std::cos(kPi * (row + 1) / 4)); };
  constexpr int kCount = 4096;
  double sum = 0;
  for (int i = 0; i < kCount; ++i) {
    const glm::dvec3 direction = environment.draw(scrambledSobol(1, 0, static_cast<std::uint32_t>(i)));
    EXPECT_NEAR(glm::length(direction), 1, 1e-15);
    const double radiance = environment.radiance(direction).x;
    EXPECT_GT(radiance, 1);
    sum += radiance / environment.density(direction);
  }
  // Two values of g / density, in shares that 4096 stratified points meet to 1 in 4096; they differ by a factor
  // below 2.
  const double want = 50 * angle(1) + 9 * angle(3);
  EXPECT_NEAR(sum / kCount, want, 2 * want / kCount);
  EXPECT_EQ(environment.density({0, 0.5, std::sqrt(0.75)}), 0);  // a texel darker than the mean
}

TEST(Environment, DrawsFromTheEdgesOfTheSquare) {
  // The extreme points of the square give directions of the bright texel too, also where it is the last of its row.
  const Environment environment = sun({5, 3}, {4, 2}, 7, 0);
  for (const double u : {0x1p-33, 0.5, 1 - 0x1p-33})
    for (const double v : {0x1p-33, 0.5, 1 - 0x1p-33}) EXPECT_GE(environment.density(environment.draw({u, v})), 0);
  EXPECT_EQ(environment.radiance(environment.draw({0.5, 0.5})).x, 7);
}

TEST(Environment, WhiteMapIsTheOpenness) {
  // E / pi under a white map has the bits of the openness, value and error, with the same samples.
  const TestScene corner(glm::ivec3(17), glm::dvec3(1),
                         [](glm::dvec3 p) { return std::max(floorLevel(p, 4), 5 - p.x); });
  const Environment white({4, 2}, std::vector<glm::vec3>(8, glm::vec3(1)));
  IntegrandSettings settings;
  settings.integrand = Integrand::environment;
  settings.environment = &white;
  const ShadedPoint point = pointOn({6, 8, 4});
  const ChannelEstimate light = estimateAt(corner.scene(), settings, {}, point, 9).channels;
  const ChannelEstimate open = estimateAt(corner.scene(), {}, {}, point, 9).channels;
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(light.value[c], open.value[0]);
    EXPECT_EQ(light.standardError[c], open.standardError[0]);
  }
}

TEST(Environment, SunOfOneTexelConverges) {
  // One texel of a 128 x 64 map, 10000 times as bright as the rest, over an open plane: the closed form is the integral
  // of the cosine over the texel, within 1 % from 1024 rays; cosine-weighted rays alone would meet it once or never.
  const glm::ivec2 size(128, 64), texel(40, 12);
  const Environment environment = sun(size, texel, 1e4f, 1);
  const TestScene plane(glm::ivec3(9), glm::dvec3(1), [](glm::dvec3 p) { return floorLevel(p, 4); });
  const double top = kPi * texel.y / size.y, bottom = kPi * (texel.y + 1) / size.y;
  const double sines = std::sin(bottom) * std::sin(bottom) - std::sin(top) * std::sin(top);
  const double want = 1 + (1e4 - 1) * sines / 2 * (2 * kPi / size.x) / kPi;
  EXPECT_GT(want, 3);
  IntegrandSettings settings;
  settings.integrand = Integrand::environment;
  settings.environment = &environment;
  const ShadedPoint point = pointOn({4, 4, 4});
  const ChannelEstimate few = estimateAt(plane.scene(), settings, {.rays = 1024}, point, 0).channels;
  EXPECT_NEAR(few.value[0], want, 0.01 * want);
  EXPECT_LT(few.standardError[0], 0.01 * want);
  // With so many rays the cosine-weighted ones meet the sun a dozen times, too, and the error knows of them.
  const ChannelEstimate many = estimateAt(plane.scene(), settings, {.rays = 1 << 16}, point, 0).channels;
  EXPECT_NEAR(many.value[0], want, allowed(many.standardError[0]));
  EXPECT_LT(many.standardError[0], 1e-3 * want);
}

TEST(Environment, SunIsShadowed) {
  // A sun behind the wall gives nothing but the rest of the sky; turned to the other side by the world it gives itself.
  const Environment environment = sun({128, 64}, {32, 20}, 1e4f, 0);  // at -x
  const TestScene corner(glm::ivec3(17), glm::dvec3(1),
                         [](glm::dvec3 p) { return std::max(floorLevel(p, 4), 5 - p.x); });
  IntegrandSettings settings;
  settings.integrand = Integrand::environment;
  settings.environment = &environment;
  const ShadedPoint point = pointOn({5.5, 8, 4});
  const glm::dmat3 halfTurn(glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1));
  EXPECT_EQ(estimateAt(corner.scene(), settings, {}, point, 0).channels.value[0], 0);
  EXPECT_GT(estimateAt({corner.tracer, halfTurn}, settings, {}, point, 0).channels.value[0], 1);
}

}  // namespace
}  // namespace isolume::test
