#include "sweep/ordinates/sky_ordinates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "support/random_numbers.h"
#include "sweep/octants/geometry_terms.h"
#include "sweep/ordinates/ordinate_set.h"
#include "sweep/reference/environment.h"

namespace isolume {
namespace {

using std::numbers::pi;
using Map = std::vector<glm::vec3>;

constexpr std::size_t kRed = 0;

// Orthonormal, as worldFromAxes may be: turned any way, and mirrored.
const glm::dmat3 kTurn(glm::rotate(glm::dmat4(1), 1.1, glm::normalize(glm::dvec3(1, 2, -0.5))));
const glm::dmat3 kMirror = kTurn * glm::dmat3(glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1));

std::size_t texels(glm::ivec2 size) { return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y); }

// E / pi of a point that nothing hides.
double openLight(const std::vector<Ordinate>& sky, glm::dvec3 normal, std::size_t channel = kRed) {
  double sum = 0;
  for (const Ordinate& each : sky) sum += each.value[channel] * std::max(glm::dot(each.direction, normal), 0.0);
  return sum;
}

Map randomMap(glm::ivec2 size, bool grey, std::uint64_t seed) {
  test::RandomNumbers numbers(seed);
  Map map;
  for (std::size_t i = 0; i < texels(size); ++i) {
    const glm::vec3 color(numbers.inCube());
    map.push_back(grey ? glm::vec3(color.r * color.r) : color);
  }
  return map;
}

// Direction of a place in the map, by the formula of sweep/reference/environment.h and turned counter-clockwise.
glm::dvec3 directionAt(glm::dvec2 place, glm::ivec2 size, double rotationDegrees) {
  const double around = 2 * pi * (place.x / size.x - 0.5) - glm::radians(rotationDegrees), fall = pi * place.y / size.y;
  return {std::sin(fall) * std::sin(around), std::sin(fall) * std::cos(around), std::cos(fall)};
}

// The integral of L w dw by 20 x 20 points in each texel.
glm::dvec3 lightVector(glm::ivec2 size, const Map& map, int channel, double rotationDegrees) {
  constexpr int kParts = 20;
  glm::dvec3 sum(0);
  for (int row = 0; row < size.y * kParts; ++row)
    for (int column = 0; column < size.x * kParts; ++column) {
      const glm::dvec2 place = (glm::dvec2(column, row) + 0.5) / static_cast<double>(kParts);
      const double area =
          2 * pi * pi / static_cast<double>(texels(size)) / kParts / kParts * std::sin(pi * place.y / size.y);
      const std::size_t texel = static_cast<std::size_t>(row / kParts * size.x + column / kParts);
      sum += area * map[texel][channel] * directionAt(place, size, rotationDegrees);
    }
  return sum;
}

TEST(SkyOrdinates, UniformSkyGivesAnOpenPointOne) {
  // The clamped cosines of all shares add up to 1, as ordinate_set_test.cpp bounds them: 4 / K of .65 K^-1/4.
  for (const int count : {32, 512, 2048}) {
    const std::vector<Ordinate> sky = uniformSky(count);
    ASSERT_EQ(sky.size(), static_cast<std::size_t>(count));
    test::RandomNumbers numbers(1);
    for (int i = 0; i < 100; ++i)
      EXPECT_NEAR(openLight(sky, numbers.direction()), 1, 4 * 0.65 * std::pow(count, -1.25)) << count;
  }
}

TEST(SkyOrdinates, BandsAddUpToTheUniformSky) {
  // Zenith, horizon and ground together have the value of the uniform sky in every direction, to a rounding of float;
  // the zenith's share is the height of the direction in the world, whatever the frame of the grid.
  for (const glm::dmat3& worldFromAxes : {glm::dmat3(1), kTurn, kMirror}) {
    const std::vector<Ordinate> bands = bandedSky(300, glm::transpose(worldFromAxes)), sky = uniformSky(300);
    ASSERT_EQ(bands.size(), sky.size());
    for (std::size_t i = 0; i < sky.size(); ++i) {
      const double height = (worldFromAxes * bands[i].direction).z, share = sky[i].value[0];
      EXPECT_NEAR(bands[i].value[0] + bands[i].value[1] + bands[i].value[2], share, 1e-6 * share);
      EXPECT_NEAR(bands[i].value[0], share * std::max(height, 0.0), 1e-6 * share);
      EXPECT_NEAR(bands[i].value[2], share * std::max(-height, 0.0), 1e-6 * share);
    }
  }
}

