// The sky as cube maps: where texels lie, what maps and bands come to, and convolutions with known integrals.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <numeric>

#include "raymarch/screen/sky_convolution.h"
#include "support/random_numbers.h"

namespace isolume::test {
namespace {

using std::numbers::pi;

glm::dvec3 centreOf(int side, std::size_t index) {
  const auto edge = static_cast<std::size_t>(side), texel = index % (edge * edge);
  return cubeDirection(side, static_cast<int>(index / (edge * edge)),
                       {static_cast<double>(texel % edge) + 0.5, static_cast<double>(texel / edge) + 0.5});
}

/// Integral of the radiance over all directions.
glm::dvec3 wholeLight(const SkyCube& sky) {
  const std::vector<double> angles = cubeSolidAngles(sky.side);
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < sky.radiance.size(); ++i) sum += angles[i % angles.size()] * glm::dvec3(sky.radiance[i]);
  return sum;
}

SkyCube skyOf(const std::function<glm::dvec3(glm::dvec3)>& radiance) {
  SkyCube sky;
  for (std::size_t i = 0; i < sky.radiance.size(); ++i) sky.radiance[i] = radiance(centreOf(sky.side, i));
  return sky;
}

TEST(SkyCube, TexelsCoverTheSphere) {
  // The centre of each texel lies in that texel, solid angles add up to the sphere, and faces lie along their axes.
  constexpr int kSide = 8;
  for (std::size_t i = 0; i < kCubeFaces * kSide * kSide; ++i) ASSERT_EQ(cubeTexel(kSide, 3.0 * centreOf(kSide, i)), i);
  const std::vector<double> angles = cubeSolidAngles(kSide);
  EXPECT_NEAR(std::accumulate(angles.begin(), angles.end(), 0.0), 4 * pi / kCubeFaces, 1e-12);
  for (int face = 0; face < kCubeFaces; ++face)
    EXPECT_EQ(cubeDirection(kSide, face, glm::dvec2(kSide / 2.0))[face / 2], face % 2 == 0 ? 1 : -1);
}

TEST(SkyCube, MapsKeepTheirLightAndItsPlace) {
  // A map with one bright texel gives the cube that texel's light, in the direction that environment.h names, turned by
  // the rotation and by the axes of the grid; a coarse map of two halves gives two halves.
  const glm::ivec2 size(64, 32);
  const glm::dmat3 worldFromAxes(glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, 2, 3))));
  for (const glm::ivec2 bright : {glm::ivec2(3, 5), glm::ivec2(40, 16), glm::ivec2(63, 27)}) {
    std::vector<glm::vec3> radiance(static_cast<std::size_t>(size.x * size.y), glm::vec3(0));
    radiance[static_cast<std::size_t>(bright.y * size.x + bright.x)] = {3, 2, 1};
    constexpr double kRotation = 25;
    SkyCube sky;
    addMappedSky(sky, size, radiance, kRotation, 2, worldFromAxes);
    const double top = pi * bright.y / size.y, bottom = pi * (bright.y + 1) / size.y;
    const double angle = 2 * pi / size.x * (std::cos(top) - std::cos(bottom));
    // A texel's mean is over the parts that fall into it: their solid angle is the texel's to a few percent.
    const glm::dvec3 whole = wholeLight(sky);
    EXPECT_NEAR(whole.r, 6 * angle, 0.05 * 6 * angle);
    EXPECT_NEAR(whole.b, whole.r / 3, 1e-6);
    const double turn = 2 * pi * ((bright.x + 0.5) / size.x - 0.5) - glm::radians(kRotation), fall = (top + bottom) / 2;
    const glm::dvec3 world(std::sin(fall) * std::sin(turn), std::sin(fall) * std::cos(turn), std::cos(fall));
    EXPECT_GT(sky.radiance[cubeTexel(sky.side, glm::transpose(worldFromAxes) * world)].r, 5.9);
  }
  SkyCube halves;
  addMappedSky(halves, {2, 1}, {glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)}, 0, 1, glm::dmat3(1));
  for (std::size_t i = 0; i < halves.radiance.size(); ++i) {
    const double x = centreOf(halves.side, i).x;
    if (std::abs(x) > 0.03) {
      ASSERT_EQ(halves.radiance[i], x < 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1));
    }
  }
}

TEST(SkyCube, BandsFollowTheHeightInTheWorld) {
  // Zenith, horizon and ground add up by the height of the direction, whatever the axes; an even sky adds to them.
  const glm::dmat3 worldFromAxes(glm::rotate(glm::dmat4(1), 1.1, glm::normalize(glm::dvec3(3, -1, 2))));
  SkyCube sky;
  addBandedSky(sky, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, worldFromAxes);
  addEvenSky(sky, {2, 0, 0});
  for (std::size_t i = 0; i < sky.radiance.size(); i += 97) {
    const double z = (worldFromAxes * centreOf(sky.side, i)).z;
    EXPECT_NEAR(sky.radiance[i].r, 2 + std::max(z, 0.0), 1e-6);
    EXPECT_NEAR(sky.radiance[i].g, 1 - std::abs(z), 1e-6);
    EXPECT_NEAR(sky.radiance[i].b, std::max(-z, 0.0), 1e-6);
  }
}

