#include "raymarch/screen/repulsion_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <mutex>

#include "raymarch/screen/point_sets.h"

namespace isolume {
namespace {

constexpr int kStarts = 6;
constexpr int kSteps = 80;
constexpr double kFirstStep = 0.1;   // radii, of the point that moves most
constexpr double kStepGrowth = 1.3;  // after a step that was taken; half after one that was not
constexpr double kLeastStep = 1e-3;  // nothing moves by as much as a cell any more
constexpr double kRim = 0.995;       // points keep off the rim, where lines have no length

struct Shape {
  bool flat;
  int movingCells, weighingCells;  // across the diameter
};
constexpr Shape kBall{false, 24, 64};
constexpr Shape kDisk{true, 96, 256};

struct Regions {
  std::vector<WeighedPoint> points;
  std::vector<glm::dvec3> centroids;
};

Regions regionsOf(const std::vector<glm::dvec3>& points, bool flat, int cells) {
  Regions regions;
  for (const glm::dvec3& point : points) regions.points.push_back({point, 0});
  regions.centroids.assign(points.size(), glm::dvec3(0));
  double total = 0;
  const auto centre = [cells](int i) { return (2 * i + 1.0) / cells - 1; };
  for (int k = 0; k < (flat ? 1 : cells); ++k) {
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i) {
        const glm::dvec3 cell(centre(i), centre(j), flat ? 0 : centre(k));
        const double left = 1 - glm::dot(cell, cell);
        if (left <= 0) continue;
        std::size_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t each = 0; each < points.size(); ++each) {
          const glm::dvec3 offset = points[each] - cell;
          const double square = glm::dot(offset, offset);
          if (square < least) {
            least = square;
            nearest = each;
          }
        }
        const double measure = flat ? std::sqrt(left) : 1;
        regions.points[nearest].weight += measure;
        regions.centroids[nearest] += measure * cell;
        total += measure;
      }
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    double& weight = regions.points[i].weight;
    regions.centroids[i] = weight > 0 ? regions.centroids[i] / weight : points[i];
    weight /= total;
  }
  return regions;
}

/// The step of each point, the longest of length 1 before the pull of the centroids.
std::vector<glm::dvec3> forces(const std::vector<glm::dvec3>& points, const std::vector<glm::dvec3>& centroids) {
  std::vector<glm::dvec3> sum(points.size(), glm::dvec3(0));
  double longest = std::numeric_limits<double>::min();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (i == j) continue;
      const glm::dvec3 apart = points[i] - points[j];
      const double square = glm::dot(apart, apart);
      sum[i] += apart / (std::sqrt(square) * square * square);  // 1 / d^4 along apart / d
    }
    longest = std::max(longest, glm::length(sum[i]));
  }
  // The pull weighs as much as the strongest repulsion where a centroid is a tenth of the radius away.
  constexpr double kPull = 10;
  for (std::size_t i = 0; i < points.size(); ++i) sum[i] = sum[i] / longest + kPull * (centroids[i] - points[i]);
  return sum;
}

glm::dvec3 withinRim(glm::dvec3 p) { return p * (kRim / std::max(glm::length(p), kRim)); }

Regions relax(std::vector<glm::dvec3> points, const Shape& shape, bool centred) {
  if (centred) points[0] = glm::dvec3(0);
  Regions best = regionsOf(points, shape.flat, shape.movingCells);
  double step = kFirstStep;
  for (int i = 0; i < kSteps && step > kLeastStep; ++i) {
    const std::vector<glm::dvec3> moves = forces(points, best.centroids);
    std::vector<glm::dvec3> moved = points;
    for (std::size_t each = centred ? 1 : 0; each < points.size(); ++each) {
      moved[each] = withinRim(moved[each] + step * moves[each]);
    }
    Regions next = regionsOf(moved, shape.flat, shape.movingCells);
    if (weightSpread(next.points) < weightSpread(best.points)) {
      best = std::move(next);
      points = std::move(moved);
      step *= kStepGrowth;
    } else {
      step /= 2;
    }
  }
  return best;
}

/// Moves one point after the other by a random step, and keeps what makes the regions more equal: what repulsion leaves
/// unequal, mostly between the rim and the inside, is evened out by little.
void polish(Regions& regions, const Shape& shape, bool centred) {
  constexpr int kMostRounds = 24;
  constexpr std::size_t kLargest = 33;  // set that takes all rounds; a round's time grows with the square of the points
  constexpr double kShrink = 0.85;      // of the step, per round
  double step = kFirstStep;
  const std::size_t count = regions.points.size();
  std::vector<glm::dvec3> points;
  for (const WeighedPoint& each : regions.points) points.push_back(each.point);
  const auto rounds =
      static_cast<int>(std::min<std::size_t>(kMostRounds, kMostRounds * kLargest * kLargest / (count * count)));
  for (int round = 0; round < rounds; ++round, step *= kShrink) {
    const std::vector<glm::dvec3> steps =
        scatteredPoints(static_cast<int>(count), shape.flat, static_cast<std::uint64_t>(kStarts + round));
    for (std::size_t each = centred ? 1 : 0; each < count; ++each) {
      std::vector<glm::dvec3> moved = points;
      moved[each] = withinRim(moved[each] + step * steps[each]);
      Regions next = regionsOf(moved, shape.flat, shape.movingCells);
      if (weightSpread(next.points) >= weightSpread(regions.points)) continue;
      regions = std::move(next);
      points = std::move(moved);
    }
  }
}

std::vector<WeighedPoint> makeSet(int count, const Shape& shape, bool centred) {
  Regions best;
  for (int start = 0; start < kStarts; ++start) {
    Regions relaxed = relax(scatteredPoints(count, shape.flat, static_cast<std::uint64_t>(start)), shape, centred);
    if (best.points.empty() || weightSpread(relaxed.points) < weightSpread(best.points)) best = std::move(relaxed);
  }
  polish(best, shape, centred);
  std::vector<glm::dvec3> points;
  for (const WeighedPoint& each : best.points) points.push_back(each.point);
  return regionsOf(points, shape.flat, shape.weighingCells).points;
}

/// References stay valid: a map's nodes do not move.
const std::vector<WeighedPoint>& cachedSet(int count, const Shape& shape, bool centred) {
  static std::mutex mutex;
  static std::map<std::pair<bool, int>, std::vector<WeighedPoint>> sets;
  const std::lock_guard lock(mutex);
  std::vector<WeighedPoint>& set = sets[{shape.flat, count}];
  if (set.empty()) set = makeSet(count, shape, centred);
  return set;
}

}  // namespace

double weightSpread(const std::vector<WeighedPoint>& points) {
  double sum = 0;
  for (const WeighedPoint& each : points) sum += std::pow(each.weight * static_cast<double>(points.size()) - 1, 2);
  return std::sqrt(sum / static_cast<double>(points.size()));
}

const std::vector<WeighedPoint>& repulsionBall(int count) { return cachedSet(count, kBall, false); }

const std::vector<WeighedPoint>& repulsionDisk(int count) {
  constexpr std::array<int, 6> kCentred{1, 5, 7, 9, 13, 16};
  return cachedSet(count, kDisk, std::find(kCentred.begin(), kCentred.end(), count) != kCentred.end());
}

}  // namespace isolume
