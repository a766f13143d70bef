// The shadow of a light from any direction, swept on a turned grid.
#include "sweep/octants/rotated_shadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "support/test_levels.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

using test::noiseLevel;
using test::sampleLevel;

// Rounding to 16 bits, of values that are the same up to the rounding of positions and sums.
constexpr int kRounding = 1;

// Distances without structure, more open than not.
Grid<float> noiseDistance(glm::ivec3 size) {
  Grid<float> distance = noiseLevel(size, glm::dvec3(1), 12);
  for (std::size_t i = 0; i < distance.count(); ++i) distance.data()[i] += 0.4F;
  return distance;
}

TEST(RotatedShadow, OfALightOnADiagonalIsThatOctant) {
  // A light on a diagonal needs no turn: the shadow is the octant that the plain sweep gives, at every sample.
  const Grid<float> distance = noiseDistance({21, 30, 26});
  for (const float opacity : {1.0F, 0.5F}) {
    const OctantVisibility octants = sweepVisibility(distance.view(), VisibilityStorage::float32, opacity);
    for (std::size_t s = 0; s < kOctants.size(); ++s) {
      const glm::dvec3 light = 0.37 * glm::dvec3(kOctants[s].towardsLight());
      const Grid<std::uint16_t> shadow = sweepRotatedShadow(distance.view(), light, {.opacity = opacity});
      for (std::size_t i = 0; i < distance.count(); ++i)
        ASSERT_NEAR(shadow.data()[i], 65535 * octants.octants[s].data()[i], 0.5 + kRounding) << "octant " << s;
    }
  }
}

TEST(RotatedShadow, TurnsByAQuarterWithTheScene) {
  // A scene that is turned by a quarter about any axis together with its light has the same shadow, turned: samples
  // (x, y) to (-y, x), and so for y, z and z, x.
  const glm::ivec3 n(24, 19, 28);
  const Grid<float> distance = noiseDistance(n);
  const glm::dvec3 light(0.3, -0.8, 0.45);
  const Grid<std::uint16_t> shadow = sweepRotatedShadow(distance.view(), light);
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto turn = [&](auto p, auto reach) {
      auto q = p;
      q[u] = reach - p[v];
      q[v] = p[u];
      return q;
    };
    glm::ivec3 size = n;
    std::swap(size[u], size[v]);
    Grid<float> turned(size);
    const auto forEach = [&](auto&& visit) {
      for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
          for (int x = 0; x < n.x; ++x) visit(glm::ivec3(x, y, z), turn(glm::ivec3(x, y, z), n[v] - 1));
    };
    forEach([&](glm::ivec3 p, glm::ivec3 q) { turned.view()(q.x, q.y, q.z) = distance.view()(p.x, p.y, p.z); });
    const Grid<std::uint16_t> other = sweepRotatedShadow(std::as_const(turned).view(), turn(light, 0.0));
    forEach([&](glm::ivec3 p, glm::ivec3 q) {
      ASSERT_NEAR(other.view()(q.x, q.y, q.z), shadow.view()(p.x, p.y, p.z), kRounding) << "axis " << axis;
    });
  }
}

