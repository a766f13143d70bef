// Signed distance by fast sweeping, and the visibility of eight octants swept through it.
//
// Distance: solves |grad D| = 1 with D = 0 on the surface by one Gauss-Seidel sweep per octant ([Singh10] Sec. 1.1,
// Table 1; [Zhao05]), D < 0 inside the solid, in world units, at voxel centres. Any spacing. Samples next to the
// surface start from their distance to the interpolant, or the paper's axis minimum (surface_start.h), and stay fixed,
// but that none exceeds a neighbour's by more than the spacing between them. A solid that reaches the border of the
// grid ends there: the border is surface ("cap"). No surface at all: +inf or -inf everywhere.
//
// Fixed point: an update is exactly monotone in float (upwind_update-inl.h), so rounds from unset values down end, and
// they end at the greatest fixed point whatever the order of the sweeps: with as many rounds as it takes, mirrored and
// permuted grids give the same bits. One round is within a twentieth of a voxel of that on a ball, more where shortest
// paths wind (a gyroid).
//
// Error against the trilinear surface, voxels, one round, `better` (`paper` in brackets):
//   250^3    mean            largest       mean within 3 voxels    mean at start values
//   sphere   .204 (.295)     1.03 (.89)    .0043 (.086)            .0017
//   torus    .220 (.286)     .67 (.83)     .0069 (.079)            .0017
//   box      .381 (.381)     2.12 (2.12)   .0039 (.0041)           .0003
//   gyroid   .330 (.418)     1.25 (1.33)   .0089 (.112)            .0022
// The largest on the sphere is too short, at its centre, where six fronts meet and the scheme rounds the peak: its own
// fixed point from exact start values has it too (1.64 where a sample lies within a voxel of the centre of a ball of
// radius 77.5, 1.74 on it), and start values that are too long by c hide c of it: 1 / sqrt(sum 1 / d_i^2) over the
// crossings along the axes .05, the paper's .10. Far from the surface D is too long at three quarters of the samples
// and more.
//
// Visibility: V_s in [0, 1], 1 where octant s is unobstructed ([Singh10] Eq. 6), with the transmittance of Eq. 7 over
// the smallest spacing, of Eq. 8 for a translucent solid. Light enters at the border of the grid. On anisotropic grids
// the three neighbours weigh 1/h_i, which keeps the paper's direction (1, 1, 1) in world space; at equal spacings the
// weights are the paper's 1/3.
//
// [Singh10] Sec. 2 embeds the visibility in the passes of the distance. Here it has passes of its own: the result is
// the same, for Eq. 7 asks for distances below h/2 alone, all of which are start values; and light, which needs neither
// roots nor many bits, then goes four octants at a time in 16-bit lanes (fixed_light_sweeper.h), which takes .4 of the
// time that it added to the distance's passes in float. `rgba8` and `combined` come from there, `float32` from a sweep
// in float (light_sweeper.h).
//
// Cost: O(n) per sweep, eight sweeps. Memory per voxel: distance 4 B; octants rgba8 8 B, float32 32 B, combined 2 B;
// O(n^(2/3)) scratch, for a band one bit per voxel more. Bitwise the same for any number of threads and any SIMD
// width.
#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/type_precision.hpp>

#include "distance_extent.h"
#include "godunov/surface_start.h"
#include "grid.h"
#include "octants.h"

namespace isolume {

enum class VisibilityStorage {
  none,      ///< distance alone
  rgba8,     ///< two RGBA8 grids, as the shader reads them: octant s in channel s % 4 of grid s / 4; 15 bits on the way
  float32,   ///< eight float grids, for analysis and export
  combined,  ///< one grid of sum I_s V_s / sum I_s: the geometry term is dropped ([Singh10] Sec. 3, Fig. 6)
};

/// I_s, the light from each octant of kOctants: finite, >= 0, not all 0.
using OctantIntensities = std::array<float, kOctantCount>;
inline constexpr OctantIntensities kEvenOctants{1, 1, 1, 1, 1, 1, 1, 1};

enum class DistanceSolver {
  godunov,  ///< the sweeps above: the paper's, first order
  closest,  ///< closest points on the interpolant (closest/closest_distance.h): exact next to the surface
};

struct SweepOptions {
  VisibilityStorage visibility = VisibilityStorage::rgba8;
  /// Alpha of [Singh10] Eq. 8, [0, 1]: tau = 1 - (1 - tau of Eq. 7) alpha, so that a voxel of solid lets 1 - alpha of
  /// the light through. At 1 bit for bit Eq. 7 alone, at 0 V = 1 exactly. The distance does not depend on it.
  float opacity = 1;
  OctantIntensities intensities = kEvenOctants;  ///< combined only
  DistanceSolver solver = DistanceSolver::godunov;
  DistanceStart start = DistanceStart::better;  ///< godunov: the samples next to the surface
  /// godunov: largest number of rounds of eight distance sweeps, >= 1; the paper's is 1. Later rounds sweep only what
  /// may change and stop when nothing has.
  int rounds = 1;
  /// band: |D| = min(K, the |D| of `full`) in smallest spacings, bit for bit, K = max(k + 1, the largest spacing), k =
  /// bandVoxels >= 0. So D is that of the whole domain within k voxels and more, and next to the surface at any
  /// spacing, and a lower bound of it beyond. (closest: closest/closest_distance.h.) Costs time where the band
  /// is: of ball, torus and gyroid at 250^3 2, 2 and 10 % of the samples are below the bound with k = 1 (4, 3 and 19 %
  /// with 3), and 9, 8 and 37 % lie in spans that reach it (13, 12 and 43 %), which godunov sweeps eight times. Of the
  /// whole domain's time, k = 1 takes .29 to .36, .25 to .30 and .54 to .63, the start values alone .14 to .16, .13 to
  /// .15 and .18 to .23.
  DistanceExtent extent = DistanceExtent::full;
  int bandVoxels = kBandVoxels;  ///< of a band
};

struct OctantVisibility {
  std::array<Grid<glm::u8vec4>, 2> packed;        ///< rgba8: V_s = channel / 255, within half a step and .001
  std::array<Grid<float>, kOctantCount> octants;  ///< float32
  Grid<std::uint16_t> combined;                   ///< combined: 65535 sum, within 12
};

struct SweptFields {
  Grid<float> distance;
  OctantVisibility visibility;
};

/// `level` as of makeLevel(): > 0 inside, finite everywhere.
SweptFields sweepOcclusion(GridView<const float> level, const SweepOptions& options = {});

/// The visibility alone, through given distances (world units, < 0 inside; +-inf where there is no surface): the same
/// eight sweeps with every distance fixed. Opacity and intensities as in SweepOptions.
OctantVisibility sweepVisibility(GridView<const float> distance, VisibilityStorage storage, float opacity = 1,
                                 const OctantIntensities& intensities = kEvenOctants);

/// Rounds eight float octants to the two RGBA8 grids of the shader.
std::array<Grid<glm::u8vec4>, 2> packOctants(const std::array<Grid<float>, kOctantCount>& octants);

}  // namespace isolume
