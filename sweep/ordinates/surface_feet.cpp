#include "surface_feet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr int kBits = BitRows::kWordBits;
constexpr std::uint64_t kAll = ~std::uint64_t{0};

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

// The samples of word w of a row that there are.
std::uint64_t validBits(const BitRows& rows, int w) {
  const int left = rows.length - w * kBits;
  return left >= kBits ? kAll : ~(kAll << left);
}

// Samples of word w of a row with one of the other side among the 26 around.
std::uint64_t nextToSurface(const BitRows& solid, int y, int z, int w, int words) {
  std::uint64_t any = 0, all = kAll;
  // The bits just before and after the word; where there is none it counts as like its neighbour.
  std::uint64_t anyBefore = 0, allBefore = 1, anyAfter = 0, allAfter = 1;
  for (int nz = std::max(z - 1, 0); nz <= std::min(z + 1, solid.layers - 1); ++nz) {
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, solid.rows - 1); ++ny) {
      const std::uint64_t* row = solid.row(ny, nz);
      any |= row[w];
      all &= row[w];
      if (w > 0) {
        anyBefore |= row[w - 1] >> (kBits - 1);
        allBefore &= row[w - 1] >> (kBits - 1);
      }
      if (w + 1 < words) {
        anyAfter |= row[w + 1] & 1;
        allAfter &= row[w + 1] & 1;
      }
    }
  }
  if (any == 0 && anyBefore == 0 && anyAfter == 0) return 0;
  const std::uint64_t valid = validBits(solid, w);
  all |= ~valid;
  const std::uint64_t anyAround = any | any << 1 | anyBefore | any >> 1 | anyAfter << (kBits - 1);
  const std::uint64_t allAround = all & (all << 1 | allBefore) & (all >> 1 | allAfter << (kBits - 1));
  return anyAround & ~allAround & valid;
}

// Solid samples of word w of a row that lie on the border of the grid.
std::uint64_t capBits(const BitRows& solid, int y, int z, int w) {
  const std::uint64_t bits = solid.row(y, z)[w];
  if (y == 0 || z == 0 || y == solid.rows - 1 || z == solid.layers - 1) return bits;
  std::uint64_t ends = w == 0 ? 1 : 0;
  if (w == (solid.length - 1) / kBits) ends |= std::uint64_t{1} << ((solid.length - 1) % kBits);
  return bits & ends;
}

template <class Visit>
void forEachBitOf(std::uint64_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(std::countr_zero(bits));
}

}  // namespace

SurfaceFeet::SurfaceFeet(GridView<const float> level, GridView<const float> distance)
    : level_(level),
      distance_(distance),
      words_((level.size.x + kBits - 1) / kBits),
      solid_(signBits(level)),
      hasFoot_(level.size.x, level.size.y, level.size.z),
      inside_(level.size.x, level.size.y, level.size.z),
      firstFoot_(voxelCount({words_, level.size.y, level.size.z})) {
  const auto layers = static_cast<std::size_t>(level.size.z);
  parallelFor(layers, [&](std::size_t z) { markLayer(static_cast<int>(z)); });
  std::uint32_t count = 0;
  for (std::uint32_t& first : firstFoot_) {
    const std::uint32_t own = first;
    first = count;
    count += own;
  }
  feet_.resize(count);
  parallelFor(layers, [&](std::size_t z) {
    forEachFoot(static_cast<int>(z), [&](std::size_t foot, glm::ivec3 at) { feet_[foot] = footOf(at); });
  });
}

// Marks the samples of a layer, and counts the feet of each word.
void SurfaceFeet::markLayer(int z) {
  for (int y = 0; y < level_.size.y; ++y) {
    for (int w = 0; w < words_; ++w) {
      const std::uint64_t solid = solid_.row(y, z)[w], caps = capBits(solid_, y, z, w);
      const std::uint64_t near = nextToSurface(solid_, y, z, w, words_);
      hasFoot_.row(y, z)[w] = (near & ~solid) | caps;
      inside_.row(y, z)[w] = near & solid & ~caps;
      firstFoot_[wordIndex(w, y, z)] = static_cast<std::uint32_t>(std::popcount(hasFoot_.row(y, z)[w]));
    }
  }
}

// visit(number, sample) for each foot of a layer.
template <class Visit>
void SurfaceFeet::forEachFoot(int z, const Visit& visit) const {
  for (int y = 0; y < level_.size.y; ++y) {
    for (int w = 0; w < words_; ++w) {
      std::size_t foot = firstFoot_[wordIndex(w, y, z)];
      forEachBitOf(hasFoot_.row(y, z)[w], [&](int bit) { visit(foot++, glm::ivec3(w * kBits + bit, y, z)); });
    }
  }
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
    if ((hasFoot_.row(sample.y, sample.z)[sample.x / kBits] >> (sample.x % kBits) & 1) == 0) return;
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

void SurfaceFeet::spread(const std::vector<std::uint16_t>& openness, GridView<std::uint16_t> values) const {
  const auto layers = static_cast<std::size_t>(level_.size.z);
  parallelFor(layers, [&](std::size_t z) {
    std::fill_n(&values(0, 0, static_cast<int>(z)), values.strideZ(), std::uint16_t{0});
    forEachFoot(static_cast<int>(z),
                [&](std::size_t foot, glm::ivec3 at) { values(at.x, at.y, at.z) = openness[foot]; });
  });
  parallelFor(layers, [&](std::size_t layer) {
    const int z = static_cast<int>(layer);
    for (int y = 0; y < level_.size.y; ++y) {
      for (int w = 0; w < words_; ++w) {
        forEachBitOf(inside_.row(y, z)[w], [&](int bit) {
          const glm::ivec3 at(w * kBits + bit, y, z);
          values(at.x, at.y, at.z) = insideValue(at, values);
        });
      }
    }
  });
}

}  // namespace isolume
