#include "sweep/ordinates/ordinate_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/random_numbers.h"

namespace isolume {
namespace {

// Largest deviation of the sum of clamped cosines from count / 4 over 500 random normals.
double largestDeviation(int count) {
  const std::vector<glm::dvec3> directions = ordinateDirections(count);
  test::RandomNumbers numbers(1);
  double largest = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 normal = numbers.direction();
    double sum = 0;
    for (const glm::dvec3& w : directions) sum += std::max(glm::dot(normal, w), 0.0);
    largest = std::max(largest, std::abs(sum - count / 4.0));
  }
  return largest;
}

TEST(OrdinateSet, DirectionsAreUnitVectors) {
  // Every direction has length 1 to rounding, for any count from 1 on.
  for (const int count : {1, 2, 3, 8, 100, 4096}) {
    const std::vector<glm::dvec3> directions = ordinateDirections(count);
    ASSERT_EQ(directions.size(), static_cast<std::size_t>(count));
    for (const glm::dvec3& w : directions) ASSERT_NEAR(glm::length(w), 1, 1e-14);
  }
}

TEST(OrdinateSet, DirectionsAreSpreadOut) {
  // No two directions are closer than .85 of sqrt(4 pi / K), the width of a direction's share (measured: .871).
  for (const int count : {8, 32, 512, 2048}) {
    const std::vector<glm::dvec3> directions = ordinateDirections(count);
    double least = 2;
    for (std::size_t i = 0; i < directions.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) least = std::min(least, glm::distance(directions[i], directions[j]));
    EXPECT_GT(least, 0.85 * std::sqrt(4 * std::numbers::pi / count)) << count;
  }
}

TEST(OrdinateSet, ClampedCosinesAddUpToAQuarter) {
  // For 500 random normals the sum differs from K / 4 by less than .65 K^-1/4, a fraction of one direction that falls
  // as K grows: as a share of the sum, K^-5/4. Measured times K^1/4: .57, .45, .54, .56 for the four below.
  for (const int count : {32, 128, 512, 2048})
    EXPECT_LT(largestDeviation(count), 0.65 * std::pow(count, -0.25)) << count;
  // The exponent over 32 to 4096 is between -.2 and -.3 (measured: -.256); -1/2, which would make it K^-3/2, is not.
  const double exponent = std::log(largestDeviation(4096) / largestDeviation(32)) / std::log(4096.0 / 32);
  EXPECT_GT(exponent, -0.3);
  EXPECT_LT(exponent, -0.2);
}

}  // namespace
}  // namespace isolume
