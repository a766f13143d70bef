// The closest surface point of every sample, as an offset vector from the sample: what seeds, band and passes share.
//
// Units: the smallest spacing of the grid is 1, so that squares neither overflow nor vanish at any spacing. Three
// separate components (12 bytes per voxel), index order as in grid.h. A sample that has no point yet is unset.
#pragma once

#include <array>

#include "sweep/grid.h"

namespace isolume {

/// First component of an unset offset; the others may hold anything. Its square fits into a float and adding a step to
/// it changes nothing, so that a candidate from an unset neighbour is never strictly nearer.
inline constexpr float kUnsetOffset = 0x1p60F;

struct OffsetField {
  std::array<Grid<float>, 3> component;
  explicit OffsetField(GridView<const float> like)
      : component{Grid<float>(like.size, like.spacing, like.origin), Grid<float>(like.size), Grid<float>(like.size)} {}

  glm::vec3 at(std::size_t i) const { return {component[0].data()[i], component[1].data()[i], component[2].data()[i]}; }
  void set(std::size_t i, glm::vec3 offset) {
    for (int axis = 0; axis < 3; ++axis) component[static_cast<std::size_t>(axis)].data()[i] = offset[axis];
  }
};

/// |offset|^2 with the one rounding order that every part of the solver uses, scalar or vector.
inline float squaredLength(glm::vec3 offset) {
  return (offset.x * offset.x + offset.y * offset.y) + offset.z * offset.z;
}

}  // namespace isolume
