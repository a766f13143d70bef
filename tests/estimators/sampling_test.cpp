// The points that estimates are made of, and the errors that they are told with.
#include <gtest/gtest.h>

#include <set>

#include "estimators/closed_form.h"
#include "sweep/reference/directions.h"
#include "sweep/reference/low_discrepancy.h"

namespace isolume::test {
namespace {

TEST(ScrambledSobol, StratifiesEveryElementaryRectangle) {
  // For any key and pair, of the first 2^k points one lies in each of the 2^k rectangles of every shape.
  for (const std::uint64_t key : {0U, 1U, 77U})
    for (const std::uint32_t pair : {0U, 1U, 5U})
      for (const int k : {2, 5, 8})
        for (int across = 0; across <= k; ++across) {
          std::set<std::pair<int, int>> filled;
          for (std::uint32_t i = 0; i < (1U << k); ++i) {
            const glm::dvec2 u = scrambledSobol(key, pair, i);
            filled.emplace(static_cast<int>(u.x * (1 << across)), static_cast<int>(u.y * (1 << (k - across))));
          }
          EXPECT_EQ(filled.size(), std::size_t{1} << k) << key << " " << pair << " " << k << " " << across;
        }
}

TEST(ScrambledSobol, KeysAndPairsAreIndependent) {
  // A single point is uniform over keys (mean 1/2 and mean square 1/3 of each coordinate), and does not tell the same
  // point of another pair or key (mean product 1/4): within 5 standard errors of 16384 draws.
  constexpr int kCount = 1 << 14;
  double mean = 0, square = 0, acrossPairs = 0, acrossKeys = 0, acrossAxes = 0;
  for (std::uint64_t key = 0; key < kCount; ++key) {
    const glm::dvec2 u = scrambledSobol(key, 0, 3);
    mean += u.x / kCount;
    square += u.y * u.y / kCount;
    acrossAxes += u.x * u.y / kCount;
    acrossPairs += u.x * scrambledSobol(key, 1, 3).x / kCount;
    acrossKeys += u.x * scrambledSobol(key + 1, 0, 3).x / kCount;
  }
  const double five = 5 / std::sqrt(static_cast<double>(kCount));
  EXPECT_NEAR(mean, 1 / 2.0, five * std::sqrt(1 / 12.0));
  EXPECT_NEAR(square, 1 / 3.0, five * std::sqrt(4 / 45.0));
  const double product = five * std::sqrt(7 / 144.0);  // of two independent uniform numbers
  EXPECT_NEAR(acrossAxes, 1 / 4.0, product);
  EXPECT_NEAR(acrossPairs, 1 / 4.0, product);
  EXPECT_NEAR(acrossKeys, 1 / 4.0, product);
}

TEST(Directions, FramesAreOrthonormal) {
  // Also about axes that look straight down, where other constructions divide by zero.
  for (const glm::dvec3 axis : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(1e-9, -1e-9, -1),
                                glm::dvec3(1, 2, -3), glm::dvec3(-1, 0, 0)}) {
    const glm::dmat3 frame = frameAbout(glm::normalize(axis));
    constexpr double kRounding = 1e-15;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(glm::dot(frame[i], frame[j]), i == j ? 1 : 0, kRounding);
    EXPECT_NEAR(glm::dot(glm::cross(frame[0], frame[1]), frame[2]), 1, kRounding);
  }
}

TEST(Directions, HaveTheDensityThatTheyClaim) {
  // Mean of z: 2/3 cosine-weighted, 1/2 uniform over the hemisphere, (1 + cos) / 2 over a cap; the midpoint sum of a
  // function as smooth as a square root is good to 1e-4 with 1024 steps.
  constexpr double kStep = 1e-4;
  EXPECT_NEAR(squareMean(1024, [](double u, double v) { return cosineDirection({u, v}).z; }), 2 / 3.0, kStep);
  EXPECT_NEAR(squareMean(1024, [](double u, double v) { return hemisphereDirection({u, v}).z; }), 0.5, kStep);
  constexpr double kCap = 0.2;
  EXPECT_NEAR(squareMean(1024, [](double u, double v) { return capDirection({u, v}, kCap).z; }), 1 - kCap / 2, kStep);
  EXPECT_NEAR(glm::length(capDirection({0.3, 0.7}, kCap)), 1, 1e-15);
}

/// A floor under a sphere: the openness of each of its points is known.
struct SphereScene {
  static constexpr double kRadius = 24, kFloor = 2;
  const glm::dvec3 centre{60, 60, 34};
  const TestScene scene{{121, 121, 60}, glm::dvec3(1), [this](glm::dvec3 p) {
                          return std::max(floorLevel(p, kFloor), kRadius - glm::length(p - centre));
                        }};
  double openness(glm::dvec3 point) const {
    const double distance = glm::length(centre - point);
    return 1 - kRadius * kRadius / (distance * distance) * (centre.z - point.z) / distance;
  }
};

/// Share of points whose estimate is within two standard errors, and RMS of the error over that of its estimate.
struct Honesty {
  double within = 0, ratio = 0;
  double rms = 0;  ///< of the error
};

Honesty honestyOf(const SphereScene& sphere, const SamplingSettings& sampling) {
  constexpr int kSide = 48;
  double within = 0, squares = 0, estimated = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec3 point(20 + 80.0 * (x + 0.5) / kSide, 20 + 80.0 * (y + 0.5) / kSide, SphereScene::kFloor);
      const PointEstimate got = estimateAt(sphere.scene.scene(), {}, sampling, pointOn(point),
                                           mixKey(static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y)));
      const double error = got.channels.value[0] - sphere.openness(point), told = got.channels.standardError[0];
      within += std::abs(error) <= 2 * told ? 1 : 0;
      squares += error * error;
      estimated += told * told;
    }
  return {within / (kSide * kSide), std::sqrt(squares / estimated), std::sqrt(squares) / kSide};
}

