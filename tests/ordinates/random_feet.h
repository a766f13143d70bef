// Points of no surface in particular, for rays to start at.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <vector>

#include "support/random_numbers.h"
#include "sweep/grid.h"
#include "sweep/ordinates/surface_feet.h"

namespace isolume::test {

/// Within a grid of that size; every third at whole or half samples, on the border too, every ninth without a normal.
inline std::vector<SurfaceFoot> randomFeet(glm::ivec3 size, int count, RandomNumbers& numbers) {
  std::vector<SurfaceFoot> feet;
  for (int i = 0; i < count; ++i) {
    glm::dvec3 position = numbers.inCube() * (glm::dvec3(size) - 1.0);
    if (i % 3 == 0) position = glm::round(position * 2.0) / 2.0;
    feet.push_back({glm::vec3(position), i % 9 == 4 ? glm::vec3(0) : glm::vec3(numbers.direction())});
  }
  return feet;
}

/// A part of a grid: up to 12 samples along each axis, anywhere.
struct RandomPart {
  glm::ivec3 low, end;
  RandomPart(glm::ivec3 size, RandomNumbers& numbers) {
    constexpr int kMost = 12;
    for (int k = 0; k < 3; ++k) {
      low[k] = numbers.below(size[k]);
      end[k] = std::min(size[k], low[k] + 1 + numbers.below(kMost));
    }
  }
  bool holds(glm::ivec3 p) const { return glm::all(glm::greaterThanEqual(p, low)) && glm::all(glm::lessThan(p, end)); }
};

/// The same points within one part, and all that is solid within another: rays far from both pass between them.
inline void gather(Grid<float>& level, std::vector<SurfaceFoot>& feet, RandomNumbers& numbers) {
  const glm::ivec3 size = level.view().size;
  const RandomPart solid(size, numbers), stood(size, numbers);
  const auto view = level.view();
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        if (!solid.holds({x, y, z})) view(x, y, z) = -1;
  const glm::vec3 scale = glm::vec3(stood.end - stood.low) / glm::vec3(size);
  for (SurfaceFoot& foot : feet) foot.position = glm::vec3(stood.low) + foot.position * scale;
}

/// In chunks of 500, as they are sorted. Borrows the feet.
inline FootChunks chunksOf(const std::vector<SurfaceFoot>& feet) {
  constexpr std::size_t kChunk = 500;
  FootChunks chunks;
  for (std::size_t begin = kChunk; begin < feet.size(); begin += kChunk) chunks.begin.push_back(begin);
  chunks.begin.push_back(feet.size());
  chunks.feet = [&feet, begin = chunks.begin](std::size_t chunk, std::vector<SurfaceFoot>&) {
    return feet.data() + begin[chunk];
  };
  return chunks;
}

}  // namespace isolume::test
