// Colours of the surface by another field: values on a grid of its own, and the colours that they stand for.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "sweep/grid.h"

namespace isolume {

/// Stands for a value that is not known.
inline constexpr float kUnknownPlace = 3e38F;
inline constexpr float kLargestPlace = 1e30F;  ///< in size

/// On the GPU 4 B per sample of its own grid (R32F).
struct ColorField {
  /// Places along the colours: 0 and 1 are the ends, beyond which nothing changes; up to kLargestPlace, or
  /// kUnknownPlace. Not clamped to the ends, which would move the surface where one is crossed. Borrowed while they are
  /// uploaded; of any size and spacing.
  GridView<const float> places;
  glm::dmat4 worldFromGrid{1};
  std::vector<glm::vec3> colors;  ///< linear, evenly from 0 to 1; at least two
  glm::vec3 unknown{0.5F};        ///< linear: where no value is known, or the field does not reach
};

}  // namespace isolume
