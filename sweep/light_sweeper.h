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
  /// Distances in world units, < 0 inside, +-inf where there is no surface.
  explicit LightSweeper(GridView<const float> distance);

  /// Octants 2 * pair and 2 * pair + 1. Bitwise the same for any number of threads.
  void sweepPair(int pair, std::array<VisibilityTarget, 2> targets);

 private:
  GridView<const float> distance_;
  SweepMetric metric_;
  TileGrid tiles_;
  std::array<std::vector<BlockBuffers>, 2> blocks_;
};

}  // namespace isolume
