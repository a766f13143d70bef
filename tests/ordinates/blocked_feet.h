// How far a surface's own steps in the lattice reach: by the parts of the sweep, with any lift.
#pragma once

#include "sweep/grid.h"
#include "sweep/ordinates/openness_sweep.h"

namespace isolume::test {

/// How many feet of the surface, of those more than `margin` samples from the border, lose anything to any of the
/// ordinates when lifted by `lift` of a lattice cell's width.
int blockedFeet(GridView<const float> level, const OrdinateOptions& options, double lift, double margin = 0);

}  // namespace isolume::test
