#include "scheme.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace isolume {
namespace {

constexpr std::size_t entry(int axis) { return (std::size_t{1} << axis) - 1; }

}  // namespace

UpwindWeights upwindWeights(TransportScheme scheme, glm::dvec3 direction, glm::dvec3 spacing) {
  const glm::dvec3 steps = glm::abs(direction) / spacing;  // voxels per length along each axis
  UpwindWeights weights{};
  if (scheme == TransportScheme::step) {
    for (int axis = 0; axis < 3; ++axis)
      weights[entry(axis)] = static_cast<float>(steps[axis] / (steps.x + steps.y + steps.z));
    return weights;
  }
  const int main = steps.x >= steps.y && steps.x >= steps.z ? 0 : steps.y >= steps.z ? 1 : 2;
  const int first = (main + 1) % 3, second = (main + 2) % 3;
  const double a = steps[first] / steps[main], b = steps[second] / steps[main];
  weights[entry(main)] = static_cast<float>((1 - a) * (1 - b));
  weights[entry(main) + entry(first) + 1] = static_cast<float>(a * (1 - b));
  weights[entry(main) + entry(second) + 1] = static_cast<float>((1 - a) * b);
  weights[6] = static_cast<float>(a * b);
  return weights;
}

float rampOf(Transmittance model, float distance) {
  return std::clamp(distance + (model == Transmittance::centred ? 0.5F : 1.0F), 0.0F, 1.0F);
}

float powerOf(Transmittance model, glm::dvec3 direction) {
  if (model != Transmittance::insideByLength) return 1;
  const glm::dvec3 d = glm::abs(direction);
  return static_cast<float>(1 / (d.x + d.y + d.z));
}

}  // namespace isolume
