// Small level functions with known geometry, for the tests of the sweep.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>

#include "sweep/grid.h"

namespace isolume::test {

/// Samples f(position) of a grid whose sample (0, 0, 0) lies at the origin.
inline Grid<float> sampleLevel(glm::ivec3 size, glm::dvec3 spacing, const std::function<double(glm::dvec3)>& f) {
  Grid<float> grid(size, spacing);
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) grid.view()(x, y, z) = static_cast<float>(f(glm::dvec3(x, y, z) * spacing));
  return grid;
}

/// Deterministic values in [-1, 1] without structure: the hardest input for a layout.
inline Grid<float> noiseLevel(glm::ivec3 size, glm::dvec3 spacing, std::uint64_t seed) {
  Grid<float> grid(size, spacing);
  std::uint64_t state = seed;
  for (std::size_t i = 0; i < grid.count(); ++i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;  // Knuth's MMIX generator
    grid.data()[i] = static_cast<float>(static_cast<double>(state >> 40) / static_cast<double>(1 << 23) - 1);
  }
  return grid;
}

/// Positive inside a ball.
inline Grid<float> ballLevel(int size, double radiusVoxels, glm::dvec3 centre) {
  return sampleLevel(glm::ivec3(size), glm::dvec3(1),
                     [=](glm::dvec3 p) { return radiusVoxels - glm::length(p - centre); });
}

}  // namespace isolume::test
