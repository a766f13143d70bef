// The sweep of light alone through given distances: two octants at a time, as distance_sweeper.h, and nothing else
// stored.
#pragma once

#include <array>
#include <vector>

#include "grid.h"
#include "sweep_tile.h"
#include "tile_handover.h"
#include "visibility_target.h"
#include "wavefront.h"

namespace isolume {

class LightSweeper {
 public:
  /// Distances in world units, < 0 inside, +-inf where there is no surface. Opacity of [Singh10] Eq. 8.
  explicit LightSweeper(GridView<const float> distance, float opacity = 1);

  /// Octants 2 * pair and 2 * pair + 1, each if its target is wanted. Bitwise the same for any number of threads. A
  /// single octant may be written in place of the distance.
  void sweepPair(int pair, std::array<VisibilityTarget, 2> targets);

 private:
  GridView<const float> distance_;
  SweepMetric metric_;
  TileGrid tiles_;
  std::array<std::vector<BlockBuffers>, 2> blocks_;
};

}  // namespace isolume
