// Ordinates swept as light: schemes, transmittances, and openness at points.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "support/octant_openness.h"
#include "support/simd_targets.h"
#include "support/test_levels.h"
#include "sweep/ordinates/ordinate_set.h"
#include "sweep/parallel.h"
#include "sweep/transport/openness_transport.h"

namespace isolume {
namespace {

constexpr TransportScheme kSchemes[] = {TransportScheme::step, TransportScheme::characteristic};
constexpr Transmittance kTransmittances[] = {Transmittance::centred, Transmittance::inside,
                                             Transmittance::insideByLength};

TEST(Transport, WeightsAreAMeanOfVoxelsThatLiesOnTheRay) {
  // Of any ordinate and spacing the weights are not negative, sum to 1, and the mean of the voxels that they take light
  // from lies straight back along the ordinate.
  for (const TransportScheme scheme : kSchemes)
    for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(0.4, 1.1, 2.3)})
      for (const glm::dvec3& direction : ordinateDirections(60)) {
        const UpwindWeights weights = upwindWeights(scheme, direction, spacing);
        double sum = 0;
        glm::dvec3 mean(0);
        for (int mask = 1; mask < 8; ++mask) {
          const double weight = weights[static_cast<std::size_t>(mask) - 1];
          EXPECT_GE(weight, 0);
          sum += weight;
          mean += weight * spacing * glm::dvec3(mask & 1, mask >> 1 & 1, mask >> 2);
        }
        EXPECT_NEAR(sum, 1, 1e-6);
        EXPECT_LT(glm::length(glm::cross(glm::normalize(mean), glm::abs(direction))), 1e-6);
      }
}

TEST(Transport, OpenPointsAreOpenAtAnyNormal) {
  // Without a surface A is 1 to the rounding of the sweep, whatever the normal, the spacing and the number of
  // ordinates.
  for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(0.7, 1.3, 2)}) {
    Grid<float> distance({30, 22, 26}, spacing);
    std::fill_n(distance.data(), distance.count(), std::numeric_limits<float>::infinity());
    std::vector<OpenPoint> points;
    for (const glm::dvec3& normal : ordinateDirections(40)) points.push_back({{14.3F, 11.8F, 12.6F}, normal});
    for (const TransportScheme scheme : kSchemes)
      for (const int ordinates : {1, 9, 72, 300})
        for (const float openness :
             transportOpenness(std::as_const(distance).view(), points, {.ordinates = ordinates, .scheme = scheme}))
          EXPECT_NEAR(openness, 1, 2e-5) << ordinates;
  }
}

TEST(Transport, RampsLieWhereTheySay) {
  // Eq. 7 lets half through on the surface; the others all of it, and nothing from a voxel inside on.
  EXPECT_EQ(rampOf(Transmittance::centred, 0), 0.5F);
  EXPECT_EQ(rampOf(Transmittance::centred, 0.5F), 1);
  EXPECT_EQ(rampOf(Transmittance::centred, -0.5F), 0);
  for (const Transmittance model : {Transmittance::inside, Transmittance::insideByLength}) {
    EXPECT_EQ(rampOf(model, 0), 1);
    EXPECT_EQ(rampOf(model, -0.25F), 0.75F);
    EXPECT_EQ(rampOf(model, -1), 0);
  }
  EXPECT_EQ(powerOf(Transmittance::inside, {0.6, 0, 0.8}), 1);
  EXPECT_NEAR(powerOf(Transmittance::insideByLength, {0.6, 0, -0.8}), 1 / 1.4, 1e-6);
}

