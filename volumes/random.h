// Deterministic random numbers for the scenes: the same on every machine, unlike std:: distributions.
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "sweep/mix_bits.h"

namespace isolume {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// In [0, 1), with all 53 bits of a double's mantissa.
  double uniform() {
    state_ += kSplitMixIncrement;
    return static_cast<double>(mixBits(state_) >> 11) * 0x1p-53;
  }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  glm::dvec3 inBox(double low, double high) {
    const double x = uniform(low, high), y = uniform(low, high), z = uniform(low, high);
    return {x, y, z};
  }
  /// Uniform on the unit sphere, by rejection: no function that differs between maths libraries.
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 v = inBox(-1, 1);
      const double square = glm::dot(v, v);
      constexpr double kTooShort = 1e-4;  // direction of a vector near 0 would lose its precision
      if (square <= 1 && square > kTooShort) return v / glm::length(v);
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace isolume
