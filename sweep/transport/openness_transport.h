// Openness at given points by ordinates that are swept as light, voxel by voxel, with any scheme and transmittance
// (scheme.h): the classical discrete ordinates ([Singh10] with more directions than eight), in floats: the check of
// fixed_transport.h, which pictures take.
//
//   A = sum_k V_k max(N . w_k, 0) / sum_k max(N . w_k, 0),
// w_k the directions of ordinate_set.h, V_k trilinear at the point, `offsetVoxels` above it along N in index space. The
// denominator makes an open point exactly 1 whatever its normal; outside the grid all is open.
//
// The ordinates of an octant stand in SIMD lanes, sixteen at a time, and are summed as a plane is swept, so that two
// planes are all that is kept. Cost: O(voxels x ordinates). Memory: of each group of sixteen at work 256 bytes per
// voxel of a plane, 8 bytes per point. Bitwise the same for any number of threads and any SIMD width: no lane needs
// another's, and sums are integers.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "scheme.h"
#include "sweep/grid.h"

namespace isolume {

struct OpenPoint {
  glm::vec3 position{0};  ///< index space
  glm::vec3 normal{0};    ///< unit, world units along the grid's axes
};

struct TransportOptions {
  int ordinates = 72;  ///< over the whole sphere, >= 1
  TransportScheme scheme = TransportScheme::step;
  Transmittance transmittance = Transmittance::inside;
  double offsetVoxels = 1;
};

/// `distance`: world units, < 0 inside; +-inf where there is no surface. At least two samples along each axis. In the
/// order of the points; 1 for a point that no ordinate faces.
std::vector<float> transportOpenness(GridView<const float> distance, const std::vector<OpenPoint>& points,
                                     const TransportOptions& options = {});

}  // namespace isolume
