// Openness by ordinates in 15 bits: as in floats, exact in the open and the dark, the same for all threads and vectors.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "support/simd_targets.h"
#include "support/test_levels.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/ordinates/ordinate_set.h"
#include "sweep/parallel.h"
#include "sweep/transport/fixed_transport.h"
#include "sweep/transport/transport_sweep.h"

namespace isolume {
namespace {

constexpr TransportScheme kSchemes[] = {TransportScheme::step, TransportScheme::characteristic};
constexpr Transmittance kTransmittances[] = {Transmittance::centred, Transmittance::inside,
                                             Transmittance::insideByLength};

// Points anywhere in a grid, with normals all around.
std::vector<OpenPoint> pointsIn(glm::ivec3 size) {
  std::vector<OpenPoint> points;
  const std::vector<glm::dvec3> normals = ordinateDirections(200), places = ordinateDirections(57);
  for (std::size_t i = 0; i < normals.size(); ++i)
    points.push_back({glm::vec3(0.5 + 0.5 * places[i % places.size()]) * glm::vec3(size - 1), normals[i]});
  return points;
}

// Noise, open here and dense there: lumps with clear space between them.
Grid<float> lumps(glm::ivec3 size, glm::dvec3 spacing) {
  Grid<float> distance = test::noiseLevel(size, spacing, 9);
  const GridView<float> view = distance.view();
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) view(x, y, z) += 1.2F * std::sin(0.11F * static_cast<float>(x)) + 0.4F;
  return distance;
}

TEST(FixedTransport, IsThatOfFloats) {
  // At points anywhere in noise, of any scheme, transmittance and spacing, in blocks of rows and in one, what is
  // blocked is that of floats: to 3e-4, for 15 bits are rounded at every step of a ray, and a power's tau to 1/1024.
  for (const auto& [size, spacing] : {std::pair{glm::ivec3(33, 21, 27), glm::dvec3(1, 1.2, 0.8)},
                                      {glm::ivec3(70, 9, 12), glm::dvec3(1)},
                                      {glm::ivec3(1500, 11, 3), glm::dvec3(1)},
                                      {glm::ivec3(2), glm::dvec3(1)}}) {
    const Grid<float> distance = lumps(size, spacing);
    const std::vector<OpenPoint> points = pointsIn(size);
    for (const TransportScheme scheme : kSchemes)
      for (const Transmittance transmittance : kTransmittances) {
        const TransportOptions options{.ordinates = 150, .scheme = scheme, .transmittance = transmittance};
        const std::vector<float> want = transportOpenness(distance.view(), points, options);
        const std::vector<float> got = transportBlocked(distance.view(), points, options);
        for (std::size_t i = 0; i < want.size(); ++i) ASSERT_NEAR(1 - got[i], want[i], 3e-4) << size.x << " " << i;
        if (size.x > 2) {
          EXPECT_LT(*std::min_element(want.begin(), want.end()), 0.5);
        }
      }
  }
}

TEST(FixedTransport, ACoveredTunnelIsThatOfFloats) {
  // Rows of solid between what is lit in part and a tunnel: what is passed over in the dark lets no light through, to
  // 3e-4 as above. Rows and their parts are those that a sweep takes together.
  const glm::ivec3 size(48, 20, 20);
  Grid<float> distance(size);
  for (std::size_t i = 0; i < distance.count(); ++i) {
    const auto x = static_cast<int>(i % 48), y = static_cast<int>(i / 48 % 20);
    distance.data()[i] = (y >= 4 && y < 8) || (y < 4 && x >= 16) ? -9.0F : 9.0F;
  }
  std::vector<OpenPoint> points;
  for (int x = 0; x < size.x; ++x)
    for (const int y : {3, 9, 12}) points.push_back({glm::vec3(x, y, 10), glm::vec3(0, -1, 0)});
  const TransportOptions options{.offsetVoxels = 0};
  const std::vector<float> want = transportOpenness(std::as_const(distance).view(), points, options);
  const std::vector<float> got = transportBlocked(std::as_const(distance).view(), points, options);
  for (std::size_t i = 0; i < want.size(); ++i) EXPECT_NEAR(1 - got[i], want[i], 3e-4) << i;
}

TEST(FixedTransport, LightBeforeASolidIsFull) {
  // On each side of a block points that look away from it are open, exactly, though what is swept with them is not.
  const glm::ivec3 size(40);
  Grid<float> distance(size);
  const GridView<float> view = distance.view();
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        view(x, y, z) = glm::all(glm::lessThan(glm::abs(glm::ivec3(x, y, z) - 20), glm::ivec3(8))) ? -9.0F : 9.0F;
  std::vector<OpenPoint> points;
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0F, 1.0F}) {
      glm::vec3 position(20.3F, 18.9F, 21.7F), normal(0);
      normal[axis] = sign;
      position[axis] = 20 + 8 * sign;
      points.push_back({position, normal});
    }
  for (const TransportScheme scheme : kSchemes)
    for (const float blocked :
         transportBlocked(std::as_const(distance).view(), points, {.ordinates = 300, .scheme = scheme}))
      EXPECT_EQ(blocked, 0);
}

