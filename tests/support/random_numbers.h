// Random numbers that are the same on every machine, for inputs of tests.
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace isolume::test {

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ULL + 1) {}
  /// In [0, 1).
  double uniform() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;  // Knuth's MMIX generator
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  int below(int bound) { return static_cast<int>(uniform() * bound); }
  glm::dvec3 inCube() {
    const double x = uniform(), y = uniform(), z = uniform();
    return {x, y, z};
  }
  /// Unit, uniform over the sphere: points of the ball, scaled.
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 v = 2.0 * inCube() - 1.0;
      const double square = glm::dot(v, v);
      if (square <= 1 && square > 1e-4) return v / glm::sqrt(square);  // nearer the centre it has few bits
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace isolume::test
