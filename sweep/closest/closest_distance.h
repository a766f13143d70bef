// Signed distance from subvoxel closest points: the second, more exact solver beside the sweep (occlusion_sweep.h).
//
// Computes D(v) = +-|v - p(v)|, p(v) the closest point of the isosurface of the trilinear interpolant of `level`, at
// every sample v: D < 0 where level > 0, world units, any spacing (the closest point in the world's metric). A solid
// that reaches the border of the grid ends there in a flat cap that is surface too. Three steps:
//   1. samples at the surface and in a band around it get their closest point by Newton steps on the interpolant itself
//      (surface_band.h, closest_point.h);
//   2. two passes over the planes of the grid carry the points to all other samples (plane_pass.h);
//   3. the length of the nearer point's offset, with the sign of the level, overwrites one component.
// Every |D| of these is the distance to a point of the surface, hence an upper bound of the true distance up to the
// tolerances of point_kernels.h and the rounding of offsets on their way (half a unit in the last place per step).
//
// With extent = band, step 2 is left out. D is the full solution's, bit for bit, at the samples of the band: the
// corners of cells with surface and k = bandVoxels layers about them, however far apart samples are. Elsewhere |D| is k
// + 1 smallest spacings. A sample outside the band is no nearer to the surface than that (surface_band.h), so there it
// is a lower bound of the true distance. Next to the surface bands of 1 and of 2 layers gave the same bits on the
// shapes below, capsules and a gyroid; of 3 layers others at 15 of the gyroid's 1.2 million samples, by a
// ten-thousandth. Of the whole domain's time at 250^3 a band of 1 takes .32 to .35 on the sphere, .31 to .42 on the
// torus and .47 to .53 on the gyroid; on the gyroid the corners of cells with surface alone, 8 % of all samples, take
// .34, so that no band is to be had there for a quarter.
//
// Near a smooth surface D is that of the interpolant, whose own error is h^2 / 8 times the sum of second derivatives
// over the steepness: second order. Where several sheets are about equally far (rims, noise), another than the nearest
// may be found: within 3 voxels of a thin-walled gyroid at 250^3, .04 % are too far by more than .03 voxel, none of
// 20,000 by .13.
//
// Mirrored or permuted grids give the same distance, not the same bits. Already in the band two fifths of the
// samples differ in the last ones, since the interpolant rounds otherwise in a mirrored cell (torus and gyroid at
// 128^3; by more than 1e-5 voxel .8 and 1.2 % when mirrored, none and .02 % when permuted). Beyond, ties and the order
// of the passes decide: by more than a hundredth .01 to .15 and .12 to .22 % when mirrored, .9 and .6 % when permuted,
// on the torus all within a tenth.
//
// Degenerate input: no sample inside gives +inf everywhere (a grid that is all inside has its cap). A level of exactly
// 0 is outside; a sample on the surface has 0, with the sign of its side (-0 for a sample of a cap). A corner of level
// 0 (or 0 in float beside its cell's largest) that no crossed edge ends in may count as surface or not. Axes with one
// sample have no thickness: on them every sample lies on the border.
//
// Cost: O(n), two passes. Memory: 12 bytes per voxel beside the level, the result included, of which 8 are not touched
// where no sample of the band is near; while the band is made also 3 bits per voxel; plus O(nx ny). Planes of less
// than 2^31 samples. Bitwise the same for any number of threads and any SIMD width.
#pragma once

#include "sweep/distance_extent.h"
#include "sweep/grid.h"

namespace isolume {

/// Error against the closed form at 250^3 in voxels, sphere of radius 78 (torus of radii 67 and 27 in brackets), by
/// bandVoxels:
///        within 3 voxels: mean, largest      everywhere: mean, largest
///   0    .0177 (.0187)   .146 (.146)         .0065 (.0076)   .15 (.15)
///   1    .0024 (.0032)   .040 (.043)         .0059 (.0070)   .10 (.10)
///   2    .0020 (.0028)   .0032 (.0059)       .0055 (.0065)   .08 (.10)
///   3    .0020 (.0028)   .0032 (.0059)       .0053 (.0063)   .08 (.10)
/// The trilinear interpolant itself is off by .0032 at most on that sphere, so the band is exact to the data. Two
/// layers hold every sample within three voxels: a third makes none of these more exact and takes a tenth more time.
struct ClosestOptions {
  DistanceExtent extent = DistanceExtent::full;
  /// Layers of samples around the cells with surface that are solved on the interpolant, >= 0.
  int bandVoxels = kWholeBandVoxels;
};

/// `level` as of makeLevel(): > 0 inside, finite everywhere.
Grid<float> closestDistance(GridView<const float> level, const ClosestOptions& options = {});

}  // namespace isolume
