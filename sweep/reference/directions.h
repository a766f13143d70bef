// From points of the unit square to directions: area-preserving maps, so that even points give even directions.
// Pure functions; every direction is of unit length.
#pragma once

#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace isolume {

/// A right-handed orthonormal frame whose z is the unit vector `axis`; without branches on tiny components. [Duff17]
inline glm::dmat3 frameAbout(glm::dvec3 axis) {
  const double sign = std::copysign(1.0, axis.z);
  const double a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
  return {glm::dvec3(1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x),
          glm::dvec3(b, sign + axis.y * axis.y * a, -axis.y), axis};
}

/// The direction at that height above the xy plane; `turn` in [0, 1) is its share of a full turn about z.
inline glm::dvec3 directionAt(double height, double turn) {
  const double across = std::sqrt(std::fmax(1 - height * height, 0.0)), angle = 2 * std::numbers::pi * turn;
  return {across * std::cos(angle), across * std::sin(angle), height};
}

/// Density cos(theta) / pi over the hemisphere about z.
inline glm::dvec3 cosineDirection(glm::dvec2 u) { return directionAt(std::sqrt(1 - u.x), u.y); }

/// Density 1 / (2 pi) over the hemisphere about z.
inline glm::dvec3 hemisphereDirection(glm::dvec2 u) { return directionAt(1 - u.x, u.y); }

/// Uniform over the cap of that angular radius about z. `capHeight` = 1 - cos(radius) = 2 sin^2(radius / 2): its own
/// argument, since 1 - cos loses the digits of a light as small as the sun.
inline glm::dvec3 capDirection(glm::dvec2 u, double capHeight) {
  const double below = u.x * capHeight;  // 1 - cos(theta); sin^2(theta) = below (2 - below), exact near the axis too
  const double across = std::sqrt(below * (2 - below)), angle = 2 * std::numbers::pi * u.y;
  return {across * std::cos(angle), across * std::sin(angle), 1 - below};
}

}  // namespace isolume
