// The narrow band around the isosurface, in which every sample gets its closest point from the interpolant itself.
//
// Seeds are the samples with a crossed edge (and, for caps, samples inside on the border of the grid). The other
// corners of their cells follow; then the band grows by one sample in every direction (26 neighbours) per layer. A new
// sample starts from the best point of its neighbours across faces and refines it (point_kernels.h). At last samples
// take over neighbours' points that are nearer by a two-thousandth, refined again, until that changes nothing.
//
// A sample that is not within k layers of the corners of cells with surface is further than k samples from every such
// cell along some axis, hence at least k + 1 smallest spacings from the surface; so is it from caps, whose cells have
// cap samples for corners.
//
// No step reads what another thread writes, so the result does not depend on the number of threads. Cost: one pass over
// the level, then O(band). Memory beside the field: 3 bits per voxel, 20 bytes per sample of the newest third of a
// layer.
#pragma once

#include "bit_grid.h"
#include "offset_field.h"

namespace isolume {

/// Points for the corners of cells that hold surface, for caps, and for that many layers around them (>= 0). Returns
/// which samples those are: none if there is no surface. First components of all others are unset, the rest is not
/// written.
BitGrid solveBand(GridView<const float> level, int layers, OffsetField& field);

}  // namespace isolume
