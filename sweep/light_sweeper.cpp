#include "light_sweeper.h"

#include <algorithm>

#include "light_tile.h"
#include "tile_io.h"

namespace isolume {

LightSweeper::LightSweeper(GridView<const float> distance, float opacity)
    : distance_(distance), metric_(makeSweepMetric(distance.spacing, opacity)), tiles_(makeTileGrid(distance.size)) {
  for (auto& blocks : blocks_) blocks = makeBlockBuffers(tiles_, true);
}

void LightSweeper::sweepPair(int pair, std::array<VisibilityTarget, 2> targets) {
  const int nx = tiles_.size.x;
  const TileSpan whole{0, nx};
  const auto smallest = static_cast<float>(smallestSpacing(distance_.spacing));
  const Handover outside(rowFloats(nx, tiles_.lanes));
  for (auto& blocks : blocks_)
    for (BlockBuffers& block : blocks) block.carried.reset();
  const auto firstOctant = static_cast<std::size_t>(2 * pair);

  sweepWavefront(tiles_, kOctants[firstOctant], [&](const Tile& tile) {
    for (std::size_t k = 0; k < 2; ++k) {
      const VisibilityTarget& target = targets[k];
      if (!target.wanted()) continue;
      const Octant& octant = kOctants[firstOctant + k];
      const OctantWalk walk = walkOctant(tiles_.size, octant);
      const TileOrigin origin = tiles_.origin(tile, octant);
      const auto order = static_cast<std::size_t>(tile.blockOrder);
      const int parity = tile.layerOrder % 2;
      BlockBuffers& block = blocks_[k][order];
      LightBuffers buffers;
      buffers.distance = block.distance.get();
      buffers.visibility = block.visibility.get();
      buffers.carriedLight = block.carried.light.get();
      buffers.rowLight = (order > 0 ? blocks_[k][order - 1].lastRow[parity] : outside).light.get();
      buffers.lastRowLight = block.lastRow[parity].light.get();
      loadTile(walk, origin, whole, distance_.data, block.distance.get());
      sweepLightTile(buffers, metric_, smallest, nx);
      if (target.as8 != nullptr) storeTile(walk, origin, whole, buffers.visibility, target.as8);
      if (target.asFloat != nullptr) storeTile(walk, origin, whole, buffers.visibility, target.asFloat);
    }
  });
}

}  // namespace isolume
