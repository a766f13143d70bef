#include "tests/bench/report/closest_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>

namespace isolume::bench {
namespace {

/// Corner i of a box lies at its low end along axis a if bit a of i is 0.
constexpr int kCorners = 8;
glm::ivec3 cornerOffset(int corner) { return {corner & 1, (corner >> 1) & 1, (corner >> 2) & 1}; }

/// A box of the octree: 2^level cells wide, at `index` in units of its own width.
struct Box {
  double lower;  ///< of the distance to the surface inside it
  int level;
  glm::i64vec3 index;
};
struct Farther {
  bool operator()(const Box& a, const Box& b) const { return a.lower > b.lower; }
};

using Corners = std::array<double, kCorners>;

bool mixed(const Corners& values) {
  const auto inside = std::count_if(values.begin(), values.end(), [](double v) { return v > 0; });
  return inside != 0 && inside != kCorners;
}

/// Distance from q to an axis-aligned box; both scaled.
double distanceToBox(glm::dvec3 q, glm::dvec3 low, glm::dvec3 high) {
  return glm::length(glm::max(glm::max(low - q, q - high), glm::dvec3(0)));
}

/// Nearest of the crossings on the box's twelve edges.
double nearestCrossing(const Corners& values, glm::dvec3 q, glm::dvec3 low, glm::dvec3 width) {
  double best = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < kCorners; ++corner)
    for (int axis = 0; axis < 3; ++axis) {
      if (corner & (1 << axis)) continue;
      const double a = values[corner], b = values[corner | (1 << axis)];
      if ((a > 0) == (b > 0)) continue;
      glm::dvec3 at = low + glm::dvec3(cornerOffset(corner)) * width;
      at[axis] += width[axis] * a / (a - b);
      best = std::min(best, glm::length(at - q));
    }
  return best;
}

/// Lower bound of the distance from q to the surface in the box, from the interpolant's linear part at the centre.
double distanceToSlab(const Corners& values, glm::dvec3 q, glm::dvec3 low, glm::dvec3 width) {
  // In coordinates that are +-1 at the corners: value = c + g.u + terms in xy, xz, yz, xyz, each at most its
  // coefficient.
  const auto coefficient = [&values](int axes) {
    double sum = 0;
    for (int corner = 0; corner < kCorners; ++corner)
      sum += __builtin_parity(~corner & axes) ? -values[corner] : values[corner];
    return sum / kCorners;
  };
  constexpr int kX = 1, kY = 2, kZ = 4;
  const glm::dvec3 half = width / 2.0;
  const glm::dvec3 gradient = glm::dvec3(coefficient(kX), coefficient(kY), coefficient(kZ)) / half;
  const double steepness = glm::length(gradient);
  if (!(steepness > 0)) return 0;
  double rest = 0;
  for (const int axes : {kX | kY, kX | kZ, kY | kZ, kX | kY | kZ}) rest += std::abs(coefficient(axes));
  return (std::abs(coefficient(0) + glm::dot(gradient, q - (low + half))) - rest) / steepness;
}

/// Values at the corners of a box that is one cell or smaller.
Corners cornerValues(GridView<const float> level, const Box& box) {
  const int halvings = -box.level;
  const glm::ivec3 cell(box.index >> glm::i64vec3(halvings));
  const double width = std::ldexp(1.0, box.level);
  const glm::dvec3 low = glm::dvec3(box.index) * width - glm::dvec3(cell);
  Corners samples{}, values{};
  for (int corner = 0; corner < kCorners; ++corner) {
    const glm::ivec3 at = cell + cornerOffset(corner);
    samples[corner] = level(at.x, at.y, at.z);
  }
  if (halvings == 0) return samples;
  for (int corner = 0; corner < kCorners; ++corner) {
    const glm::dvec3 t = low + glm::dvec3(cornerOffset(corner)) * width;
    const auto mix = [](double a, double b, double u) { return a * (1 - u) + b * u; };
    const double y0 = mix(mix(samples[0], samples[1], t.x), mix(samples[2], samples[3], t.x), t.y);
    const double y1 = mix(mix(samples[4], samples[5], t.x), mix(samples[6], samples[7], t.x), t.y);
    values[corner] = mix(y0, y1, t.z);
  }
  return values;
}

}  // namespace

