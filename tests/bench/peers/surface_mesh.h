// The isosurface as triangles, by OpenVDB's volumeToMesh without adaptivity.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "sweep/grid.h"

namespace isolume::bench {

struct SurfaceMesh {
  std::vector<glm::vec3> points;   ///< world
  std::vector<glm::vec3> normals;  ///< of each point, world, unit, out of the solid: from the data, see below
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Two triangles for every quad. A solid that the border cuts is closed there: beyond the grid the level falls steeply.
/// Normals are the gradient of the data by differences one sample to each side (one-sided at the border), which are
/// closer to those of the truth than means over the triangles. `level` > 0 inside. All of this, packing the levels into
/// OpenVDB's tree included, is what a user of that library has to do before the first picture.
SurfaceMesh meshOf(GridView<const float> level, const glm::dmat4& worldFromGrid);

}  // namespace isolume::bench
