// Openness of the surface by ordinates that are swept as light (scheme.h), in place of the rays of
// sweep/ordinates/openness_sweep.h: the same sums at the same feet, and the same result, so that either serves
// pictures.
//
// Light that mixes from voxel to voxel is blurred, which stands for the directions between few ordinates: with 72 the
// error is .019 / .021 / .024 (corner, gyroid, capsules at 128^3) where rays have .031 / .033 / .050; with many it
// stays, and that of rays falls (docs/occlusion-study.md).
//
// Beyond the grid all is open: a foot on a face of the grid that looks straight out of it, as those of caps do, is open
// though the sweep has it in the solid.
#pragma once

#include "openness_transport.h"
#include "sweep/ordinates/surface_field.h"

namespace isolume {

/// `level` as of makeLevel(), `distance` exact next to its surface; at least two samples along each axis, else all is
/// open. Memory: that of the feet (surface_feet.h), 28 bytes more for each, and of transportBlocked().
SurfaceField sweepTransport(GridView<const float> level, GridView<const float> distance,
                            const TransportOptions& options = {});

}  // namespace isolume
