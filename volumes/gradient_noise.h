// Gradient noise with its derivative, [Perlin02]: smooth (C2), mean 0, in [-1, 1], features about one unit across.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace isolume {

struct NoiseSample {
  double value = 0;
  glm::dvec3 gradient{0};
};

/// Another seed gives an independent field. Only additions and multiplications of doubles: the same on every machine.
double gradientNoiseValue(glm::dvec3 p, std::uint64_t seed);
/// The same value with its gradient, at about twice the cost.
NoiseSample gradientNoise(glm::dvec3 p, std::uint64_t seed);

}  // namespace isolume
