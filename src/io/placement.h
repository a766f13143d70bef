// Where a grid stands in the world: checks and builds Volume::worldFromGrid, and the grid that goes with it.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <string>

#include "sweep/grid.h"

namespace isolume {

/// Columns direction[i] * spacing[i], then the origin. A negative spacing is a reflection. Checked by checkPlacement.
glm::dmat4 placeGrid(const std::string& path, glm::dvec3 spacing, const glm::dmat3& direction, glm::dvec3 origin);

/// InputError naming the path unless every entry is finite, no axis has length 0 and the axes are at right angles to
/// 1e-4 (the cosine): rotation, reflection and scale pass, shear does not.
void checkPlacement(const std::string& path, const glm::dmat4& worldFromGrid);

/// Uninitialised grid with the spacing and origin of worldFromGrid (column lengths, translation; exact where axes
/// align). InputError if a dimension is below 2 (an isosurface needs cells) or above what an index holds, or if 4 bytes
/// per sample, and `scratchBytesPerSample` more while reading, do not fit into memory.
Grid<float> makeGrid(const std::string& path, glm::i64vec3 size, const glm::dmat4& worldFromGrid,
                     std::size_t scratchBytesPerSample = 0);

}  // namespace isolume
