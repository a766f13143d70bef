#include "surface_field.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "sweep/parallel.h"
#include "sweep/trilinear.h"

namespace isolume {
namespace {

template <class Visit>
void forEachLayer(int layers, const Visit& visit) {
  parallelFor(static_cast<std::size_t>(layers), [&](std::size_t z) { visit(static_cast<int>(z)); });
}

// Central differences along the axes, one-sided at the border; world units. Halves, so that none overflows.
glm::dvec3 fallAt(GridView<const float> level, glm::ivec3 at) {
  glm::dvec3 fall{0};
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 before = at, after = at;
    before[axis] = std::max(at[axis] - 1, 0);
    after[axis] = std::min(at[axis] + 1, level.size[axis] - 1);
    const double difference = 0.5 * level(before.x, before.y, before.z) - 0.5 * level(after.x, after.y, after.z);
    fall[axis] = difference / (level.spacing[axis] * std::max(after[axis] - before[axis], 1));
  }
  return fall;
}

double agreement(glm::dvec3 fall, glm::dvec3 normal) {
  const double length = glm::length(fall);
  return length > 0 ? std::max(glm::dot(fall, normal) / length, kLeastAgreement) : kLeastAgreement;
}

double paddedTrilinear(const SurfaceField& field, glm::dvec3 position) {
  return trilinear(
      field.paddedSize(),
      [&](int x, int y, int z) {
        return field.padded({x, y, z});
      },
      position);
}

}  // namespace

SurfaceField::SurfaceField(glm::ivec3 size)
    : padded_(size + 2), count_(voxelCount(padded_)), numbers_(makeLargeArray<std::uint16_t>(count_)) {
  const std::size_t layer = voxelCount({padded_.x, padded_.y, 1});
  parallelFor(static_cast<std::size_t>(padded_.z),
              [&](std::size_t z) { std::fill_n(numbers_.get() + z * layer, layer, std::uint16_t{0}); });
}

SurfaceField::SurfaceField(RankedBits held)
    : padded_(held.size()),
      held_(std::move(held)),
      count_(held_->count()),
      numbers_(makeLargeArray<std::uint16_t>(count_)) {}

std::size_t SurfaceField::bytes() const { return count_ * sizeof(std::uint16_t) + (held_ ? held_->bytes() : 0); }

void SurfaceField::copyRow(int y, int z, std::uint16_t* to) const {
  const std::uint16_t* from = numbers_.get() + placeOf({0, y, z});
  if (!held_) {
    std::copy_n(from, padded_.x, to);
    return;
  }
  std::fill_n(to, padded_.x, std::uint16_t{0});
  forEachBit(held_->bits().row(y, z), held_->bits().words(), [&](int x) { to[x] = *from++; });
}

void SurfaceField::copyLayers(int begin, int end, std::uint16_t* to) const {
  const std::size_t row = static_cast<std::size_t>(padded_.x), layer = row * static_cast<std::size_t>(padded_.y);
  forEachLayer(end - begin, [&](int z) {
    for (int y = 0; y < padded_.y; ++y)
      copyRow(y, begin + z, to + static_cast<std::size_t>(z) * layer + static_cast<std::size_t>(y) * row);
  });
}

SurfaceField surfaceField(GridView<const std::uint16_t> samples) {
  SurfaceField field(samples.size);
  const glm::ivec3 padded = field.paddedSize();
  forEachLayer(padded.z, [&](int z) {
    const auto within = [](int i, int size) { return std::clamp(i - 1, 0, size - 1); };
    for (int y = 0; y < padded.y; ++y) {
      const std::uint16_t* from = &samples(0, within(y, samples.size.y), within(z, samples.size.z));
      std::uint16_t* to = field.numbers().data() + field.placeOf({0, y, z});
      to[0] = from[0];
      std::copy_n(from, samples.size.x, to + 1);
      to[padded.x - 1] = from[samples.size.x - 1];
    }
  });
  return field;
}

Grid<std::uint16_t> bySample(const SurfaceField& field, GridView<const float> level) {
  Grid<std::uint16_t> samples(level.size, level.spacing, level.origin);
  const GridView<std::uint16_t> to = samples.view();
  forEachLayer(level.size.z, [&](int z) {
    std::vector<std::uint16_t> row(static_cast<std::size_t>(field.paddedSize().x));
    for (int y = 0; y < level.size.y; ++y) {
      field.copyRow(y + 1, z + 1, row.data());
      std::copy_n(row.data() + 1, level.size.x, &to(0, y, z));
      const bool edge = y == 0 || z == 0 || y == level.size.y - 1 || z == level.size.z - 1;
      const int step = edge ? 1 : std::max(level.size.x - 1, 1);
      for (int x = 0; x < level.size.x; x += step) {
        if (!(level(x, y, z) > 0)) continue;
        unsigned sum = 0, count = 0;
        for (int i = 0; i < kFaceCount; ++i) {
          const GridFace face = faceOf(i);
          const glm::ivec3 at(x, y, z);
          if (at[face.axis] != placeOf(face, level.size)) continue;
          sum += field.cap(face, at);
          ++count;
        }
        to(x, y, z) = static_cast<std::uint16_t>((sum + count / 2) / count);
      }
    }
  });
  return samples;
}

double wallValueAt(const SurfaceField& field, GridView<const float> level, glm::dvec3 position, glm::dvec3 normal) {
  const glm::ivec3 low = glm::clamp(glm::ivec3(position), glm::ivec3(0), level.size - 2);
  const glm::dvec3 part = position - glm::dvec3(low);
  double sum = 0, weights = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2), at = low + side;
    const glm::dvec3 share = glm::mix(1.0 - part, part, glm::dvec3(side));
    const double weight = share.x * share.y * share.z * agreement(fallAt(level, at), normal);
    sum += weight * field.wall(at);
    weights += weight;
  }
  return sum / weights;
}

double capValueAt(const SurfaceField& field, GridFace face, glm::dvec3 position) {
  glm::dvec3 padded = position + 1.0;
  padded[face.axis] = placeOf(face, field.paddedSize());
  return paddedTrilinear(field, padded);
}

double surfaceValueAt(const SurfaceField& field, glm::dvec3 position) {
  for (int i = 0; i < kFaceCount; ++i) {
    const GridFace face = faceOf(i);
    if (position[face.axis] != placeOf(face, field.size())) continue;
    const double cap = capValueAt(field, face, position);
    if (cap > 0) return cap;
  }
  return paddedTrilinear(field, position + 1.0);
}

}  // namespace isolume
