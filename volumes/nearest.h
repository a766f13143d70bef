// The distance to the nearest of many primitives, bit for bit what trying all of them gives.
//
// The unit cube is cut into (2^depth)^3 cells. Distances change by at most |p - q| between two points p and q, so
// within a cell whose corners lie R from its centre no primitive counts that is farther from the centre than the
// nearest one plus 2 R. Each cell lists the others from near to far, and a search ends where even the triangle
// inequality leaves no hope. Built from coarse to fine, so that each cell tries only what its parent kept. Points
// outside the cube try all primitives. Immutable once built: thread-safe.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "primitives.h"

namespace isolume {

template <class Primitive>
double nearestOfAll(const std::vector<Primitive>& primitives, glm::dvec3 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Primitive& primitive : primitives) nearest = std::min(nearest, distanceTo(primitive, p));
  return nearest;
}

template <class Primitive>
class NearestPrimitive {
 public:
  explicit NearestPrimitive(std::vector<Primitive> primitives, int depth)
      : primitives_(std::move(primitives)), cells_(1 << depth), lists_(std::size_t{1} << (3 * depth)) {
    std::vector<Candidate> all;
    for (std::size_t i = 0; i < primitives_.size(); ++i) all.push_back({0, static_cast<std::uint32_t>(i)});
    fill({0, 0, 0}, cells_, all);
  }

  double operator()(glm::dvec3 p) const {
    const bool inside = p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < 1 && p.y < 1 && p.z < 1;
    if (!inside) return nearestOfAll(primitives_, p);
    const glm::ivec3 cell(p * static_cast<double>(cells_));
    const double fromCenter = glm::length(p - center(cell, 1));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : lists_[listIndex(cell)]) {
      if (candidate.centerDistance - fromCenter > nearest + kSlack) break;
      nearest = std::min(nearest, distanceTo(primitives_[candidate.index], p));
    }
    return nearest;
  }

  const std::vector<Primitive>& primitives() const { return primitives_; }

 private:
  struct Candidate {
    double centerDistance;  // from the cell's centre
    std::uint32_t index;
  };
  static constexpr double kSlack = 1e-9;  // far above the rounding of any distance in the unit cube

  std::size_t listIndex(glm::ivec3 cell) const {
    return (static_cast<std::size_t>(cell.z) * cells_ + cell.y) * cells_ + cell.x;
  }
  glm::dvec3 center(glm::ivec3 cell, int extent) const {
    return (glm::dvec3(cell) + glm::dvec3(0.5 * extent)) / static_cast<double>(cells_);
  }

  // Cells [cell, cell + extent) along each axis.
  void fill(glm::ivec3 cell, int extent, std::vector<Candidate> candidates) {
    const glm::dvec3 c = center(cell, extent);
    double nearest = std::numeric_limits<double>::infinity();
    for (Candidate& candidate : candidates) {
      candidate.centerDistance = distanceTo(primitives_[candidate.index], c);
      nearest = std::min(nearest, candidate.centerDistance);
    }
    const double limit = nearest + std::sqrt(3.0) * extent / cells_ + kSlack;  // 2 R is the cell's diagonal
    std::erase_if(candidates, [limit](const Candidate& candidate) { return candidate.centerDistance > limit; });
    if (extent > 1) {
      const int half = extent / 2;
      for (int child = 0; child < 8; ++child)
        fill(cell + half * glm::ivec3(child & 1, child >> 1 & 1, child >> 2), half, candidates);
      return;
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& first, const Candidate& second) {
      return first.centerDistance < second.centerDistance;
    });
    candidates.shrink_to_fit();
    lists_[listIndex(cell)] = std::move(candidates);
  }

  std::vector<Primitive> primitives_;
  int cells_;
  std::vector<std::vector<Candidate>> lists_;
};

}  // namespace isolume