TEST(SkyOrdinates, BandsLightNormalsByTheirHeight) {
  // (1 / pi) integral of z cos dw over the upper half is 2/3 for a normal that points up, and for one across
  // (1 / pi) times the integral of sin^2 cos over quarter and half circle, 2 / (3 pi). To 1e-3 with 2048 ordinates.
  const std::vector<Ordinate> sky = bandedSky(2048, glm::dmat3(1));
  constexpr double kTolerance = 1e-3;
  EXPECT_NEAR(openLight(sky, {0, 0, 1}, 0), 2.0 / 3, kTolerance);
  EXPECT_NEAR(openLight(sky, {0, 0, 1}, 1), 1.0 / 3, kTolerance);
  EXPECT_NEAR(openLight(sky, {0, 0, 1}, 2), 0, kTolerance);
  for (const std::size_t channel : {0, 2}) EXPECT_NEAR(openLight(sky, {1, 0, 0}, channel), 2 / (3 * pi), kTolerance);
}

TEST(SkyOrdinates, AWhiteMapIsTheUniformSky) {
  // A white map of any size, down to one texel, lights every normal with 1, but for the shares that the horizon cuts,
  // and that are uneven by the blocks that they are made of: to 2.2 / K (measured: 1.82 / K).
  for (const glm::ivec2& size : {glm::ivec2(1, 1), glm::ivec2(4, 2), glm::ivec2(100, 37), glm::ivec2(600, 300)})
    for (const int count : {64, 256}) {
      const std::vector<Ordinate> sky = mappedSky(count, size, Map(texels(size), glm::vec3(1)), 17, kTurn);
      ASSERT_EQ(sky.size(), static_cast<std::size_t>(count));
      test::RandomNumbers numbers(2);
      for (int i = 0; i < 100; ++i)
        for (std::size_t channel = 0; channel < 3; ++channel)
          EXPECT_NEAR(openLight(sky, numbers.direction(), channel), 1, 2.2 / count) << size.x << " by " << count;
    }
}

TEST(SkyOrdinates, TheMapsLightVectorIsKept) {
  // The sum of value times direction is (1 / pi) times the integral of L w dw over the map: to 1e-5 of all light, the
  // error of the sum that it is compared with (1/24 of (1/20 of a texel's angle)^2 for 13 rows, 1e-5) and float.
  const glm::ivec2 size(24, 13);
  const Map map = randomMap(size, true, 3);
  for (const double rotation : {0.0, 33.0, -200.0})
    for (const glm::dmat3& worldFromAxes : {glm::dmat3(1), kTurn, kMirror}) {
      const std::vector<Ordinate> sky = mappedSky(200, size, map, rotation, glm::transpose(worldFromAxes));
      glm::dvec3 got(0);
      double all = 0;
      for (const Ordinate& each : sky) {
        got += static_cast<double>(each.value[kRed]) * (worldFromAxes * each.direction);
        all += each.value[kRed];
        EXPECT_NEAR(glm::length(each.direction), 1, 1e-12);
      }
      EXPECT_LT(glm::length(got - lightVector(size, map, 0, rotation) / pi), 1e-5 * all) << rotation;
    }
}

TEST(SkyOrdinates, ColoursLightNormalsAsTheMapDoes) {
  // E / pi of each colour of a random map is what all its texels give an open normal, to .02 with 512 ordinates
  // (measured: .0031).
  const glm::ivec2 size(24, 12);
  const Map map = randomMap(size, false, 4);
  const std::vector<Ordinate> sky = mappedSky(512, size, map, 0, glm::dmat3(1));
  test::RandomNumbers numbers(5);
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 normal = numbers.direction();
    glm::dvec3 want(0);
    constexpr int kParts = 10;
    for (int row = 0; row < size.y * kParts; ++row)
      for (int column = 0; column < size.x * kParts; ++column) {
        const glm::dvec2 place = (glm::dvec2(column, row) + 0.5) / static_cast<double>(kParts);
        const double area =
            2 * pi / static_cast<double>(texels(size)) / kParts / kParts * std::sin(pi * place.y / size.y);
        want += area * std::max(glm::dot(directionAt(place, size, 0), normal), 0.0) *
                glm::dvec3(map[static_cast<std::size_t>(row / kParts * size.x + column / kParts)]);
      }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(openLight(sky, normal, static_cast<std::size_t>(c)), want[c], 0.02) << c;
  }
}

