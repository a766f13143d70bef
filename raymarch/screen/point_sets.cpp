#include "raymarch/screen/point_sets.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "sweep/mix_bits.h"

namespace isolume {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mixBits(seed)) {}
  std::uint64_t bits() { return mixBits(state_ += kSplitMixIncrement); }
  /// Uniform in [0, 1), 53 bits.
  double operator()() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

glm::dvec3 uniformPoint(Random& random, bool flat) {
  for (;;) {
    const double x = 2 * random() - 1, y = 2 * random() - 1, z = flat ? 0 : 2 * random() - 1;
    const glm::dvec3 p(x, y, z);
    if (glm::dot(p, p) < 1) return p;
  }
}

/// Moves the points to the radii between which the disk (the ball) falls into parts of equal size.
void equaliseRadii(std::vector<glm::dvec3>& points, double dimension) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return glm::dot(points[a], points[a]) < glm::dot(points[b], points[b]);
  });
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    glm::dvec3& point = points[order[rank]];
    const double share = (static_cast<double>(rank) + 0.5) / static_cast<double>(points.size());
    point *= std::pow(share, 1 / dimension) / glm::length(point);
  }
}

}  // namespace

std::vector<glm::dvec3> scatteredPoints(int count, bool flat, std::uint64_t seed) {
  constexpr int kTries = 200;      // per point, before the distance shrinks
  constexpr double kShrink = 0.9;  // loses at most a tenth of the distance that there is room for
  Random random(seed);
  std::vector<glm::dvec3> points;
  double distance = 2;
  while (points.size() < static_cast<std::size_t>(count)) {
    bool placed = false;
    for (int i = 0; i < kTries && !placed; ++i) {
      const glm::dvec3 point = uniformPoint(random, flat);
      placed = std::all_of(points.begin(), points.end(),
                           [&](const glm::dvec3& other) { return glm::distance(point, other) >= distance; });
      if (placed) points.push_back(point);
    }
    if (!placed) distance *= kShrink;
  }
  return points;
}

std::vector<glm::dvec2> poissonDisk(int count, std::uint64_t seed) {
  std::vector<glm::dvec3> points = scatteredPoints(count, true, seed);
  equaliseRadii(points, 2);
  return {points.begin(), points.end()};
}

std::vector<glm::dvec3> poissonBall(int count, std::uint64_t seed) {
  std::vector<glm::dvec3> points = scatteredPoints(count, false, seed);
  constexpr double kDimension = 3;
  equaliseRadii(points, kDimension);
  return points;
}

std::vector<glm::dvec2> randomDisk(int count, std::uint64_t seed) {
  constexpr std::uint64_t kOwn = 1;  // other numbers than those that place the points of the other sets
  Random random(mixBits(seed) + kOwn);
  std::vector<glm::dvec2> points;
  for (int i = 0; i < count; ++i) points.emplace_back(uniformPoint(random, true));
  return points;
}

std::vector<double> randomNumbers(int count, std::uint64_t seed) {
  constexpr std::uint64_t kOwn = 2;
  Random random(mixBits(seed) + kOwn);
  std::vector<double> numbers(static_cast<std::size_t>(count));
  for (double& each : numbers) each = random();
  return numbers;
}

std::vector<double> shuffledStrata(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> strata(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < strata.size(); ++i) strata[i] = (static_cast<double>(i) + 0.5) / count;
  for (std::size_t i = strata.size(); i > 1; --i) std::swap(strata[i - 1], strata[random.bits() % i]);
  return strata;
}

}  // namespace isolume