// V of one ordinate along a line across the shadow of an edge, `depth` layers behind the plate. The plate lies across
// the axis that the light follows most, `along`, and ends half way along `across`.
struct Shadow {
  double middle = 0;    // where V crosses 1/2, in voxels from where the ray through the edge's upper side falls
  double variance = 0;  // of dV, as a distribution
};
Shadow shadowOf(TransportScheme scheme, int depth) {
  constexpr int kSize = 130, kHalf = kSize / 2, kMargin = 20;
  const glm::dvec3 light = ordinateDirections(1)[0], size = glm::abs(light);
  const int along = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int across = size[(along + 1) % 3] >= size[(along + 2) % 3] ? (along + 1) % 3 : (along + 2) % 3;
  const int sign = light[across] > 0 ? 1 : -1;  // the plate covers the side that no border lights
  const int plate = light[along] > 0 ? kSize - kMargin : kMargin, away = light[along] > 0 ? -1 : 1;
  Grid<float> distance{glm::ivec3(kSize)};
  for (int z = 0; z < kSize; ++z)
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const glm::ivec3 p(x, y, z);
        const bool solid = p[along] == plate && sign * (p[across] - kHalf) < 0;
        distance.view()(x, y, z) = solid ? -10.0F : 10.0F;
      }
  std::vector<OpenPoint> points;
  for (int i = 0; i < kSize; ++i) {
    glm::ivec3 p(kHalf);
    p[along] = plate + away * depth;
    p[across] = i;
    points.push_back({p, light});
  }
  const std::vector<float> visible =
      transportOpenness(std::as_const(distance).view(), points, {.ordinates = 1, .scheme = scheme, .offsetVoxels = 0});
  const double shift = away * depth * light[across] / light[along];
  double total = 0, mean = 0, square = 0;
  for (int i = 1; i < kSize; ++i) {
    const double here = visible[static_cast<std::size_t>(i)], before = visible[static_cast<std::size_t>(i) - 1];
    const double rise = sign * (here - before);
    const double place = sign * (i - 0.5 - (kHalf - 0.5 * sign + shift));
    total += rise;
    mean += rise * place;
    square += rise * place * place;
  }
  EXPECT_NEAR(total, 1, 1e-3);
  return {mean, square - mean * mean};
}

TEST(Transport, ABeamPastAnEdgeFallsWhereItsRayFalls) {
  // Behind an edge the middle of the penumbra lies on the ray past it, to a third of a voxel; its variance grows with
  // the depth, for light diffuses a voxel at a time, and that of the characteristic scheme is the smaller one.
  Shadow last[2][2];
  for (int s = 0; s < 2; ++s)
    for (int k = 0; k < 2; ++k) {
      last[s][k] = shadowOf(kSchemes[s], k == 0 ? 20 : 40);
      EXPECT_NEAR(last[s][k].middle, 0, 0.34);
    }
  for (const auto& shadows : last) EXPECT_NEAR(shadows[1].variance / shadows[0].variance, 2, 0.2);
  EXPECT_LT(last[1][1].variance, 0.8 * last[0][1].variance);
}

// Noise with points in it.
struct Scene {
  Grid<float> distance = test::noiseLevel({33, 21, 27}, {1, 1.2, 0.8}, 9);
  std::vector<OpenPoint> points;
  Scene() {
    for (std::size_t i = 0; i < distance.count(); ++i) distance.data()[i] += 0.5F;
    const std::vector<glm::dvec3> normals = ordinateDirections(50);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const auto part = static_cast<float>(i) / static_cast<float>(normals.size());
      points.push_back({glm::vec3(32 * part, 20 * (1 - part), 13 + 10 * part), normals[i]});
    }
  }
};

// V of one ordinate by plain loops, in double.
Grid<float> plainTransport(GridView<const float> distance, glm::dvec3 light, const TransportOptions& options) {
  const glm::ivec3 n = distance.size, away(light.x < 0 ? 1 : -1, light.y < 0 ? 1 : -1, light.z < 0 ? 1 : -1);
  const UpwindWeights weights = upwindWeights(options.scheme, light, distance.spacing);
  const double smallest = smallestSpacing(distance.spacing);
  Grid<float> visibility(n);
  for (int k = 0; k < n.z; ++k)
    for (int j = 0; j < n.y; ++j)
      for (int i = 0; i < n.x; ++i) {
        const glm::ivec3 order(i, j, k), p = (1 - away) / 2 * (n - 1) + away * order;
        double sum = 0;
        for (int mask = 1; mask < 8; ++mask) {
          const glm::ivec3 back(mask & 1, mask >> 1 & 1, mask >> 2), q = p - away * back;
          double leaving = 1;
          if (order.x >= back.x && order.y >= back.y && order.z >= back.z)
            leaving = visibility.view()(q.x, q.y, q.z) *
                      std::pow(rampOf(options.transmittance, static_cast<float>(distance(q.x, q.y, q.z) / smallest)),
                               powerOf(options.transmittance, light));
          sum += weights[static_cast<std::size_t>(mask) - 1] * leaving;
        }
        visibility.view()(p.x, p.y, p.z) = static_cast<float>(sum);
      }
  return visibility;
}

