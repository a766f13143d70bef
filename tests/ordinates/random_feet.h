// Points of no surface in particular, for rays to start at.
#pragma once

#include <cmath>
#include <vector>

#include "support/random_numbers.h"
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

/// In chunks of 500, as they are sorted. Borrows the feet.
inline FootChunks chunksOf(const std::vector<SurfaceFoot>& feet) {
  constexpr std::size_t kChunk = 500;
  FootChunks chunks;
  for (std::size_t begin = kChunk; begin < feet.size(); begin += kChunk) chunks.begin.push_back(begin);
  chunks.begin.push_back(feet.size());
  chunks.add = [&feet, begin = chunks.begin](std::size_t chunk, std::vector<SurfaceFoot>& to) {
    const auto at = [&](std::size_t i) { return feet.begin() + static_cast<std::ptrdiff_t>(begin[i]); };
    to.insert(to.end(), at(chunk), at(chunk + 1));
  };
  return chunks;
}

}  // namespace isolume::test
