// The inner loop of light in 15 bits by ordinates (fixed_transport.h): one plane of a strip of kStripRows rows, the
// ordinates of a group in SIMD lanes.
//
// Numbers are those of fixed_light.h: V of [0, kFullLight], N = -V tau of what leaves a voxel, R the rounded product.
// With N_i of the six neighbours upwind that do not lie straight below, c_i = N_i - (N_z + e),
//   V = max(0, -N_z + sum_i R(-w_i c_i)),  N = R(V (-tau)),
// e 0, 1, -1 in turn with x + y + z, and 0 for ordinates with some w_i of 1/2 or more. Open space stays full and the
// dark dark, exactly, and what can only be the one or the other, kSegment steps of a strip, is passed over.
//
// Rows are skewed: step t holds x = t - r of row r, so that all that a step needs of its own plane was computed in the
// two steps before and stands in registers, and the rows of a step need nothing of each other.
//
// Counts along the sweep: x = 0 is the first voxel that light meets. What lies before the first voxel of a row is open;
// what lies beyond the last is never read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sweep/octants/fixed_light.h"

namespace isolume {

inline constexpr int kStripRows = 4;
/// Values that rows are longer at both ends: what their steps reach, and whole segments are tested.
inline constexpr int kRowMargin = kStripRows - 1 + kSegment;
/// Neighbours upwind but for that below: entries 0, 1, 2, 4, 5, 6 of UpwindWeights.
inline constexpr int kBesideCount = 6;
/// A power of tau is looked up by its tau in so many steps.
inline constexpr int kPowerSteps = 1024;

/// Lanes of the widest groups on this machine, a power of 2; a group has as many or, from kLeastHalved on, half of
/// them.
int ordinateLanes();
inline constexpr int kLeastHalved = 32;

/// What the ordinates of a group have of their own. Each number kept lane by lane.
struct StripOrdinates {
  int lanes = 0;
  bool diagonals = false;                 ///< whether neighbours 2 to 5 have any weight
  const std::int16_t* weights = nullptr;  ///< [neighbour][lane]: -w in units of 2^-15
  const std::int16_t* dither = nullptr;   ///< [lane]: 1 where e is added, or 0
  const std::int16_t* powers = nullptr;   ///< [kPowerSteps + 1][lane]: of each step of tau, -tau^p; or null: p = 1
};

struct LightStrip {
  int count = 0;      ///< voxels of a row
  int direction = 1;  ///< from a voxel to the next one in memory of `transmittance`
  int phase = 0;      ///< y + z of the first row, >= 0
  std::array<const std::int16_t*, kStripRows> transmittance = {};  ///< -tau of x = 0; kRowMargin more at both ends
  std::int16_t* edge = nullptr;     ///< [x][lane]: N of the row before, replaced by the last row's; kStripRows - 1 more
                                    ///< at both ends
  std::int16_t* before = nullptr;   ///< as `edge`, of the plane before; with diagonals; replaced
  std::int16_t* carried = nullptr;  ///< [step][row][lane]: N of the plane before, replaced
  const std::uint8_t* wanted = nullptr;  ///< [segment]: whether its V is to be stored
  std::int16_t* visibility = nullptr;    ///< [step][row][lane]: V, out
  Content* carriedContent = nullptr;     ///< [segment]: of `carried`; even where it is known to be full or dark
  Content* visibilityContent = nullptr;  ///< [segment]: of `visibility`
};

inline int stripSteps(int count) { return count + kStripRows - 1; }
inline int stripSegments(int count) { return (stripSteps(count) + kSegment - 1) / kSegment; }

void sweepLightStrip(const LightStrip& strip, const StripOrdinates& ordinates);

}  // namespace isolume
