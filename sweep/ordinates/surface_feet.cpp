#include "surface_feet.h"

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "sweep/near_sets.h"
#include "sweep/parallel.h"

namespace isolume {

SurfaceFeet::SurfaceFeet(GridView<const float> level, GridView<const float> distance)
    : fields_{level, distance},
      solid_(insideSamples(level)),
      caps_(solid_),
      hasFoot_(level.size),
      filled_(level.size),
      firstFoot_(voxelCount({1, level.size.y, level.size.z})) {
  forEachLayer([&](int z) {
    for (int y = 0; y < level.size.y; ++y) markRow(y, z);
  });
  std::uint32_t count = 0;
  for (std::uint32_t& first : firstFoot_) {
    const std::uint32_t own = first;
    first = count;
    count += own;
  }
  feet_.resize(count + caps_.count());
  forEachLayer([&](int z) {
    std::vector<std::int32_t> x;
    std::vector<SurfaceFoot> feet;
    for (int y = 0; y < level.size.y; ++y) {
      x.clear();
      forEachFoot(y, z, [&](std::size_t, glm::ivec3 at) { x.push_back(at.x); });
      footRow(fields_, y, z, x, feet);
      std::copy(feet.begin(), feet.end(), feet_.begin() + firstFoot_[rowIndex(y, z)]);
    }
  });
  caps_.write(solid_, feet_.data() + count);
}

template <class Visit>
void SurfaceFeet::forEachLayer(const Visit& visit) const {
  parallelFor(static_cast<std::size_t>(solid_.size().z), [&](std::size_t layer) { visit(static_cast<int>(layer)); });
}

// Marks the samples of a row, and counts its feet.
void SurfaceFeet::markRow(int y, int z) {
  const auto words = static_cast<std::size_t>(solid_.words());
  BitRow near(words), crossed(words);
  cornerRow(solid_, y, z, near);
  crossedRow(solid_, y, z, crossed);
  int feet = 0;
  for (std::size_t w = 0; w < words; ++w) {
    const std::uint64_t solid = solid_.row(y, z)[w];
    hasFoot_.row(y, z)[w] = crossed[w] & ~solid;
    filled_.row(y, z)[w] = near[w] & ~hasFoot_.row(y, z)[w];
    feet += std::popcount(hasFoot_.row(y, z)[w]);
  }
  firstFoot_[rowIndex(y, z)] = static_cast<std::uint32_t>(feet);
}

// visit(sample) for those of the 26 around, and the sample itself, that are in the set.
template <class Visit>
void SurfaceFeet::forEachAround(glm::ivec3 at, const BitGrid& set, const Visit& visit) {
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 sample = at + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (set.test(sample.x, sample.y, sample.z)) visit(sample);
  }
}

// visit(number, sample) for each foot of a row.
template <class Visit>
void SurfaceFeet::forEachFoot(int y, int z, const Visit& visit) const {
  std::size_t foot = firstFoot_[rowIndex(y, z)];
  forEachBit(hasFoot_.row(y, z), hasFoot_.words(), [&](int x) { visit(foot++, glm::ivec3(x, y, z)); });
}

std::uint32_t SurfaceFeet::footNumber(glm::ivec3 at) const {
  const std::uint64_t* row = hasFoot_.row(at.y, at.z);
  std::uint32_t number = firstFoot_[rowIndex(at.y, at.z)];
  for (int w = 0; w < at.x / kWordBits; ++w) number += static_cast<std::uint32_t>(std::popcount(row[w]));
  const std::uint64_t before = (std::uint64_t{1} << (at.x % kWordBits)) - 1;
  return number + static_cast<std::uint32_t>(std::popcount(row[at.x / kWordBits] & before));
}

// Of the samples among the 26 around that have a foot, the one closest to a place on the surface.
std::uint32_t SurfaceFeet::nearestFoot(glm::ivec3 at, glm::vec3 place) const {
  double least = std::numeric_limits<double>::infinity();
  glm::ivec3 best = at;
  forEachAround(at, hasFoot_, [&](glm::ivec3 sample) {
    const glm::dvec3 between = (glm::dvec3(sample) - glm::dvec3(place)) * fields_.level.spacing;
    const double distance = glm::dot(between, between);
    if (distance < least) {
      least = distance;
      best = sample;
    }
  });
  return footNumber(best);
}

