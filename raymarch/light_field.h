// Lights that were swept on the CPU: a number for each sample next to the surface, in a texture, and what it is
// multiplied with when it is drawn. So a light's colour and intensity change at the cost of a frame, its direction and
// size at that of a sweep.
#pragma once

#include <glm/vec3.hpp>

#include "sweep/ordinates/surface_field.h"

namespace isolume {

/// One number per sample: E / pi of a light of colour 1, or the visible share of a disc of light.
struct LightField {
  const SurfaceField* values = nullptr;  ///< borrowed while it is uploaded
  float full = 1;                        ///< what 65535 stands for
  bool everywhere = false;               ///< a value at every sample: interpolated without a look at the surface
  glm::dvec3 direction{0};               ///< of a disc: towards its centre, world, any length but 0
  double radiusDegrees = 0;  ///< of a disc: angular radius, in (0, 90]; its light is multiplied with the mean clamped
                             ///< cosine at the hit's normal. 0: no disc
};

/// A point of light infinitely far away whose shadows the shader finds along a ray of its own: hard and exact, nothing
/// is swept.
struct HardSun {
  glm::dvec3 direction{0, 0, 1};  ///< world, towards it, any length but 0
  glm::vec3 color{1};             ///< linear
};

}  // namespace isolume
