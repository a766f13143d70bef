// Rays in index space, and what they meet.
#pragma once

#include <glm/vec3.hpp>
#include <limits>

namespace isolume {

/// Points origin + t * direction, start <= t <= end, in index space. The direction has any length but 0; components
/// may be 0. The origin may lie anywhere.
struct GridRay {
  glm::dvec3 origin{0}, direction{0, 0, 1};
  double start = 0;
  double end = std::numeric_limits<double>::infinity();
};

struct SurfacePoint {
  double t = 0;            ///< along GridRay::direction
  glm::dvec3 position{0};  ///< index space, within the box
  int capAxis = -1;        ///< axis of the face of the box that cuts the solid there, or -1: on the isosurface
};

}  // namespace isolume
