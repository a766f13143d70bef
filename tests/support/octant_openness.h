// Fields read at points between samples, as the shaders read them.
#pragma once

#include <glm/common.hpp>
#include <numbers>

#include "sweep/occlusion_sweep.h"
#include "sweep/octants/geometry_terms.h"

namespace isolume::test {

/// Trilinear at a point of index space, clamped to the grid. At least two samples along each axis.
template <class T>
double trilinear(GridView<const T> field, glm::dvec3 position) {
  const glm::dvec3 p = glm::clamp(position, glm::dvec3(0), glm::dvec3(field.size - 1));
  const glm::ivec3 low = glm::min(glm::ivec3(p), field.size - 2);
  const glm::dvec3 part = p - glm::dvec3(low);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 weight = glm::mix(1.0 - part, part, glm::dvec3(side));
    sum += weight.x * weight.y * weight.z * static_cast<double>(field(low.x + side.x, low.y + side.y, low.z + side.z));
  }
  return sum;
}

/// A = sum_s V_s G_s(N) / pi ([Singh10] Eq. 3, 4, divided by pi), from float octants.
inline double octantOpenness(const OctantVisibility& visibility, glm::dvec3 position, glm::dvec3 normal) {
  double sum = 0;
  for (int s = 0; s < kOctantCount; ++s)
    sum += octantGeometryTerm(s, normal) * trilinear(visibility.octants[static_cast<std::size_t>(s)].view(), position);
  return sum / std::numbers::pi;
}

}  // namespace isolume::test