TEST(StandardError, IsHonest) {
  // Over 2304 points of known openness about 94 % (Student's t with 15 degrees of freedom: 93.6 %) are within two
  // standard errors, and the error's RMS is what is told, at few rays and at many. A share of 2304 scatters by half a
  // percent; the sphere's own discretisation (1 / (2 r^2) of at most .55: 5e-4) is small against the errors at hand.
  const SphereScene sphere;
  for (const int rays : {64, 256, 1024}) {
    const Honesty got = honestyOf(sphere, {.rays = rays});
    EXPECT_GT(got.within, 0.92) << rays;
    EXPECT_LT(got.within, 0.96) << rays;
    EXPECT_GT(got.ratio, 0.93) << rays;
    EXPECT_LT(got.ratio, 1.07) << rays;
  }
}

TEST(StandardError, KeepsItsPromiseWhenItDecidesWhereToStop) {
  // Stopping at a target favours points whose error is told too small, by a sixth or less in RMS; the margin that is
  // kept for it holds the RMS of the error itself below the target.
  const SphereScene sphere;
  for (const double target : {0.01, 0.005}) {
    const Honesty got = honestyOf(sphere, {.targetError = target});
    EXPECT_GT(got.within, 0.88) << target;
    EXPECT_LT(got.ratio, 1.2) << target;
    EXPECT_LT(got.rms, target);
    EXPECT_GT(got.rms, target / 3);  // not by taking ever more rays: a doubling overshoots by at most 2^.75
  }
}

TEST(StandardError, FallsFasterThanByChance) {
  // Sixteen times the rays of a stratified sequence leave less than a fifth of the error: the points are worth their
  // name.
  const SphereScene sphere;
  const glm::dvec3 point(70, 66, SphereScene::kFloor);
  const Openness few = openness(sphere.scene, pointOn(point), 1024);
  const Openness many = openness(sphere.scene, pointOn(point), 16384);
  EXPECT_LT(many.error, few.error / 5);  // by chance alone: a quarter
}

TEST(StandardError, OfAQuotientIsThatOfTheJackknife) {
  // For the mean itself the jackknife gives the replicates' s / sqrt(M); for its square, to first order, 2 |mean| as
  // much: an independent calculation on given numbers.
  std::array<Channels, kReplicates> sums{};
  double mean = 0, squares = 0;
  for (int j = 0; j < kReplicates; ++j) {
    const double value = 5 + 0.01 * ((j * 7) % kReplicates);
    sums[j] = {4 * value, 4 * value, 0, 0};
    mean += value / kReplicates;
    squares += value * value;
  }
  const double plain = std::sqrt((squares - kReplicates * mean * mean) / (kReplicates - 1) / kReplicates);
  const ChannelEstimate got = estimateOf(sums, 4, [](Channels m) { return Channels{m[0], m[1] * m[1], 0, 0}; });
  EXPECT_NEAR(got.value[0], mean, 1e-12);
  EXPECT_NEAR(got.standardError[0], plain, 1e-9);  // cancellation in the sums of squares above
  EXPECT_NEAR(got.standardError[1], 2 * mean * plain, 1e-3 * 2 * mean * plain);
}

}  // namespace
}  // namespace isolume::test
