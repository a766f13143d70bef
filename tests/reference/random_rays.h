// Deterministic random rays for the tests of the tracer, the awkward ones among them.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "sweep/reference/grid_ray.h"

namespace isolume::test {

/// SplitMix64: the same numbers on every machine, and any start value will do, so that every ray has its own.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
  /// In [low, high).
  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53; }
  int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }
  glm::dvec3 pointIn(glm::dvec3 low, glm::dvec3 high) {
    const double x = uniform(low.x, high.x), y = uniform(low.y, high.y);
    return {x, y, uniform(low.z, high.z)};
  }
  glm::dvec3 direction() {
    const double z = uniform(-1, 1), angle = uniform(0, 2 * M_PI), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

 private:
  std::uint64_t state_;
};

/// A ray towards a random point of the box of the samples. Of eight: four from outside at any angle, two from within,
/// one through lattice points (cell corners) along a lattice direction, so that it runs in faces and edges of cells,
/// and one along an axis at any place.
inline GridRay randomRay(glm::ivec3 size, std::uint64_t number) {
  Random random(number);
  const glm::dvec3 high(size - 1), middle = 0.5 * high;
  GridRay ray;
  const int kind = random.below(8);
  if (kind < 4) {
    ray.origin = middle + 1.5 * glm::length(high) * random.direction();
    ray.direction = random.pointIn(glm::dvec3(0), high) - ray.origin;
  } else if (kind < 6) {
    ray.origin = random.pointIn(glm::dvec3(0), high);
    ray.direction = random.direction();
  } else {
    ray.direction = glm::dvec3(0);
    if (kind == 6) {
      for (int i = 0; i < 3; ++i) ray.origin[i] = random.below(size[i]);
      while (ray.direction == glm::dvec3(0))
        for (int i = 0; i < 3; ++i) ray.direction[i] = random.below(5) - 2;
    } else {
      ray.origin = random.pointIn(glm::dvec3(0), high);
      ray.direction[random.below(3)] = random.below(2) != 0 ? 1 : -1;
    }
    // Back to where it is outside the box, without a rounding.
    ray.origin -= 4096.0 * ray.direction * static_cast<double>(random.below(2));
  }
  return ray;
}

}  // namespace isolume::test