ClosestDistance::ClosestDistance(GridView<const float> level) : level_(level) {
  spacing_ = level.spacing / smallestSpacing(level.spacing);
  Blocks cells;
  cells.size = level.size - 1;
  cells.mixed.reserve(voxelCount(cells.size));
  for (int z = 0; z < cells.size.z; ++z)
    for (int y = 0; y < cells.size.y; ++y)
      for (int x = 0; x < cells.size.x; ++x) {
        int inside = 0;
        for (int corner = 0; corner < kCorners; ++corner) {
          const glm::ivec3 at = glm::ivec3(x, y, z) + cornerOffset(corner);
          inside += level(at.x, at.y, at.z) > 0 ? 1 : 0;
        }
        cells.mixed.push_back(inside != 0 && inside != kCorners);
      }
  blocks_.push_back(std::move(cells));
  while (blocks_.back().mixed.size() > 1) {
    const Blocks& fine = blocks_.back();
    Blocks coarse;
    coarse.size = (fine.size + 1) / 2;
    coarse.mixed.reserve(voxelCount(coarse.size));
    for (int z = 0; z < coarse.size.z; ++z)
      for (int y = 0; y < coarse.size.y; ++y)
        for (int x = 0; x < coarse.size.x; ++x) {
          bool any = false;
          for (int corner = 0; corner < kCorners; ++corner) {
            const glm::ivec3 child = 2 * glm::ivec3(x, y, z) + cornerOffset(corner);
            const bool exists = child.x < fine.size.x && child.y < fine.size.y && child.z < fine.size.z;
            any = any || (exists && fine.at(child));
          }
          coarse.mixed.push_back(any);
        }
    blocks_.push_back(std::move(coarse));
  }
}

double ClosestDistance::operator()(glm::dvec3 position, double tolerance) const {
  const glm::dvec3 q = position * spacing_;
  double best = std::numeric_limits<double>::infinity();
  std::priority_queue<Box, std::vector<Box>, Farther> queue;

  const auto consider = [&](int level, glm::i64vec3 index) {
    const glm::dvec3 width = spacing_ * std::ldexp(1.0, level);
    const glm::dvec3 low = glm::dvec3(index) * width;
    Box box{distanceToBox(q, low, low + width), level, index};
    if (box.lower >= best - tolerance) return;
    if (level > 0) {
      if (blocks_[level].at(glm::ivec3(index))) queue.push(box);
      return;
    }
    const Corners values = cornerValues(level_, box);
    if (!mixed(values)) return;
    best = std::min(best, nearestCrossing(values, q, low, width));
    box.lower = std::max(box.lower, distanceToSlab(values, q, low, width));
    if (box.lower < best - tolerance) queue.push(box);
  };

  consider(static_cast<int>(blocks_.size()) - 1, glm::i64vec3(0));
  while (!queue.empty()) {
    const Box box = queue.top();
    queue.pop();
    if (box.lower >= best - tolerance) break;
    for (int corner = 0; corner < kCorners; ++corner) {
      const glm::i64vec3 child = box.index * std::int64_t{2} + glm::i64vec3(cornerOffset(corner));
      if (box.level > 0) {
        const glm::ivec3 size = blocks_[box.level - 1].size;
        if (child.x >= size.x || child.y >= size.y || child.z >= size.z) continue;
      }
      consider(box.level - 1, child);
    }
  }
  return best;
}

std::vector<glm::ivec3> ClosestDistance::mixedCells() const {
  const Blocks& cells = blocks_.front();
  std::vector<glm::ivec3> found;
  for (int z = 0; z < cells.size.z; ++z)
    for (int y = 0; y < cells.size.y; ++y)
      for (int x = 0; x < cells.size.x; ++x)
        if (cells.at({x, y, z})) found.emplace_back(x, y, z);
  return found;
}

}  // namespace isolume::bench