TEST(SkyOrdinates, ABrightTexelStaysWhereItIs) {
  // With one bright texel every ordinate points into it, within half its diagonal from its centre, and their values
  // add up to its light, whatever the rotation and the frame of the grid.
  for (const glm::ivec2& size : {glm::ivec2(16, 8), glm::ivec2(1024, 512)})
    for (const glm::dvec2 where : {glm::dvec2(0.7, 0.3), glm::dvec2(0, 0.55), glm::dvec2(0.33, 0.99)}) {
      const glm::ivec2 texel(where * glm::dvec2(size));
      Map map(texels(size), glm::vec3(0));
      map[static_cast<std::size_t>(texel.y * size.x + texel.x)] = glm::vec3(7);
      for (const double rotation : {0.0, 90.0, 201.5})
        for (const glm::dmat3& worldFromAxes : {glm::dmat3(1), kTurn, kMirror}) {
          const std::vector<Ordinate> sky = mappedSky(256, size, map, rotation, glm::transpose(worldFromAxes));
          ASSERT_FALSE(sky.empty());
          const glm::dvec3 centre = directionAt(glm::dvec2(texel) + 0.5, size, rotation);
          double value = 0;
          for (const Ordinate& each : sky) {
            EXPECT_GT(glm::dot(worldFromAxes * each.direction, centre), std::cos(pi / size.y * std::sqrt(0.5)));
            value += each.value[kRed];
          }
          const double rows = std::cos(pi * texel.y / size.y) - std::cos(pi * (texel.y + 1) / size.y);
          const double want = 7 * 2 / static_cast<double>(size.x) * rows;
          // A texel's directions add up to less than its solid angle, by less than its angle squared over 12.
          EXPECT_NEAR(value, want, want * std::pow(2 * pi / size.x, 2) / 12) << size.x;
        }
    }
}

TEST(SkyOrdinates, LiesInTheWorldAsTheReferencesMap) {
  // Random texels of a map: what the reference sees from the direction of each ordinate of the map with that texel
  // alone is that texel. So right of the centre is +x, and the top +z.
  const glm::ivec2 size(40, 20);
  test::RandomNumbers numbers(6);
  for (int i = 0; i < 30; ++i) {
    Map map(texels(size), glm::vec3(0));
    map[static_cast<std::size_t>(numbers.below(static_cast<int>(map.size())))] = glm::vec3(1);
    const Environment environment(size, map);
    for (const Ordinate& each : mappedSky(64, size, map, 0, glm::dmat3(1)))
      EXPECT_EQ(environment.radiance(each.direction).x, 1);
  }
  Map right(8, glm::vec3(0));
  right[2] = right[6] = glm::vec3(1);  // 4 x 2 texels: from +y to +x
  const std::vector<Ordinate> sky = mappedSky(64, {4, 2}, right, 0, glm::dmat3(1));
  EXPECT_GT(openLight(sky, {1, 0, 0}), 4 * openLight(sky, {-1, 0, 0}) + 0.3);
  EXPECT_NEAR(openLight(sky, {1, 0, 0}), openLight(sky, {0, 1, 0}), 0.02);
  // A quarter turn counter-clockwise from above takes +x to +y.
  const std::vector<Ordinate> turned = mappedSky(64, {4, 2}, right, 90, glm::dmat3(1));
  EXPECT_LT(openLight(turned, {1, 0, 0}), 0.05);
  EXPECT_NEAR(openLight(turned, {-1, 0, 0}), openLight(turned, {0, 1, 0}), 0.02);
}

TEST(SkyOrdinates, ABlackMapHasNoLight) {
  // No ordinate at all: nothing is swept.
  EXPECT_TRUE(mappedSky(64, {8, 4}, Map(32, glm::vec3(0)), 0, glm::dmat3(1)).empty());
}

TEST(OctantSky, AnOctantGivesItsGeometryTerm) {
  // Light of one octant on an open point is G_s(N) / pi, of all eight 1: to what the horizon's shares of 2,048
  // ordinates make, a hundredth.
  constexpr int kCount = 2048;
  test::RandomNumbers numbers(6);
  for (int octant = 0; octant < kOctantCount; ++octant) {
    std::array<float, kOctantCount> one{}, even{};
    even.fill(1);
    one[static_cast<std::size_t>(octant)] = 1;
    const std::vector<Ordinate> sky = octantSky(kCount, one), all = octantSky(kCount, even);
    for (int i = 0; i < 100; ++i) {
      const glm::dvec3 normal = glm::normalize(numbers.inCube() - 0.5);
      EXPECT_NEAR(openLight(sky, normal), octantGeometryTerm(octant, normal) / pi, 0.01) << octant;
      EXPECT_NEAR(openLight(all, normal), 1, 0.01);
    }
  }
}

}  // namespace
}  // namespace isolume
