// Openness of the surface, A = (1 / pi) integral of V(w) max(N . w, 0) dw ([Singh10] Eq. 2, normalised: an open point
// gives 1), by ordinates: directions of equal weight (ordinate_set.h), each swept through the whole grid as parallel
// rays, one bit per ray (sheared_rays.h).
//
// Where [Singh10] carries one value per octant, whose mixing of neighbours is diffusion along the way (Eq. 6), here
// nothing mixes: V is 0 or 1, so that the error falls with the number of ordinates, K^-3/4, until the lattice's steps
// show. No point is shaded by the lattice's steps of its own plane (sheared_rays.h).
//
// Result: a value for each sample next to the surface and for the caps (surface_field.h), to be interpolated at points
// of the surface. Bitwise the same for any number of threads and any SIMD width.
#pragma once

#include <cstdint>

#include "surface_rays.h"
#include "sweep/grid.h"

namespace isolume {

inline constexpr int kLeastOrdinates = 8, kMostOrdinates = 4096, kMostRefinement = 2;

struct OrdinateOptions {
  int ordinates = 512;  ///< directions over the whole sphere
  int refinement = 1;   ///< lattice points per voxel along each axis, 1 or 2
};

/// By foot, the share of the hemisphere about N that is blocked, weighed by the cosine: 1 - A, to a rounding.
std::vector<float> blockedShares(const SurfaceRays& rays, int ordinates);

/// In units of 1 / 65535.
std::vector<std::uint16_t> opennessOf(const std::vector<float>& blockedShares);

/// The same from the fields. `level` as of makeLevel(), `distance` exact next to its surface.
/// Memory: that of the result (surface_field.h). While it runs: refinement^3 / 4 B per voxel for the lattice (rows
/// rounded up to words), 5/16 B for the marks of the samples, 36 B for each foot (1 to 3 % of the samples at 256^3 in
/// the sample scenes), and 4 B more of these for each thread but the first. std::length_error where a layer of the
/// lattice has 2^24 points or more (2048^3 refined). Time: bench_ordinates.
SurfaceField sweepOpenness(GridView<const float> level, GridView<const float> distance,
                           const OrdinateOptions& options = {});

}  // namespace isolume
