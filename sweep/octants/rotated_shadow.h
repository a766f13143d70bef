// Low-frequency shadow of a light from any direction, by an occlusion grid that is turned towards it ([Singh10]
// Sec. 4.1): one octant of Eq. 6 to 8 on a grid of its own, whose diagonal points to the light.
//
// The turned grid is cubic, with the smallest spacing h of the given one, and as large as it takes to hold it. Of the
// eight diagonals the one nearest to the light is turned, by the smallest angle, so that a light on a diagonal needs no
// turn, and a scene that is turned by a quarter together with its light gives the same shadow (but where a component of
// the light is 0: such ties go to the positive side). Distances are interpolated trilinearly at the turned samples;
// beyond the given grid all is open. The octant's V is read back at the given samples, trilinearly too.
//
// V is 1 where the light arrives unobstructed. It knows no N, and the angular size of the light is that of the scheme:
// the penumbra widens with the square root of the number of voxels from the edge that casts it. Next to the surface
// Eq. 7 makes it occlude itself, hence the offset.
//
// Cost: O(n). Memory: 2 B per voxel for the result, and meanwhile 4 B per voxel of the turned grid, of which there are
// 1 to 4.4 times as many in a cube. Bitwise the same for any number of threads. Pure function: thread-safe.
#pragma once

#include <cstdint>

#include "sweep/grid.h"

namespace isolume {

struct RotatedShadowOptions {
  /// V is read that far from each sample along the gradient of the distance, in units of h, >= 0: 0 is [Singh10].
  double offsetVoxels = 0;
  float opacity = 1;  ///< alpha of [Singh10] Eq. 8, [0, 1]
};

/// `distance`: world units, < 0 inside; +-inf where there is no surface. `towardsLight`: along the axes of the grid in
/// physical space (not index space), any length but 0. Result: round(65535 V).
Grid<std::uint16_t> sweepRotatedShadow(GridView<const float> distance, glm::dvec3 towardsLight,
                                       const RotatedShadowOptions& options = {});

}  // namespace isolume
