// Directions drawn where the sky is bright, for environment importance sampling: what shaders/screen/importance.glsl
// needs to draw by luminance times cosine.
//
// The sphere is cut into cells, kCellsAlong^2 on each face of a cube. A cell knows its power, the integral of luminance
// over it, and kCellDraws directions drawn within it by luminance, stratified, each with the colour of its light: its
// radiance over its luminance. So a pixel weighs the cells' powers by its cosine, draws cells by that, and takes the
// directions of the cells as they come. 96 cells; 50 KiB. Immutable.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "raymarch/screen/sky_cube.h"

namespace isolume {

inline constexpr int kCellsAlong = 4;
inline constexpr int kSkyCells = kCubeFaces * kCellsAlong * kCellsAlong;
inline constexpr int kCellDraws = 16;

/// Cell by cell, 1 + 2 kCellDraws texels: the direction to its centre and its power; then for each draw a direction
/// and a colour, the latter of luminance 1 (0 where a cell is black).
std::vector<glm::vec4> skyDraws(const SkyCube& sky);

}  // namespace isolume
