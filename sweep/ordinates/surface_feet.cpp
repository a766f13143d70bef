#include "surface_feet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "sweep/near_sets.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// -level's gradient per world unit by central differences, one-sided at the border; finite for any finite level.
glm::dvec3 descent(GridView<const float> level, glm::ivec3 at) {
  const std::ptrdiff_t strides[3] = {1, level.strideY(), level.strideZ()};
  const float* here = level.data + level.index(at.x, at.y, at.z);
  glm::dvec3 gradient{0};
  for (int axis = 0; axis < 3; ++axis) {
    const int before = at[axis] > 0 ? 1 : 0, after = at[axis] + 1 < level.size[axis] ? 1 : 0;
    const double length = std::max(before + after, 1) * level.spacing[axis];
    gradient[axis] =
        (static_cast<double>(here[-before * strides[axis]]) - static_cast<double>(here[after * strides[axis]])) /
        length;
  }
  return gradient;
}

// 0 for 0.
glm::dvec3 unit(glm::dvec3 v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

// Out of the box at a sample on its border; along a diagonal at its edges and corners. Not of unit length; 0 where the
// box is one sample thin, with two faces that cancel out.
glm::dvec3 capNormal(glm::ivec3 at, glm::ivec3 size) {
  glm::dvec3 normal{0};
  for (int axis = 0; axis < 3; ++axis) {
    if (at[axis] == 0) normal[axis] -= 1;
    if (at[axis] == size[axis] - 1) normal[axis] += 1;
  }
  return normal;
}

}  // namespace

SurfaceFeet::SurfaceFeet(GridView<const float> level, GridView<const float> distance)
    : level_(level),
      distance_(distance),
      solid_(insideSamples(level)),
      hasFoot_(level.size),
      inside_(level.size),
      firstFoot_(voxelCount({1, level.size.y, level.size.z})) {
  const auto forEachRow = [&](const auto& visit) {
    parallelFor(static_cast<std::size_t>(level.size.z), [&](std::size_t z) {
      for (int y = 0; y < level.size.y; ++y) visit(y, static_cast<int>(z));
    });
  };
  forEachRow([&](int y, int z) { markRow(y, z); });
  std::uint32_t count = 0;
  for (std::uint32_t& first : firstFoot_) {
    const std::uint32_t own = first;
    first = count;
    count += own;
  }
  feet_.resize(count);
  forEachRow(
      [&](int y, int z) { forEachFoot(y, z, [&](std::size_t foot, glm::ivec3 at) { feet_[foot] = footOf(at); }); });
}

// Marks the samples of a row, and counts its feet.
void SurfaceFeet::markRow(int y, int z) {
  const auto words = static_cast<std::size_t>(solid_.words());
  BitRow near(words), caps(words);
  cornerRow(solid_, y, z, near);
  capRow(solid_, y, z, caps);
  int feet = 0;
  for (std::size_t w = 0; w < words; ++w) {
    const std::uint64_t solid = solid_.row(y, z)[w];
    hasFoot_.row(y, z)[w] = (near[w] & ~solid) | caps[w];
    inside_.row(y, z)[w] = near[w] & solid & ~caps[w];
    feet += std::popcount(hasFoot_.row(y, z)[w]);
  }
  firstFoot_[rowIndex(y, z)] = static_cast<std::uint32_t>(feet);
}

// visit(number, sample) for each foot of a row.
template <class Visit>
void SurfaceFeet::forEachFoot(int y, int z, const Visit& visit) const {
  std::size_t foot = firstFoot_[rowIndex(y, z)];
  forEachBit(hasFoot_.row(y, z), hasFoot_.words(), [&](int x) { visit(foot++, glm::ivec3(x, y, z)); });
}

// Unit, or 0 at a flat spot.
glm::dvec3 SurfaceFeet::normalAt(glm::ivec3 at) const { return unit(descent(level_, at)); }

glm::dvec3 SurfaceFeet::footPosition(glm::ivec3 at, glm::dvec3 normal) const {
  // The sample is next to the surface: farther than a cell's diagonal is a flaw of the distance.
  const double limit = glm::length(level_.spacing);
  const double d = std::clamp(static_cast<double>(distance_(at.x, at.y, at.z)), -limit, limit);
  return glm::clamp(glm::dvec3(at) - d * normal / level_.spacing, glm::dvec3(0), glm::dvec3(level_.size - 1));
}

SurfaceFoot SurfaceFeet::footOf(glm::ivec3 at) const {
  const bool cap = level_(at.x, at.y, at.z) > 0;
  if (cap) return {glm::vec3(at), glm::vec3(unit(capNormal(at, level_.size)))};
  const glm::dvec3 normal = normalAt(at);
  return {glm::vec3(footPosition(at, normal)), glm::vec3(normal)};
}

