// The eight distance sweeps over a whole grid, tile by tile.
//
// The first round takes two octants at a time that differ in the sign of x alone: a tile is swept one way and then the
// other while it is in the cache, with each octant's own values handed from tile to tile, so the result is that of two
// sweeps one after the other and the grid passes through memory half as often. Later rounds sweep a tile in an octant
// only if it, or a tile upwind of it, has changed since it was last swept in that octant; else nothing can change.
//
// In place; values as of startDistance(). Bitwise the same for any number of threads. Memory: O(n^(2/3)).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "sweep/grid.h"
#include "sweep_tile.h"
#include "tile_handover.h"
#include "wavefront.h"

namespace isolume {

/// Called for each row (y, z) of the grid once: before the first sweep sees it, or after the last.
using RowHook = std::function<void(int y, int z)>;

class DistanceSweeper {
 public:
  DistanceSweeper(GridView<float> distance, const SweepMetric& metric);

  /// Octants 2 * pair and 2 * pair + 1.
  void sweepPair(int pair, const RowHook& before, const RowHook& after);

  /// Sweeps all octants where something may change; false if nothing has changed. `spans`: for each tile (TileGrid
  /// index) the parts of its rows that may change at all, in x of the grid; nullptr: the whole rows.
  bool sweepRound(const std::vector<std::vector<TileSpan>>* spans = nullptr);

  const TileGrid& tiles() const { return tiles_; }

 private:
  bool sweepTileAlone(const Octant& octant, const Tile& tile, BlockBuffers& buffers, TileSpan span);

  GridView<float> distance_;
  SweepMetric metric_;
  TileGrid tiles_;
  std::array<std::vector<BlockBuffers>, 2> blocks_;
  // Number of the sweep in which a tile last changed, and in which it was last swept in an octant.
  std::uint32_t sweep_ = 0;
  std::vector<std::uint32_t> changed_;
  std::array<std::vector<std::uint32_t>, kOctantCount> swept_;
};

}  // namespace isolume