TEST(Transport, IsThatOfPlainLoops) {
  // Openness at points anywhere in noise is the mean by clamped cosines of what plain loops give for each ordinate,
  // read between the samples; 1e-5 for the roundings of a ray of eighty steps.
  const Scene scene;
  const GridView<const float> distance = scene.distance.view();
  for (const TransportScheme scheme : kSchemes)
    for (const Transmittance transmittance : kTransmittances) {
      const TransportOptions options{
          .ordinates = 20, .scheme = scheme, .transmittance = transmittance, .offsetVoxels = 0.7};
      std::vector<double> open(scene.points.size()), all(scene.points.size());
      for (const glm::dvec3& light : ordinateDirections(options.ordinates)) {
        const Grid<float> visibility = plainTransport(distance, light, options);
        for (std::size_t i = 0; i < scene.points.size(); ++i) {
          const glm::dvec3 normal = scene.points[i].normal;
          const double cosine = std::max(0.0, glm::dot(normal, light));
          const glm::dvec3 above = glm::dvec3(scene.points[i].position) + options.offsetVoxels * normal;
          open[i] += cosine * test::trilinear(visibility.view(), above);
          all[i] += cosine;
        }
      }
      const std::vector<float> got = transportOpenness(distance, scene.points, options);
      for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], open[i] / all[i], 1e-5);
    }
}

TEST(Transport, ThreadsAndInstructionSetsDoNotChangeABit) {
  // Every scheme and transmittance gives the same bits on every SIMD target and for one, two and seven threads.
  const Scene scene;
  for (const TransportScheme scheme : kSchemes)
    for (const Transmittance transmittance : kTransmittances) {
      const TransportOptions options{.ordinates = 50, .scheme = scheme, .transmittance = transmittance};
      const std::vector<float> want = transportOpenness(scene.distance.view(), scene.points, options);
      test::onEverySimdTarget(
          [&] { EXPECT_EQ(transportOpenness(scene.distance.view(), scene.points, options), want); });
      for (const int threads : {1, 2, 7}) {
        setThreadCount(threads);
        EXPECT_EQ(transportOpenness(scene.distance.view(), scene.points, options), want);
      }
      setThreadCount(0);
      EXPECT_LT(*std::min_element(want.begin(), want.end()), 0.5);
    }
}

TEST(Transport, MirroredScenesHaveTheSameOpenness) {
  // The four points around the axis of a symmetric scene see the same up to what the set of ordinates, which has no
  // symmetry, differs by: a floor with a ball on it, 300 ordinates.
  const auto distance = test::sampleLevel({41, 41, 41}, glm::dvec3(1), [](glm::dvec3 p) {
    return std::min(p.z - 10.3, glm::length(p - glm::dvec3(20, 20, 18)) - 7);
  });
  std::vector<OpenPoint> points;
  for (const glm::vec2 side : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)})
    points.push_back({glm::vec3(20.0F + 9.0F * side.x, 20.0F + 9.0F * side.y, 10.3F), {0, 0, 1}});
  const std::vector<float> openness = transportOpenness(distance.view(), points, {.ordinates = 300});
  const auto [least, most] = std::minmax_element(openness.begin(), openness.end());
  EXPECT_LT(*most - *least, 0.03);
  EXPECT_GT(*least, 0.5);
  EXPECT_LT(*most, 0.95);
}

}  // namespace
}  // namespace isolume
