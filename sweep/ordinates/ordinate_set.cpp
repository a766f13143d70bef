#include "ordinate_set.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

namespace isolume {

std::vector<glm::dvec3> ordinateDirections(int count) {
  // No symmetry of the cube maps the axis to itself, and its components are far from equal and from 0.
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, 0.5, 0.8));
  const glm::dvec3 across = glm::normalize(glm::cross(axis, glm::dvec3(1, 0, 0)));
  const glm::dmat3 frame(across, glm::cross(axis, across), axis);
  std::vector<glm::dvec3> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double height = 1 - (2 * i + 1.0) / count, radius = std::sqrt(1 - height * height);
    const double angle = 2 * std::numbers::pi * i / std::numbers::phi;
    directions.push_back(frame * glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), height));
  }
  return directions;
}

}  // namespace isolume