std::vector<NearSample> SurfaceFeet::nearSamples(bool inside) const {
  const glm::ivec3 size = solid_.size();
  std::vector<std::vector<NearSample>> layers(static_cast<std::size_t>(size.z));
  forEachLayer([&](int z) {
    std::vector<NearSample>& samples = layers[static_cast<std::size_t>(z)];
    BitRow near(static_cast<std::size_t>(solid_.words()));
    std::vector<std::int32_t> x;
    std::vector<SurfaceFoot> feet;
    for (int y = 0; y < size.y; ++y) {
      cornerRow(solid_, y, z, near);
      x.clear();
      forEachBit(near.data(), solid_.words(), [&](int each) {
        if (isSolid({each, y, z}) == inside) x.push_back(each);
      });
      footRow(fields_, y, z, x, feet);
      for (std::size_t i = 0; i < x.size(); ++i) {
        const glm::ivec3 at(x[i], y, z);
        const bool own = !inside && hasFoot_.test(at.x, y, z);
        samples.push_back({at, own ? footNumber(at) : nearestFoot(at, feet[i].position)});
      }
    }
  });
  std::vector<NearSample> samples;
  for (const std::vector<NearSample>& each : layers) samples.insert(samples.end(), each.begin(), each.end());
  return samples;
}

void SurfaceFeet::fillUnknown(std::vector<std::uint16_t>& values, const std::vector<std::uint8_t>& known) const {
  forEachLayer([&](int z) {
    for (int y = 0; y < solid_.size().y; ++y)
      forEachFoot(y, z, [&](std::size_t foot, glm::ivec3 at) {
        if (known[foot] != 0) return;
        unsigned sum = 0, count = 0;
        forEachAround(at, hasFoot_, [&](glm::ivec3 sample) {
          const std::uint32_t other = footNumber(sample);
          if (known[other] == 0) return;
          sum += values[other];
          ++count;
        });
        if (count > 0) values[foot] = static_cast<std::uint16_t>((sum + count / 2) / count);
      });
  });
}

// The feet that are known.
BitGrid SurfaceFeet::given(const std::vector<std::uint8_t>& known) const {
  BitGrid given(solid_.size());
  forEachLayer([&](int z) {
    for (int y = 0; y < solid_.size().y; ++y)
      forEachFoot(y, z, [&](std::size_t foot, glm::ivec3 at) {
        if (known[foot] != 0) given.mark(at.x, y, z);
      });
  });
  return given;
}

// At a rim or a thin wall the gradient may lead into a cell without any: the mean of those of the 26 around that are
// given, or 0.
std::uint16_t SurfaceFeet::meanAround(glm::ivec3 at, const BitGrid& given, const SurfaceField& field) const {
  unsigned sum = 0, count = 0;
  forEachAround(at, given, [&](glm::ivec3 sample) {
    sum += field.wall(sample);
    ++count;
  });
  return count == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>((sum + count / 2) / count);
}

void SurfaceFeet::fillLayer(int z, const BitGrid& given, const SurfaceField& field,
                            std::vector<std::uint16_t>& filled) const {
  const glm::ivec3 size = solid_.size();
  const bool cells = size.x > 1 && size.y > 1 && size.z > 1;
  std::vector<std::int32_t> x, row;
  for (int y = 0; y < size.y; ++y) {
    x.clear();
    forEachBit(filled_.row(y, z), filled_.words(), [&](int each) { x.push_back(each); });
    row.assign(x.size(), kNoValue);
    if (cells) interpolatedRow(fields_, y, z, x, given, field, row);
    for (std::size_t i = 0; i < x.size(); ++i)
      filled.push_back(row[i] == kNoValue ? meanAround({x[i], y, z}, given, field)
                                          : static_cast<std::uint16_t>(row[i]));
  }
}

SurfaceField SurfaceFeet::spread(const std::vector<std::uint16_t>& values,
                                 const std::vector<std::uint8_t>* known) const {
  const GridView<const float> level = fields_.level;
  SurfaceField field(level.size, level.spacing, level.origin);
  forEachLayer([&](int z) {
    for (int y = 0; y < solid_.size().y; ++y)
      forEachFoot(y, z, [&](std::size_t foot, glm::ivec3 at) { field.wall(at) = values[foot]; });
  });
  std::optional<BitGrid> some;
  if (known) some = given(*known);
  // Apart from the values, which other threads read.
  std::vector<std::vector<std::uint16_t>> filled(static_cast<std::size_t>(solid_.size().z));
  forEachLayer([&](int z) { fillLayer(z, some ? *some : hasFoot_, field, filled[static_cast<std::size_t>(z)]); });
  forEachLayer([&](int z) {
    auto next = filled[static_cast<std::size_t>(z)].begin();
    for (int y = 0; y < solid_.size().y; ++y)
      forEachBit(filled_.row(y, z), filled_.words(), [&](int x) { field.wall({x, y, z}) = *next++; });
  });
  caps_.spread(solid_, values.data() + (feet_.size() - caps_.count()), field);
  return field;
}

}  // namespace isolume