TEST(FixedTransport, OpenIsOpenAndDarkIsDark) {
  // Without a surface nothing is blocked, and deep in a solid everything is, at any normal, exactly.
  const glm::ivec3 size(40, 30, 26);
  std::vector<OpenPoint> points;
  for (const glm::dvec3& normal : ordinateDirections(60)) points.push_back({glm::vec3(size) / 2.0F, normal});
  Grid<float> distance(size);
  for (const float value : {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
    std::fill_n(distance.data(), distance.count(), value);
    for (const TransportScheme scheme : kSchemes)
      for (const Transmittance transmittance : kTransmittances)
        for (const float blocked : transportBlocked(std::as_const(distance).view(), points,
                                                    {.scheme = scheme, .transmittance = transmittance}))
          EXPECT_EQ(blocked, value > 0 ? 0.0F : 1.0F);
  }
}

TEST(FixedTransport, ALongPenumbraIsThatOfFloats) {
  // Far behind an edge, where V changes by less than a unit per voxel, rounding does not add up: 1e-3 of V of single
  // ordinates, of which the sweep without its dither is off by more.
  const glm::ivec3 size(250, 60, 250);
  Grid<float> distance(size);
  for (std::size_t i = 0; i < distance.count(); ++i) {
    const auto x = static_cast<int>(i % 250);
    const auto z = static_cast<int>(i / (250 * 60));
    distance.data()[i] = (z == 4 || z == 245) && x > 60 && x < 190 ? -9.0F : 9.0F;
  }
  std::vector<OpenPoint> points;
  for (int i = 2; i < 248; i += 3)
    for (const int z : {40, 125, 200}) points.push_back({glm::vec3(i, 30, z), glm::vec3(0, 0, i % 2 == 0 ? 1 : -1)});
  const TransportOptions options{.ordinates = 12, .offsetVoxels = 0};
  const std::vector<float> want = transportOpenness(std::as_const(distance).view(), points, options);
  const std::vector<float> got = transportBlocked(std::as_const(distance).view(), points, options);
  for (std::size_t i = 0; i < want.size(); ++i) EXPECT_NEAR(1 - got[i], want[i], 1e-3) << i;
}

TEST(FixedTransport, ThreadsAndInstructionSetsDoNotChangeABit) {
  // Every scheme and transmittance gives the same bits on every SIMD target, whose groups differ, and for one, two and
  // seven threads.
  const glm::ivec3 size(83, 21, 27);
  const Grid<float> distance = lumps(size, {1, 1.2, 0.8});
  const std::vector<OpenPoint> points = pointsIn(size);
  for (const TransportScheme scheme : kSchemes)
    for (const Transmittance transmittance : kTransmittances) {
      const TransportOptions options{.ordinates = 170, .scheme = scheme, .transmittance = transmittance};
      const std::vector<float> want = transportBlocked(distance.view(), points, options);
      test::onEverySimdTarget([&] { EXPECT_EQ(transportBlocked(distance.view(), points, options), want); });
      for (const int threads : {1, 2, 7}) {
        setThreadCount(threads);
        EXPECT_EQ(transportBlocked(distance.view(), points, options), want);
      }
      setThreadCount(0);
    }
}

TEST(TransportSweep, CapsAreOpenAndAPlaneIsOpen) {
  // A solid that fills the lower half of the grid and is cut by five of its faces: caps are open exactly, and the plane
  // to .01 by step and its ramp, which no light need pass.
  const int size = 24;
  const auto level = test::sampleLevel(glm::ivec3(size), glm::dvec3(1), [](glm::dvec3 p) { return 11.3 - p.z; });
  SweepOptions options;
  options.visibility = VisibilityStorage::none;
  const Grid<float> distance = sweepOcclusion(level.view(), options).distance;
  const SurfaceField field = sweepTransport(level.view(), distance.view());
  constexpr double kOpen = 65535;
  int caps = 0;
  for (int i = 0; i < kFaceCount; ++i) {
    const GridFace face = faceOf(i);
    for (int u = 0; u < size; ++u)
      for (int v = 0; v < size; ++v) {
        glm::ivec3 at(u, v, u);
        at[(face.axis + 1) % 3] = v;
        at[face.axis] = placeOf(face, level.size());
        if (const std::uint16_t cap = field.cap(face, at); cap > 0) {
          EXPECT_EQ(cap, kOpen);
          ++caps;
        }
      }
  }
  EXPECT_GT(caps, size * size);
  for (int x = 0; x < size; ++x) EXPECT_NEAR(field.wall({x, 12, 12}) / kOpen, 1, 0.01) << x;
}

TEST(TransportSweep, TakesDegenerateGrids) {
  // Single samples, lines and planes of samples: open wherever there is a surface.
  for (const glm::ivec3 size : {glm::ivec3(1), glm::ivec3(9, 1, 1), glm::ivec3(1, 7, 5)}) {
    const auto level = test::sampleLevel(size, glm::dvec3(1), [](glm::dvec3 p) { return p.x + p.y + p.z - 1.5; });
    Grid<float> distance(size);
    for (std::size_t i = 0; i < distance.count(); ++i) distance.data()[i] = -level.data()[i];
    const SurfaceField field = sweepTransport(level.view(), std::as_const(distance).view());
    int open = 0;
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const int value = field.wall({x, y, z});
          EXPECT_TRUE(value == 0 || value == 65535) << value;
          open += value == 65535 ? 1 : 0;
        }
    EXPECT_EQ(open > 0, size.x * size.y * size.z > 1);
  }
}

}  // namespace
}  // namespace isolume
