// One sweep of one octant over a whole grid: tiles in wavefronts, so that threads share a sweep that is Gauss-Seidel.
#pragma once

#include <cstdint>
#include <memory>

#include "grid.h"
#include "octants.h"
#include "sweep_tile.h"

namespace isolume {

/// Where a sweep writes the octant's visibility, if it does: at most one of the two is set.
struct VisibilityTarget {
  std::uint8_t* as8 = nullptr;  ///< round(255 V), one byte per voxel
  float* asFloat = nullptr;
};

/// Buffers for sweeps of one grid size, reused from sweep to sweep. About 4 (with visibility 9) MB for 256^3;
/// O(n^(2/3)).
class WavefrontSweeper {
 public:
  WavefrontSweeper(glm::ivec3 size, const SweepMetric& metric);
  ~WavefrontSweeper();

  /// Sweeps in place; `distance` as of startDistance(). A tile waits only for the tile below it in z and the one before
  /// it in y ([Detrixhe13]); all tiles of an anti-diagonal run in parallel, which changes no result.
  void sweep(const Octant& octant, float* distance, VisibilityTarget visibility);

 private:
  struct Block;
  struct Storage;
  std::unique_ptr<Storage> storage_;
  glm::ivec3 size_;
  SweepMetric metric_;
};

}  // namespace isolume
