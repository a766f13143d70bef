// Parallel rays of one direction through a lattice of bits, all at once: one bit per ray, up to 512 rays per
// instruction.
//
// Take a direction w and the axis m along which it crosses most layers, so that from layer to layer a ray moves by
// slopes |s| <= 1 along the other two axes b (bits) and r (rows). In layer k the ray with number (u, v) passes
// (u + s_b k, v + s_r k), and meets the lattice point to which that rounds: offset o(k) = floor(s k + 1/2), the same
// for all rays. So with B_k(x) = whether anything is met from point x of layer k on, towards the light,
//   B_k(x) = S_k(x) or B_k'(x + o(k') - o(k)),   k' = the layer before k in the order of the sweep,
// which is a shift by at most one bit and one row, an OR and nothing else. Beyond the lattice all is open.
// A point q between two layers takes the ray that passes closest to it in the next layer towards the light. It strays
// from the true one by at most one lattice point along each of the two axes: half by the choice of the ray, half by its
// rounding. So a plane through q, whose lattice points form steps, may block rays that truly leave it, until the ray is
// higher over the plane than one step along both axes, |N_b| c_b + |N_r| c_r with the cell c (kClearance of it: layers
// are met where they are, so N_layer adds nothing). What is met before is not asked for: B is read up to three layers
// on, and what a ray is still too low then, it is lifted by, within the layer along the plane's steepest way: by at
// most sqrt(2) points. So a plane never darkens itself, and light almost along a surface passes what is next to it and
// thinner than three points (docs/occlusion-study.md compares rules).
//
// Cost: per vector of lattice points and ordinate three loads, two shifts, an OR, an AND and a store; per point and
// ordinate that faces it a gathered word and some forty operations, in SIMD lanes of points. State: four layers of
// bits per ordinate at work.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ray_points.h"
#include "solid_lattice.h"

namespace isolume {

/// Bits of a layer, rows rounded up and with kMostBeyond rows more, must be fewer: then rows and columns are below
/// 2^22, up to which floats are rounded by an addition, and four layers have fewer than 2^31.
inline constexpr std::size_t kMostLayerBits = std::size_t{1} << 24;
inline constexpr int kMostBeyond = 8;

/// The lattice's bits as rays along one axis read them.
struct LatticeLayers {
  const std::uint64_t* data = nullptr;
  int length = 0, rows = 0, layers = 0, words = 0;
  std::ptrdiff_t rowStride = 0, layerStride = 0;  ///< words
  float cellBit = 1, cellRow = 1, cellLayer = 1;  ///< distance between points, world units
};
LatticeLayers layersOf(const SolidLattice& lattice, glm::dvec3 spacing, int axis);

inline constexpr std::size_t kMostChannels = 4;

/// One direction towards the light, its components in the order of the axes.
struct RayDirection {
  float weightBit = 0, weightRow = 0, weightLayer = 0;  ///< unit vector, world units: what N is multiplied with
  double slopeBit = 0, slopeRow = 0;                    ///< lattice points per layer
  float risePerCosine = 0;  ///< how much a ray rises over a plane from layer to layer, world units, per N . w
  std::array<float, kMostChannels> value{1};  ///< what it counts, by channel
};

/// Where sums over directions go: for point i and channel c, round(scale * sum of value[c] max(N . w, 0) over those
/// that meet something, or with `visible` over those that do not) is added to sums[c * stride + i]. One or three
/// channels; with four there is no cosine: the sum is that of value[c] over those that face the point. `stride` is at
/// least the number of points and kRayPadding.
struct RayTally {
  int channels = 1;
  bool visible = false;
  float scale = 1;
  std::ptrdiff_t stride = 0;
  std::int32_t* sums = nullptr;
};

inline constexpr int kRayGroup = 16;  ///< directions that are swept at a time, at most
/// As many as should be: 8 to kRayGroup, so that what is kept of each stays in a second cache of 2 MiB. 12 in place of
/// 16 save a tenth where layers have 512^2 points.
int raysAtATime(const LatticeLayers& lattice);
/// Sweeps up to kRayGroup directions with w_layer > 0 (towards = 1) or < 0 (-1) and adds up what each point loses, or
/// keeps.
void sweepRays(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
               const RayPoints& points, const RayTally& tally);

}  // namespace isolume