TEST(SkyCube, HalvingKeepsTheLight) {
  // With half the texels the light of the whole sky is the same, and a texel's that of its four.
  RandomNumbers numbers(3);
  const SkyCube sky = skyOf([&](glm::dvec3) { return glm::dvec3(numbers.direction() + 1.0); });
  const SkyCube half = halvedSky(sky);
  EXPECT_LT(glm::distance(wholeLight(sky), wholeLight(half)), 1e-4);
  const std::size_t at = 2 * (64 * 64) + 10 * 64 + 20;  // face 2, row 10, column 20
  const std::vector<double> angles = cubeSolidAngles(64);
  glm::dvec3 sum(0);
  double whole = 0;
  for (const std::size_t i : {at, at + 1, at + 64, at + 65}) {
    sum += angles[i % angles.size()] * glm::dvec3(sky.radiance[i]);
    whole += angles[i % angles.size()];
  }
  EXPECT_LT(glm::distance(sum / whole, glm::dvec3(half.radiance[2 * (32 * 32) + 5 * 32 + 10])), 1e-6);
}

TEST(SkyConvolution, ConstantSkyIsConstant) {
  // Within a cone of any angle a constant sky is that constant, to rounding: t normalises the cosine.
  SkyCube sky;
  addEvenSky(sky, {0.5f, 1, 2});
  const auto cubes = convolvedSky(sky, 0);
  ASSERT_EQ(cubes.size(), static_cast<std::size_t>(kConeAngles));
  for (const auto& cube : cubes)
    for (const glm::vec3& light : cube) ASSERT_LT(glm::distance(light, glm::vec3(0.5f, 1, 2)), 1e-4f);
}

TEST(SkyConvolution, LinearSkyHasItsClosedForm) {
  // Under L = 1 + d . w a cone about n has 1 + (2/3) (1 - cos^3 a) / (1 - cos^2 a) d . n, and L_p is that of a = pi
  // / 2. Tolerance: a cone's rim is as wide as a texel, of which narrow cones have few.
  const glm::dvec3 d = glm::normalize(glm::dvec3(0.4, -0.7, 0.5));
  const auto cubes = convolvedSky(skyOf([&](glm::dvec3 w) { return glm::dvec3(1 + glm::dot(d, w)); }), 0);
  for (int k = 0; k < kConeAngles; ++k) {
    const double c = std::cos(coneAngle(k)), slope = 2.0 / 3 * (1 - c * c * c) / (1 - c * c);
    for (std::size_t i = 0; i < cubes[0].size(); i += 101)
      EXPECT_NEAR(cubes[static_cast<std::size_t>(k)][i].r, 1 + slope * glm::dot(d, centreOf(kConeSide, i)), 5e-3) << k;
  }
}

/// L_c by a sum over a fine spiral of directions within the cone.
double coneByQuadrature(const std::function<double(glm::dvec3)>& radiance, glm::dvec3 axis, double angle) {
  constexpr int kDirections = 20000;
  const glm::dvec3 other = std::abs(axis.z) < 0.5 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(axis, other)), y = glm::cross(axis, x);
  double sum = 0, whole = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1 - (1 - std::cos(angle)) * (i + 0.5) / kDirections, turn = 2 * pi * i / std::numbers::phi;
    const double across = std::sqrt(1 - z * z);
    sum += z * radiance(across * (std::cos(turn) * x + std::sin(turn) * y) + z * axis);
    whole += z;
  }
  return sum / whole;
}

TEST(SkyConvolution, LobeMatchesQuadrature) {
  // A lobe of 20 degrees about a slanted direction, and each cone about directions on and off it, agree with a sum over
  // 20,000 directions to a hundredth of its peak.
  const glm::dvec3 d = glm::normalize(glm::dvec3(-0.2, 0.5, 0.8));
  const auto lobe = [&](glm::dvec3 w) { return std::pow(std::max(glm::dot(d, w), 0.0), 12); };
  const SkyCube sky = skyOf([&](glm::dvec3 w) { return glm::dvec3(lobe(w)); });
  const auto cubes = convolvedSky(sky, 0);
  for (const glm::dvec3& towards : {d, glm::dvec3(0, 0, 1), glm::dvec3(-0.9, 0.1, 0.4), glm::dvec3(0.2, -0.5, 0.1)}) {
    const std::size_t at = cubeTexel(kConeSide, towards);
    for (int k = 0; k < kConeAngles; ++k)
      EXPECT_NEAR(cubes[static_cast<std::size_t>(k)][at].r,
                  coneByQuadrature(lobe, centreOf(kConeSide, at), coneAngle(k)), 0.01)
          << k;
  }
  const auto widest = convolvedSky(sky, kConeAngles - 1);
  ASSERT_EQ(widest.size(), 1U);
  EXPECT_EQ(widest[0], cubes[kConeAngles - 1]);
}

}  // namespace
}  // namespace isolume::test
