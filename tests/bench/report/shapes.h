// The inputs of the distance report: shapes with closed forms, scenes, or a volume file, as levels in voxels.
#pragma once

#include <string>
#include <vector>

#include "sweep/grid.h"

namespace isolume::bench {

/// sphere, torus, box, and the scenes of volumes/scenes.h.
std::vector<std::string> shapeNames();

/// size^3 samples over the unit cube at voxel centres, spacing 1, level > 0 inside: minus the exact signed distance in
/// voxels for sphere, torus and box. Centres are not at samples, and no two axes are alike, so that nothing is exact by
/// symmetry. UsageError for another name.
Grid<float> shapeLevel(const std::string& name, int size);

/// InputError if a sample on the border is inside: the solvers have no common idea of a solid that the border cuts.
void checkBorderOutside(GridView<const float> level, const std::string& name);

}  // namespace isolume::bench
