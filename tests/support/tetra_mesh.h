// A triangle mesh of the isosurface by marching tetrahedra, for tracers that know triangles only.
//
// Every cell is cut into the six tetrahedra of Kuhn, in which the level is taken to be linear; samples with level > 0
// are inside. The mesh also covers the caps, where the box of the samples cuts the solid, so that it is closed.
// Neighbouring tetrahedra share their vertices bit for bit.
//
// Error: linear and trilinear interpolation agree at the samples and differ by O(h^2) in between, so the mesh lies
// within O(h^2) of the isosurface (in voxels: second differences of the level over its slope). Cost O(n) time, 36 bytes
// per triangle, about 12 triangles for a cell that the surface cuts.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "sweep/grid.h"

namespace isolume::test {

/// Three corners per triangle, index space; not oriented.
std::vector<glm::vec3> tetraMesh(GridView<const float> level);

}  // namespace isolume::test
