#include <cmath>
#include <numbers>

#include "scene_families.h"

namespace isolume {

double gyroidValue(glm::dvec3 p) {
  constexpr double kPeriods = 3, kHalfSheet = 0.5, kBallRadius = 0.42;
  constexpr double kWaveNumber = 2 * std::numbers::pi * kPeriods;
  const double x = kWaveNumber * p.x, y = kWaveNumber * p.y, z = kWaveNumber * p.z;
  const double gyroid = std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
  // Divided by the wave number, so that both terms are lengths of about the same scale.
  const double sheet = (std::abs(gyroid) - kHalfSheet) / kWaveNumber;
  return std::max(sheet, glm::length(p - glm::dvec3(0.5)) - kBallRadius);
}

}  // namespace isolume
