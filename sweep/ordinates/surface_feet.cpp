#include "surface_feet.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "sweep/near_sets.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// Feet of a chunk, but for those of its last layer.
constexpr std::size_t kChunk = 1 << 14;

template <class Visit>
void forEachLayerOf(const BitGrid& grid, const Visit& visit) {
  parallelFor(static_cast<std::size_t>(grid.size().z), [&](std::size_t layer) { visit(static_cast<int>(layer)); });
}

// Samples outside with a solid one beside them along an axis.
RankedBits samplesWithFeet(const BitGrid& solid) {
  BitGrid outside(solid.size());
  const auto words = static_cast<std::size_t>(solid.words());
  forEachLayerOf(solid, [&](int z) {
    BitRow crossed(words);
    for (int y = 0; y < solid.size().y; ++y) {
      crossedRow(solid, y, z, crossed);
      for (std::size_t w = 0; w < words; ++w) outside.row(y, z)[w] = crossed[w] & ~solid.row(y, z)[w];
    }
  });
  return RankedBits(std::move(outside));
}

}  // namespace

SurfaceFeet::SurfaceFeet(GridView<const float> level, GridView<const float> distance)
    : fields_{level, distance}, solid_(insideSamples(level)), caps_(solid_), outside_(samplesWithFeet(solid_)) {}

template <class Visit>
void SurfaceFeet::forEachLayer(const Visit& visit) const {
  forEachLayerOf(solid_, visit);
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
  std::size_t foot = outside_.number({0, y, z});
  forEachBit(outside_.bits().row(y, z), outside_.bits().words(), [&](int x) { visit(foot++, glm::ivec3(x, y, z)); });
}

// Parts: the layers of the isosurface, then the rows of the caps.
std::size_t SurfaceFeet::partBegin(int part) const {
  const int layers = solid_.size().z;
  return part < layers ? outside_.number({0, 0, part}) : outside_.count() + caps_.rowBegin(part - layers);
}

void SurfaceFeet::addPart(int part, std::vector<SurfaceFoot>& feet) const {
  const int layers = solid_.size().z;
  if (part >= layers) {
    caps_.addRow(part - layers, feet);
    return;
  }
  std::vector<std::int32_t> x;
  for (int y = 0; y < solid_.size().y; ++y) {
    x.clear();
    forEachBit(outside_.bits().row(y, part), outside_.bits().words(), [&](int each) { x.push_back(each); });
    addFeet(fields_, y, part, x, feet);
  }
}

void FootChunks::copyFirst(std::size_t count, SurfaceFoot* to) const {
  parallelFor(count, [&](std::size_t chunk) {
    std::vector<SurfaceFoot> room;
    std::copy_n(feet(chunk, room), begin[chunk + 1] - begin[chunk], to + begin[chunk]);
  });
}

FootChunks SurfaceFeet::chunks() const {
  const int parts = solid_.size().z + caps_.rows();
  std::vector<int> first{0};  // part of each chunk
  FootChunks chunks;
  for (int part = 1; part < parts; ++part) {
    if (partBegin(part) < chunks.begin.back() + kChunk) continue;
    first.push_back(part);
    chunks.begin.push_back(partBegin(part));
  }
  first.push_back(parts);
  chunks.begin.push_back(count());
  chunks.feet = [this, first, begin = chunks.begin](std::size_t chunk, std::vector<SurfaceFoot>& room) {
    room.clear();
    room.reserve(begin[chunk + 1] - begin[chunk]);
    for (int part = first[chunk]; part < first[chunk + 1]; ++part) addPart(part, room);
    return room.data();
  };
  return chunks;
}

std::vector<SurfaceFoot> SurfaceFeet::makeFeet() const {
  std::vector<SurfaceFoot> feet(count());
  const FootChunks all = chunks();
  all.copyFirst(all.chunks(), feet.data());
  return feet;
}

