// Sets of samples: evenly spread, the same every time, and as good as [Loos10] says.
#include "raymarch/screen/point_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "raymarch/screen/repulsion_sets.h"
#include "raymarch/screen/screen_plan.h"

namespace isolume {
namespace {

template <class Point>
double leastDistance(const std::vector<Point>& points) {
  double least = 2;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, glm::distance(points[i], points[j]));
  return least;
}

TEST(PointSets, RadiiCutEqualParts) {
  // The radii of a set are those of the middles of n rings of equal area, or shells of equal volume, each taken once.
  for (const int count : {1, 5, 12, 64}) {
    std::vector<double> areas, volumes;
    for (const glm::dvec2& p : poissonDisk(count)) areas.push_back(std::pow(glm::length(p), 2));
    for (const glm::dvec3& p : poissonBall(count)) volumes.push_back(std::pow(glm::length(p), 3));
    std::sort(areas.begin(), areas.end());
    std::sort(volumes.begin(), volumes.end());
    for (int i = 0; i < count; ++i) {
      EXPECT_NEAR(areas[static_cast<std::size_t>(i)], (i + 0.5) / count, 1e-12);
      EXPECT_NEAR(volumes[static_cast<std::size_t>(i)], (i + 0.5) / count, 1e-12);
    }
  }
}

TEST(PointSets, PointsKeepApart) {
  // n points of a disk are at least two fifths as far from each other as those of the closest packing of circles
  // would be, sqrt(2 pi / (sqrt(3) n)); random ones come as near as 1 / n.
  for (const int count : {12, 33, 64})
    EXPECT_GT(leastDistance(poissonDisk(count)), 0.4 * std::sqrt(2 * M_PI / (std::sqrt(3.0) * count))) << count;
}

TEST(PointSets, StrataAreAPermutation) {
  // Each stratum holds one number, and their order is neither that of the strata nor its reverse.
  const std::vector<double> strata = shuffledStrata(64);
  std::vector<double> sorted = strata;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], (static_cast<double>(i) + 0.5) / 64);
  EXPECT_FALSE(std::is_sorted(strata.begin(), strata.end()));
  EXPECT_FALSE(std::is_sorted(strata.rbegin(), strata.rend()));
}

TEST(RepulsionSets, RegionsShareTheBall) {
  // The weights of a set sum to 1 and are equal to a few percent, far better than those of points that are only kept
  // apart; every point lies inside; the same count gives the same set.
  for (const int count : {5, 7, 9, 12, 13, 16}) {
    const std::vector<WeighedPoint>& disk = repulsionDisk(count);
    ASSERT_EQ(disk.size(), static_cast<std::size_t>(count));
    double sum = 0;
    for (const WeighedPoint& each : disk) {
      sum += each.weight;
      EXPECT_LT(glm::length(each.point), 1);
      EXPECT_EQ(each.point.z, 0);
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_EQ(&disk, &repulsionDisk(count));
  }
  for (const int count : {6, 12, 33}) {
    const std::vector<WeighedPoint>& ball = repulsionBall(count);
    EXPECT_NEAR(std::accumulate(ball.begin(), ball.end(), 0.0, [](double s, const auto& p) { return s + p.weight; }), 1,
                1e-12);
    EXPECT_LT(weightSpread(ball), 0.03) << count;
  }
}

TEST(RepulsionSets, CentreIsAPointWhereThatIsBetter) {
  // 5, 7, 9, 13 and 16 points of the disk have the centre among them, 12 do not.
  const auto nearest = [](int count) {
    double least = 1;
    for (const WeighedPoint& each : repulsionDisk(count)) least = std::min(least, glm::length(each.point));
    return least;
  };
  for (const int count : {5, 7, 9, 13, 16}) EXPECT_EQ(nearest(count), 0) << count;
  EXPECT_GT(nearest(12), 0.05);
}

TEST(ScreenPlan, MarchesTakeAboutTheirSamples) {
  // Directions times steps (times two sides) are at most the samples asked for, and more than half of them.
  for (const int samples : {4, 8, 12, 16, 32, 64, 256}) {
    const glm::ivec2 hbao = marchCounts(ScreenEstimator::hbao, samples);
    const glm::ivec2 gtao = marchCounts(ScreenEstimator::gtao, samples);
    EXPECT_LE(hbao.x * hbao.y, samples);
    EXPECT_GT(2 * hbao.x * hbao.y, samples);
    EXPECT_LE(2 * gtao.x * gtao.y, samples);
    EXPECT_GT(4 * gtao.x * gtao.y, samples);
  }
}

TEST(ScreenPlan, ExactWeightsAreThoseOfThePaper) {
  // Volumetric ambient occlusion with the exact normalisation weighs each pipe 3 / (2 n) ([Szirmay10] Eq. 7); the
  // points of gpu-hemisphere with mu = r^3 weigh 2 cos / n, since (2/3) mu' / r^2 = 2.
  ScreenOcclusion settings{.samples = 10, .normalisedBySamples = false};
  for (const glm::vec4& each : diskSamples(settings)) EXPECT_FLOAT_EQ(each.w, 0.15f);
  settings.estimator = ScreenEstimator::gpuHemisphere;
  for (const glm::vec4& each : pointSamples(settings))
    EXPECT_NEAR(each.w, 0.2f * each.z / glm::length(glm::vec3(each)), 1e-6);
}

TEST(ScreenPlan, InverseUndoesMembership) {
  // mu(inverse(x)) = x, and the slope is that of mu, for every function that has one.
  for (const Membership membership :
       {Membership::squareRoot, Membership::linear, Membership::volumetric, Membership::quartic}) {
    for (const double x : {0.1, 0.5, 0.9}) {
      EXPECT_NEAR(membershipAt(membership, membershipInverse(membership, x)), x, 1e-12);
      constexpr double kStep = 1e-5;
      const double slope = (membershipAt(membership, x + kStep) - membershipAt(membership, x - kStep)) / (2 * kStep);
      EXPECT_NEAR(membershipSlope(membership, x), slope, 1e-8);
    }
  }
  EXPECT_EQ(membershipInverse(Membership::classical, 0.3), 1);
}

}  // namespace
}  // namespace isolume
