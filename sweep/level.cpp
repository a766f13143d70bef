#include "level.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

#include "parallel.h"

namespace isolume {
namespace {

constexpr float kLargestFloat = std::numeric_limits<float>::max();
// Levels stay within a quarter of the range of float, so that differences of two of them are finite.
constexpr float kLargestLevel = kLargestFloat / 4;
// The level of a missing sample where no finite sample lies outside.
constexpr float kMissingLevel = -1;

struct FiniteRange {
  float min = kLargestFloat;
  float max = -kLargestFloat;
  std::size_t missing = 0;
};

FiniteRange finiteRange(const float* values, std::size_t count) {
  FiniteRange range;
  for (std::size_t i = 0; i < count; ++i) {
    const float value = values[i];
    const bool finite = std::abs(value) <= kLargestFloat;  // false for NaN
    range.min = finite && value < range.min ? value : range.min;
    range.max = finite && value > range.max ? value : range.max;
    range.missing += finite ? 0 : 1;
  }
  return range;
}

struct PlaneSummary {
  std::size_t inside = 0;
  glm::ivec2 min{std::numeric_limits<int>::max()};
  glm::ivec2 max{-1};
};

PlaneSummary summarisePlane(const float* plane, glm::ivec3 size) {
  PlaneSummary summary;
  for (int y = 0; y < size.y; ++y) {
    const float* row = plane + static_cast<std::ptrdiff_t>(y) * size.x;
    int inside = 0;
    for (int x = 0; x < size.x; ++x) inside += row[x] > 0 ? 1 : 0;
    if (inside == 0) continue;
    int first = 0;
    int last = size.x - 1;
    while (row[first] <= 0) ++first;
    while (row[last] <= 0) --last;
    summary.inside += static_cast<std::size_t>(inside);
    summary.min = glm::ivec2(std::min(summary.min.x, first), std::min(summary.min.y, y));
    summary.max = glm::ivec2(std::max(summary.max.x, last), y);
  }
  return summary;
}

}  // namespace

LevelSummary makeLevel(GridView<float> values, float isovalue, Inside inside) {
  const auto planeCount = static_cast<std::size_t>(values.size.z);
  const std::size_t perPlane = voxelCount({values.size.x, values.size.y, 1});

  std::vector<FiniteRange> ranges(planeCount);
  parallelFor(planeCount, [&](std::size_t z) { ranges[z] = finiteRange(values.data + z * perPlane, perPlane); });
  FiniteRange range;
  for (const FiniteRange& plane : ranges) {
    range.min = std::min(range.min, plane.min);
    range.max = std::max(range.max, plane.max);
    range.missing += plane.missing;
  }

  LevelSummary summary;
  summary.replacedCount = range.missing;
  if (range.min <= range.max) {
    summary.finiteMin = range.min;
    summary.finiteMax = range.max;
  }

  const float sign = inside == Inside::above ? 1.0F : -1.0F;
  const auto levelOf = [sign, isovalue](float value) {
    return std::clamp(sign * (value - isovalue), -kLargestLevel, kLargestLevel);
  };
  const float lowest = range.min <= range.max ? std::min(levelOf(range.min), levelOf(range.max)) : kMissingLevel;
  const float missing = lowest < 0 ? lowest : kMissingLevel;

  std::vector<PlaneSummary> planes(planeCount);
  parallelFor(planeCount, [&](std::size_t z) {
    float* plane = values.data + z * perPlane;
    for (std::size_t i = 0; i < perPlane; ++i) {
      const float value = plane[i];
      plane[i] = std::abs(value) <= kLargestFloat ? levelOf(value) : missing;
    }
    planes[z] = summarisePlane(plane, values.size);
  });

  PlaneSummary all;
  int firstPlane = values.size.z;
  int lastPlane = -1;
  for (int z = 0; z < values.size.z; ++z) {
    const PlaneSummary& plane = planes[static_cast<std::size_t>(z)];
    if (plane.inside == 0) continue;
    all.inside += plane.inside;
    all.min = glm::ivec2(std::min(all.min.x, plane.min.x), std::min(all.min.y, plane.min.y));
    all.max = glm::ivec2(std::max(all.max.x, plane.max.x), std::max(all.max.y, plane.max.y));
    firstPlane = std::min(firstPlane, z);
    lastPlane = z;
  }
  summary.insideCount = all.inside;
  if (all.inside > 0) {
    summary.solidMin = glm::ivec3(all.min, firstPlane);
    summary.solidMax = glm::ivec3(all.max, lastPlane);
  }
  return summary;
}

}  // namespace isolume
