// The narrow band around the isosurface, in which every sample gets its closest point from the interpolant itself.
//
// Seeds are the corners of cells that hold surface (and, for caps, samples inside on the border of the grid). Then the
// band grows by one sample in every direction (26 neighbours) per layer: a new sample takes the best of its neighbours'
// points and refines it (closest_point.h). All other samples are unset. A layer reads only what earlier layers wrote,
// so the result does not depend on the number of threads.
//
// Cost: one pass over the level, then O(band). Memory beside the field: 16 bytes per sample of the newest layer, 4 per
// sample of the one before.
#pragma once

#include "offset_field.h"

namespace isolume {

/// Fills `field` (same size as `level`) with the band of that many layers, the seeds not counted (>= 0). Returns the
/// number of samples in it: 0 if there is no surface.
std::size_t startOffsets(GridView<const float> level, int layers, OffsetField& field);

}  // namespace isolume
