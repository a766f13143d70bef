// How parallel rays move from one layer of a lattice to the next (sheared_rays.h has the geometry).
#pragma once

#include <array>
#include <cmath>

#include "sheared_rays.h"

namespace isolume {

inline constexpr int kMostSkipped = 3;                ///< layers that a reading may go on
inline constexpr int kKeptLayers = kMostSkipped + 1;  ///< so many are kept
/// Of a normal's parts within a layer, squared: where they are less, nothing needs to be lifted.
inline constexpr float kSmallestSquare = 1e-30F;
/// A number for each of the layers that a reading may be of. Aligned for vectors that hold it once or several times.
template <class T>
struct alignas(16) PerSkip : std::array<T, kMostSkipped + 1> {};
/// Where a layer is kept; layers from -kKeptLayers on.
inline int slotOf(int layer) { return (layer + kKeptLayers) % kKeptLayers; }

inline int roundedOffset(double slope, int layer) { return static_cast<int>(std::floor(slope * layer + 0.5)); }

// How one direction's rays enter a layer, how far the true rays are from where the rounding puts them, and where they
// are one, two and three layers on.
struct RayStep {
  int shiftBit = 0, shiftRow = 0;
  float lagBit = 0, lagRow = 0;
  float slopeBit = 0, slopeRow = 0;
  PerSkip<float> onBit{}, onRow{};
};
inline RayStep stepInto(int layer, int towards, const RayDirection& direction) {
  RayStep step;
  const int bit = roundedOffset(direction.slopeBit, layer), row = roundedOffset(direction.slopeRow, layer);
  for (int j = 0; j <= kMostSkipped; ++j) {
    const auto i = static_cast<std::size_t>(j);
    step.onBit[i] = static_cast<float>(roundedOffset(direction.slopeBit, layer + towards * j) - bit);
    step.onRow[i] = static_cast<float>(roundedOffset(direction.slopeRow, layer + towards * j) - row);
  }
  step.slopeBit = static_cast<float>(direction.slopeBit);
  step.slopeRow = static_cast<float>(direction.slopeRow);
  step.shiftBit = static_cast<int>(step.onBit[1]);
  step.shiftRow = static_cast<int>(step.onRow[1]);
  step.lagBit = static_cast<float>(direction.slopeBit * layer - bit);
  step.lagRow = static_cast<float>(direction.slopeRow * layer - row);
  return step;
}

}  // namespace isolume
