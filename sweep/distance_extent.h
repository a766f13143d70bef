// How far from the surface a distance field is solved.
//
// What light and pictures read of a distance are the samples with a neighbour of the other side (octants, ordinates and
// their feet, thickness): a band of any number of voxels has those in full. Convex outlines (ordinates/outline.h) read
// those around them too, up to two voxels: a band of one voxel has these. Slopes of the distance (normals from it)
// look up to 2.8 voxels from the surface, where a sample beside the corner of a cell may lie. The march reads no
// distance at all, but the level's own clearance (raymarch/clearance.h): a band does not change its steps.
#pragma once

namespace isolume {

enum class DistanceExtent {
  full,  ///< at every sample
  band   ///< within some voxels of the surface; beyond, a lower bound of the distance that is the same everywhere
};

inline constexpr int kBandVoxels = 3;         ///< if nobody says otherwise: slopes of the distance are whole
inline constexpr int kSurfaceBandVoxels = 1;  ///< for what reads no slopes
/// Layers that closest points of the whole grid are solved on: with more, none within three voxels is more exact.
inline constexpr int kWholeBandVoxels = 2;

}  // namespace isolume
