// Parallel rays that carry a number, where those of sheared_rays.h carry a bit: what the surface sends from where a ray
// meets it first, or how much of the solid lies on a ray's way.
//
// Geometry, rounding and the reading of points are those of sheared_rays.h, on a lattice of the samples themselves
// (refinement 1). With the state R of a ray in the layer k' before,
//   nearest:  R_k(x) = value of the lattice point if it is solid, else R_k'(x + o(k') - o(k)), 8 bits;
//   length:   R_k(x) = R_k'(x + o(k') - o(k)) + the solid share of the lattice point, 16 bits: of more than 4095 solid
//             points on a ray's way no more count.
// Beyond the lattice nothing is met. A point on the surface that looks into the solid (N . w < 0) reads the next layer
// without a lift, for `length` alone. Lengths of a ray that enters the solid at a cosine c are too short by some .2 / c
// voxels: solid shares blur the surface, and what of the blur lies outside is behind the ray.
//
// Cost: per vector of lattice points and ordinate two loads, an operation and a store of 1 or 2 bytes per point, which
// is some 8 or 16 times that of bits. State: four layers of 1 or 2 bytes per point and one of 1 byte, per direction at
// work; the layers of one direction at 512^2 points are 1 to 2 MB.
#pragma once

#include <cstdint>
#include <vector>

#include "sample_layers.h"
#include "sheared_rays.h"

namespace isolume {

/// Values of 8 bits are at most this; solid shares are whole at kSolidShare.
inline constexpr int kLargestCarried = 254, kSolidShare = 16;
/// Solid shares end that far above the surface, in units of the smallest spacing: rays must have risen so much more.
inline constexpr float kShareBlur = 0.5F;

/// What a sweep of carried rays adds up for point i, into sums[i] (int32, rounded as sheared_rays.h has it):
///   nearest  scale * sum of max(N . w, 0) R over the directions;
///   length   scale * sum of value[0] |N . w| exp(-L / meanFreePath), L in world units; and into sums[stride + i]
///            lengthScale * sum of value[0] max(-N . w, 0) L.
struct CarriedTally {
  enum class Kind { nearest, length } kind = Kind::nearest;
  float scale = 1, lengthScale = 1;
  float meanFreePath = 1;  ///< world units, > 0
  std::ptrdiff_t stride = 0;
  std::int32_t* sums = nullptr;
};

/// Sweeps directions one after the other. `values`: of the solid samples next to the surface (nearest: at most
/// kLargestCarried; length: solid shares); other solid samples have 0, or for `length` the whole.
void sweepCarriedRays(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
                      const RayPoints& points, const SampleLayers& samples, const std::vector<std::uint8_t>& values,
                      const CarriedTally& tally);

}  // namespace isolume
