// The inner loop of openness_transport.h: one row of voxels, sixteen ordinates in SIMD lanes.
#pragma once

#include <array>

#include "scheme.h"

namespace isolume {

inline constexpr int kOrdinateGroup = 16;
using OrdinateLanes = std::array<float, kOrdinateGroup>;

/// Values stand kOrdinateGroup to a voxel, in the order of the sweep.
struct LightRow {
  int count = 0;
  const float* ramp = nullptr;                ///< tau, one for each voxel
  std::array<const float*, 4> upwind = {};    ///< leaving light from x = -1 on: this row's own, of the row before in y,
                                              ///< of that before in z, of that before in both
  float* leaving = nullptr;                   ///< from x = 0 on: upwind[0] one voxel further
  float* visibility = nullptr;                ///< out
  std::array<OrdinateLanes, 7> weights = {};  ///< by entry of UpwindWeights
  OrdinateLanes power = {};                   ///< of tau
  bool diagonals = false;                     ///< whether the four that are diagonal have any weight
  bool powers = false;                        ///< whether any power is not 1
};
void sweepLightRow(const LightRow& row);

}  // namespace isolume