// Of the samples among the 26 around that have a foot, the one closest to a place on the surface.
std::uint32_t SurfaceFeet::nearestFoot(glm::ivec3 at, glm::vec3 place) const {
  double least = std::numeric_limits<double>::infinity();
  glm::ivec3 best = at;
  forEachAround(at, outside_.bits(), [&](glm::ivec3 sample) {
    const glm::dvec3 between = (glm::dvec3(sample) - glm::dvec3(place)) * fields_.level.spacing;
    const double distance = glm::dot(between, between);
    if (distance < least) {
      least = distance;
      best = sample;
    }
  });
  return outside_.number(best);
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
      feet.clear();
      addFeet(fields_, y, z, x, feet);
      for (std::size_t i = 0; i < x.size(); ++i) {
        const glm::ivec3 at(x[i], y, z);
        const bool own = !inside && outside_.test(at);
        samples.push_back({at, own ? outside_.number(at) : nearestFoot(at, feet[i].position)});
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
        forEachAround(at, outside_.bits(), [&](glm::ivec3 sample) {
          const std::uint32_t other = outside_.number(sample);
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

// Those of the padded samples of a field that hold a number.
RankedBits SurfaceFeet::held() const {
  BitGrid held(solid_.size() + 2);
  const auto words = static_cast<std::size_t>(solid_.words());
  forEachLayer([&](int z) {
    BitRow near(words);
    for (int y = 0; y < solid_.size().y; ++y) {
      cornerRow(solid_, y, z, near);
      std::uint64_t* row = held.row(y + 1, z + 1);
      std::uint64_t before = 0;
      for (std::size_t w = 0; w < static_cast<std::size_t>(held.words()); ++w) {
        const std::uint64_t own = w < words ? near[w] : 0;
        row[w] = own << 1 | before >> (kWordBits - 1);
        before = own;
      }
    }
  });
  caps_.mark(held);
  return RankedBits(std::move(held));
}

// At a rim or a thin wall the gradient may lead into a cell without any: the mean of those of the 26 around that are
// given, or 0.
std::uint16_t SurfaceFeet::meanAround(glm::ivec3 at, const FootValues& from) {
  unsigned sum = 0, count = 0;
  forEachAround(at, from.given, [&](glm::ivec3 sample) {
    sum += from.values[from.feet.number(sample)];
    ++count;
  });
  return count == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>((sum + count / 2) / count);
}

void SurfaceFeet::spreadLayer(int z, const FootValues& from, SurfaceField& field) const {
  const glm::ivec3 size = solid_.size();
  const bool cells = size.x > 1 && size.y > 1 && size.z > 1;
  const auto words = static_cast<std::size_t>(solid_.words());
  BitRow near(words);
  std::vector<std::int32_t> others, numbers;
  for (int y = 0; y < size.y; ++y) {
    cornerRow(solid_, y, z, near);
    others.clear();
    const std::uint64_t* own = outside_.bits().row(y, z);
    for (std::size_t w = 0; w < words; ++w) near[w] &= ~own[w];
    forEachBit(near.data(), solid_.words(), [&](int x) { others.push_back(x); });
    numbers.assign(others.size(), kNoValue);
    if (cells) interpolatedRow(fields_, y, z, others, from, numbers);
    for (std::size_t w = 0; w < words; ++w) near[w] |= own[w];
    std::uint16_t* to = field.numbers().data() + field.placeOf({1, y + 1, z + 1});
    std::size_t foot = outside_.number({0, y, z}), other = 0;
    forEachBit(near.data(), solid_.words(), [&](int x) {
      if (other == others.size() || others[other] != x) {
        *to++ = from.values[foot++];
        return;
      }
      const std::int32_t number = numbers[other++];
      *to++ = number == kNoValue ? meanAround({x, y, z}, from) : static_cast<std::uint16_t>(number);
    });
  }
}

SurfaceField SurfaceFeet::spread(const std::vector<std::uint16_t>& values,
                                 const std::vector<std::uint8_t>* known) const {
  SurfaceField field(held());
  std::optional<BitGrid> some;
  if (known) some = given(*known);
  // Read in pairs.
  std::vector<std::uint16_t> walls(outside_.count() + 2, 0);
  std::copy_n(values.begin(), outside_.count(), walls.begin());
  const FootValues from{outside_, some ? *some : outside_.bits(), walls.data()};
  forEachLayer([&](int z) { spreadLayer(z, from, field); });
  caps_.spread(values.data() + outside_.count(), field);
  return field;
}

}  // namespace isolume
