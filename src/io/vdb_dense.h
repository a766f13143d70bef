// Dense floats to OpenVDB trees, bit for bit. For the translation units that use OpenVDB only.
#pragma once

#include <openvdb/openvdb.h>

#include <glm/mat4x4.hpp>
#include <string>

#include "sweep/grid.h"

namespace isolume {

/// Index to world as OpenVDB has it: a scale where the axes are aligned, an affine map otherwise. OutputError if
/// OpenVDB cannot hold it (a voxel of less than 3e-15 of volume: it takes such a matrix for singular).
openvdb::math::Transform::Ptr vdbTransform(const glm::dmat4& worldFromGrid);

/// Every sample active, sample (i, j, k) at that index. Blocks of 8^3 equal bits become tiles; the rest keep theirs.
openvdb::FloatGrid::Ptr denseVdbGrid(GridView<const float> values, const glm::dmat4& worldFromGrid,
                                     const std::string& name, float background);

/// Signed distances cut to |v| < band: active there, +-band and inactive beyond. OpenVDB's sign: < 0 inside.
openvdb::FloatGrid::Ptr levelSetVdbGrid(GridView<const float> values, const glm::dmat4& worldFromGrid,
                                        const std::string& name, float band);

}  // namespace isolume
