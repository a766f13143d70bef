// The narrow band around the isosurface, in which every sample gets its closest point from the interpolant itself.
//
// Seeds are the samples with a crossed edge (and, for caps, samples inside on the border of the grid). The other
// corners of their cells follow. Seeds and corners that may see two sheets look at every cell around them
// (closest_point.h). Then the band grows by k layers: across corners, edges and faces (26 neighbours), edges and faces
// (18) or faces alone (6), as few as are enough. A new sample starts from the best point of its neighbours and refines
// it (point_kernels.h). At last samples take over points of neighbours across faces that are nearer by a
// two-thousandth, refined again, until that changes nothing.
//
// What k layers leave out is far: of its steps a >= b >= c along the axes to the nearest corner of any cell with
// surface, a > k, or a + b or a + b + c is more than layers reach, which grow such that then a^2 + b^2 + c^2 >= (k +
// 1)^2. So it is at least k + 1 smallest spacings from the surface; and so from caps, whose cells have cap samples for
// corners.
//
// No step reads what another thread writes, so the result does not depend on the number of threads. Cost: one pass over
// the level, then O(band). Memory beside the field: 3 bits per voxel.
#pragma once

#include "offset_field.h"
#include "sweep/bit_grid.h"

namespace isolume {

/// Points for the corners of cells that hold surface, for caps, and for that many layers around them (>= 0). Returns
/// which samples those are: none if there is no surface. All others are not written.
BitGrid solveBand(GridView<const float> level, int layers, OffsetField& field);

}  // namespace isolume
