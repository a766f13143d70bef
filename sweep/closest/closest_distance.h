// Signed distance from subvoxel closest points: the second, more exact solver beside the sweep (occlusion_sweep.h).
//
// Computes D(v) = +-|v - p(v)|, p(v) the closest point of the isosurface of the trilinear interpolant of `level`, at
// every sample v: D < 0 where level > 0, world units, any spacing (the closest point in the world's metric). A solid
// that reaches the border of the grid ends there in a flat cap that is surface too. Three steps:
//   1. samples at the surface and in a band around it get their closest point by Newton steps on the interpolant itself
//      (closest_point.h, surface_band.h);
//   2. two passes over the planes of the grid carry the points to all other samples (plane_pass.h);
//   3. the length of the offset, with the sign of the level, overwrites one component of it.
// Every |D| is the distance to a point of the surface, hence an upper bound of the true distance up to kOnSurface and
// the rounding of offsets on their way (half a unit in the last place per step).
//
// Degenerate input: no sample inside gives +inf everywhere (a grid that is all inside has its cap). A level of exactly
// 0 is outside; a sample on the surface has 0, with the sign of its side (-0 for a sample of a cap). Axes with one
// sample have no thickness: on them every sample lies on the border.
//
// Cost: O(n), two passes. Memory: 12 bytes per voxel beside the level, the result included, plus O(surface) and
// O(nx ny). Bitwise the same for any number of threads and any SIMD width.
#pragma once

#include "sweep/distance_extent.h"
#include "sweep/grid.h"

namespace isolume {

/// Error against the closed form at 250^3 in voxels, sphere of radius 78 (torus of radii 67 and 27 in brackets), by
/// band:
///   band   within 3 voxels: mean, largest      everywhere: mean, largest
///   0      .0178 (.0187)   .142 (.144)         .0069 (.0078)   .16 (.14)
///   1      .0024 (.0032)   .039 (.042)         .0063 (.0071)   .13 (.14)
///   2      .0020 (.0028)   .0032 (.0059)       .0058 (.0066)   .15 (.11)
///   3      .0020 (.0028)   .0032 (.0059)       .0054 (.0061)   .14 (.10)
/// The trilinear interpolant itself is off by .0032 at most on that sphere, so band 2 is exact to the data.
struct ClosestOptions {
  DistanceExtent extent = DistanceExtent::full;
  int bandVoxels = 3;  ///< layers of samples around the cells with surface that are solved on the interpolant, >= 0
  int rounds = 1;      ///< rounds of two passes, >= 1; a second one changes next to nothing
};

/// `level` as of makeLevel(): > 0 inside, finite everywhere.
Grid<float> closestDistance(GridView<const float> level, const ClosestOptions& options = {});

}  // namespace isolume