TEST(RotatedShadow, FallsWhereTheLightSays) {
  // A plate covers x < 30 at z = 50 to 54. Under a light along (1, 0, 2) its edge shades what lies 1 further towards -x
  // for each 2 further down: there V crosses 1/2 to a voxel, and across it rises from 0 to 1 as the
  // scheme spreads light. With spacing 1/2 along x too: directions are physical.
  for (const double spacing : {1.0, 0.5}) {
    constexpr double kEdge = 30, kUnderside = 50;
    const Grid<float> distance =
        sampleLevel({static_cast<int>(64 / spacing), 24, 60}, glm::dvec3(spacing, 1, 1), [&](glm::dvec3 p) {
          const double x = p.x - kEdge, z = std::abs(p.z - (kUnderside + 2)) - 2;
          return x > 0 && z > 0 ? std::hypot(x, z) : std::max(x, z);
        });
    const Grid<std::uint16_t> shadow = sweepRotatedShadow(distance.view(), {1, 0, 2});
    for (const int z : {25, 35, 45}) {
      const double rim = kEdge - (kUnderside - z) / 2;
      int before = 0;
      double crossing = 0;
      for (int x = 1; x < distance.size().x; ++x) {
        const int here = shadow.view()(x, 12, z);
        if (before < 32768 && here >= 32768) crossing = spacing * x;
        before = here;
      }
      EXPECT_NEAR(crossing, rim, 1) << z;
      // A walk along one of three axes at each step gains h / sqrt(3) on its way and strays by h / sqrt(3) across it;
      // beyond three standard deviations lies .0013. Two voxels for what is interpolated.
      const double slant = std::sqrt(5.0) / 2, way = slant * (kUnderside - z);
      const double wide = 3 * std::sqrt(way / std::sqrt(3.0)) * slant + 2;
      const auto at = [&](double x) { return shadow.view()(static_cast<int>(std::lround(x / spacing)), 12, z); };
      EXPECT_LT(at(rim - wide), 0.005 * 65535) << z;
      EXPECT_GT(at(rim + wide), 0.995 * 65535) << z;
    }
  }
}

TEST(RotatedShadow, OffsetReadsFurtherOut) {
  // Over a floor the gradient is z: read two voxels out, each sample has what the one two above it has.
  const Grid<float> distance = sampleLevel({20, 22, 24}, glm::dvec3(1), [](glm::dvec3 p) { return p.z - 9.3; });
  const glm::dvec3 light(1, 0.2, 0.3);
  const Grid<std::uint16_t> atSample = sweepRotatedShadow(distance.view(), light);
  const Grid<std::uint16_t> above = sweepRotatedShadow(distance.view(), light, {.offsetVoxels = 2});
  int apart = 0;
  for (int z = 0; z < 22; ++z) {
    EXPECT_NEAR(above.view()(10, 11, z), atSample.view()(10, 11, z + 2), kRounding) << z;
    apart += std::abs(above.view()(10, 11, z) - atSample.view()(10, 11, z)) > 100;
  }
  EXPECT_GE(apart, 2);
}

TEST(RotatedShadow, WithoutASurfaceAllOrNothingArrives) {
  // Nothing solid: lit exactly, from any direction. All solid: dark in the middle. Clear: lit exactly again.
  Grid<float> distance({20, 16, 18}, glm::dvec3(1, 1.5, 2));
  const auto fill = [&](float value) { std::fill_n(distance.data(), distance.count(), value); };
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const glm::dvec3 light : {glm::dvec3(0, 0, 1), glm::dvec3(-1, 0, 0), glm::dvec3(0.2, -3, 1)}) {
    fill(kInfinity);
    const Grid<std::uint16_t> open = sweepRotatedShadow(std::as_const(distance).view(), light);
    fill(-kInfinity);
    const Grid<std::uint16_t> solid = sweepRotatedShadow(std::as_const(distance).view(), light);
    const Grid<std::uint16_t> clear = sweepRotatedShadow(std::as_const(distance).view(), light, {.opacity = 0});
    for (std::size_t i = 0; i < distance.count(); ++i) {
      ASSERT_EQ(open.data()[i], 65535);
      ASSERT_EQ(clear.data()[i], 65535);
    }
    EXPECT_EQ(solid.view()(10, 8, 9), 0);
  }
}

TEST(RotatedShadow, ThreadsDoNotChangeABit) {
  // One and seven threads give the same shadow.
  const Grid<float> distance = noiseDistance({40, 33, 29});
  setThreadCount(1);
  const Grid<std::uint16_t> one = sweepRotatedShadow(distance.view(), {0.1, 0.5, -2}, {.offsetVoxels = 1});
  setThreadCount(7);
  const Grid<std::uint16_t> seven = sweepRotatedShadow(distance.view(), {0.1, 0.5, -2}, {.offsetVoxels = 1});
  setThreadCount(0);
  EXPECT_EQ(std::memcmp(one.data(), seven.data(), distance.count() * sizeof(std::uint16_t)), 0);
}

}  // namespace
}  // namespace isolume
