// Deterministic random cameras around and within a grid, the awkward ones among them, for judging rays.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raymarch/camera.h"

namespace isolume::bench {

/// What is looked at, in voxels (index times spacing over the smallest spacing).
struct ViewedBox {
  glm::dvec3 high{0};                    ///< of the grid's samples; the lowest is 0
  glm::dvec3 solidLow{0}, solidHigh{0};  ///< box of the solid
};

inline constexpr int kViewKinds = 8;
inline constexpr glm::ivec2 kViewSize{512, 384};
const char* viewKindName(int kind);

/// The view of that number, of kind number % kViewKinds:
///   0, 1  the whole solid from anywhere, in perspective and orthographic;
///   2     wide, from close to the grid's border;
///   3     wide, from within the grid, the solid included;
///   4     wide, from less than a voxel before a face of the grid;
///   5     from up to 1e5 diagonals away;
///   6     a detail, some voxels high, whose pixels are hundredths of a voxel;
///   7     orthographic along an axis, every ray through a quarter of a voxel, so that many lie in faces and edges of
///         cells.
/// World space is the grid's, in voxels.
Camera randomView(const ViewedBox& box, std::uint64_t number);

}  // namespace isolume::bench
