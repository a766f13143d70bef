// How far from the surface a distance field is solved.
#pragma once

namespace isolume {

enum class DistanceExtent {
  full,  ///< at every sample
  band   ///< within some voxels of the surface; beyond, a lower bound of the distance that is the same everywhere
};

}  // namespace isolume