std::uint16_t SurfaceFeet::insideValue(glm::ivec3 at, GridView<const std::uint16_t> values) const {
  // Even an outside corner with no weight counts a little: there may be none but such.
  constexpr float kLeastWeight = 1e-3F;
  float sum = 0, weights = 0;
  const auto add = [&](glm::ivec3 sample, float weight) {
    if (!hasFoot_.test(sample.x, sample.y, sample.z)) return;
    sum += weight * static_cast<float>(values(sample.x, sample.y, sample.z));
    weights += weight;
  };
  const glm::vec3 position(footPosition(at, normalAt(at)));
  const glm::ivec3 low = glm::min(glm::ivec3(position), glm::max(level_.size - 2, glm::ivec3(0)));
  const glm::vec3 part = position - glm::vec3(low);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
    add(glm::min(low + side, level_.size - 1), kLeastWeight + (side.x != 0 ? part.x : 1 - part.x) *
                                                                  (side.y != 0 ? part.y : 1 - part.y) *
                                                                  (side.z != 0 ? part.z : 1 - part.z));
  }
  // At a rim or a thin wall the gradient may lead into a cell that is all inside. Of the 26 around, which there are
  // since it is no cap, some have a foot: it is next to the surface.
  if (weights == 0)
    for (int i = 0; i < 27; ++i) add(at + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1), 1);
  return static_cast<std::uint16_t>(std::lround(sum / weights));
}

std::uint32_t SurfaceFeet::footNumber(glm::ivec3 at) const {
  const std::uint64_t* row = hasFoot_.row(at.y, at.z);
  std::uint32_t number = firstFoot_[rowIndex(at.y, at.z)];
  for (int w = 0; w < at.x / kWordBits; ++w) number += static_cast<std::uint32_t>(std::popcount(row[w]));
  const std::uint64_t before = (std::uint64_t{1} << (at.x % kWordBits)) - 1;
  return number + static_cast<std::uint32_t>(std::popcount(row[at.x / kWordBits] & before));
}

// Of the 26 around an inside sample that have a foot outside, the one closest to the sample's own foot.
std::uint32_t SurfaceFeet::nearestFoot(glm::ivec3 at) const {
  const glm::dvec3 own = footPosition(at, normalAt(at));
  double least = std::numeric_limits<double>::infinity();
  glm::ivec3 best = at;
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 sample = at + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (!hasFoot_.test(sample.x, sample.y, sample.z) || solid_.test(sample.x, sample.y, sample.z)) continue;
    const glm::dvec3 between = (glm::dvec3(sample) - own) * level_.spacing;
    const double distance = glm::dot(between, between);
    if (distance < least) {
      least = distance;
      best = sample;
    }
  }
  return footNumber(best);
}

std::vector<NearSample> SurfaceFeet::nearSamples(bool inside) const {
  std::vector<std::vector<NearSample>> layers(static_cast<std::size_t>(level_.size.z));
  parallelFor(layers.size(), [&](std::size_t layer) {
    const int z = static_cast<int>(layer);
    BitRow near(static_cast<std::size_t>(solid_.words()));
    for (int y = 0; y < level_.size.y; ++y) {
      cornerRow(solid_, y, z, near);
      forEachBit(near.data(), solid_.words(), [&](int x) {
        const glm::ivec3 at(x, y, z);
        if (solid_.test(x, y, z) == inside) layers[layer].push_back({at, inside ? nearestFoot(at) : footNumber(at)});
      });
    }
  });
  std::vector<NearSample> samples;
  for (const std::vector<NearSample>& each : layers) samples.insert(samples.end(), each.begin(), each.end());
  return samples;
}

void SurfaceFeet::fillUnknown(std::vector<std::uint16_t>& values, const std::vector<std::uint8_t>& known) const {
  parallelFor(static_cast<std::size_t>(level_.size.z), [&](std::size_t layer) {
    const int z = static_cast<int>(layer);
    for (int y = 0; y < level_.size.y; ++y)
      forEachFoot(y, z, [&](std::size_t foot, glm::ivec3 at) {
        if (known[foot] != 0) return;
        unsigned sum = 0, count = 0;
        for (int i = 0; i < 27; ++i) {
          const glm::ivec3 sample = at + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
          if (!hasFoot_.test(sample.x, sample.y, sample.z)) continue;
          const std::uint32_t other = footNumber(sample);
          if (known[other] == 0) continue;
          sum += values[other];
          ++count;
        }
        if (count > 0) values[foot] = static_cast<std::uint16_t>((sum + count / 2) / count);
      });
  });
}

void SurfaceFeet::spread(const std::vector<std::uint16_t>& openness, GridView<std::uint16_t> values) const {
  const auto layers = static_cast<std::size_t>(level_.size.z);
  parallelFor(layers, [&](std::size_t layer) {
    const int z = static_cast<int>(layer);
    std::fill_n(&values(0, 0, z), values.strideZ(), std::uint16_t{0});
    for (int y = 0; y < level_.size.y; ++y)
      forEachFoot(y, z, [&](std::size_t foot, glm::ivec3 at) { values(at.x, at.y, at.z) = openness[foot]; });
  });
  parallelFor(layers, [&](std::size_t layer) {
    const int z = static_cast<int>(layer);
    for (int y = 0; y < level_.size.y; ++y)
      forEachBit(inside_.row(y, z), inside_.words(), [&](int x) { values(x, y, z) = insideValue({x, y, z}, values); });
  });
}

Grid<std::uint16_t> SurfaceFeet::spread(const std::vector<std::uint16_t>& openness) const {
  Grid<std::uint16_t> values(level_.size, level_.spacing, level_.origin);
  spread(openness, values.view());
  return values;
}

}  // namespace isolume
