#include "distance_sweeper.h"

#include <algorithm>

#include "tile_io.h"

namespace isolume {

DistanceSweeper::DistanceSweeper(GridView<float> distance, const SweepMetric& metric)
    : distance_(distance), metric_(metric), tiles_(makeTileGrid(distance.size)) {
  changed_.assign(tiles_.count(), 1);
  for (auto& swept : swept_) swept.assign(tiles_.count(), 0);
  sweep_ = 1;
}

void DistanceSweeper::sweepPair(int pair, const RowHook& before, const RowHook& after) {
  const int nx = tiles_.size.x;
  const TileSpan whole{0, nx};
  const LargeArray<float> outside = makeFilled(rowFloats(nx, tiles_.lanes), kOutsideDistance);
  for (auto& blocks : blocks_) {
    if (blocks.empty()) blocks = makeBlockBuffers(tiles_);
    for (BlockBuffers& block : blocks)
      std::fill_n(block.carried.get(), carriedFloats(nx, tiles_.lanes), kOutsideDistance);
  }
  const auto firstOctant = static_cast<std::size_t>(2 * pair);

  sweepWavefront(tiles_, kOctants[firstOctant], [&](const Tile& tile) {
    if (before) tiles_.forEachRow(tile.block, tile.layer, before);
    const std::size_t index = tiles_.index(tile.block, tile.layer);
    for (std::size_t k = 0; k < 2; ++k) {
      const Octant& octant = kOctants[firstOctant + k];
      const OctantWalk walk = walkOctant(tiles_.size, octant);
      const TileOrigin origin = tiles_.origin(tile, octant);
      const auto order = static_cast<std::size_t>(tile.blockOrder);
      const int parity = tile.layerOrder % 2;
      BlockBuffers& block = blocks_[k][order];
      const LargeArray<float>& below = order > 0 ? blocks_[k][order - 1].lastRow[parity] : outside;
      TileBuffers buffers;
      buffers.rowLength = nx;
      buffers.distance = block.distance.get();
      buffers.carried = block.carried.get();
      buffers.row = below.get();
      buffers.lastRow = block.lastRow[parity].get();
      loadTile(walk, origin, whole, distance_.data, buffers.distance);
      const std::uint32_t number = sweep_ + 1 + static_cast<std::uint32_t>(k);
      if (sweepTile(buffers, metric_, whole)) {
        storeTile(walk, origin, whole, buffers.distance, distance_.data);
        changed_[index] = number;
      }
      swept_[firstOctant + k][index] = number;
    }
    if (after) tiles_.forEachRow(tile.block, tile.layer, after);
  });
  sweep_ += 2;
}

bool DistanceSweeper::sweepTileAlone(const Octant& octant, const Tile& tile, BlockBuffers& block, TileSpan span) {
  const OctantWalk walk = walkOctant(tiles_.size, octant);
  const TileOrigin origin = tiles_.origin(tile, octant);
  if (octant.sweep.x < 0) span.first = tiles_.size.x - span.first - span.count;
  TileBuffers buffers;
  buffers.rowLength = tiles_.size.x;
  buffers.distance = block.distance.get();
  buffers.carried = block.carried.get();
  buffers.row = block.lastRow[0].get();
  buffers.lastRow = block.lastRow[1].get();
  loadTile(walk, origin, span, distance_.data, buffers.distance);
  loadCarried(walk, origin, span, distance_.data, buffers.carried);
  loadRowBelow(walk, origin, span, distance_.data, block.lastRow[0].get());
  if (!sweepTile(buffers, metric_, span)) return false;
  storeTile(walk, origin, span, buffers.distance, distance_.data);
  return true;
}

bool DistanceSweeper::sweepRound(const std::vector<std::vector<TileSpan>>* spans) {
  if (blocks_[0].empty()) blocks_[0] = makeBlockBuffers(tiles_);
  const std::uint32_t before = sweep_;
  for (std::size_t s = 0; s < kOctants.size(); ++s) {
    const Octant& octant = kOctants[s];
    const std::uint32_t number = ++sweep_;
    sweepWavefront(tiles_, octant, [&](const Tile& tile) {
      const std::size_t index = tiles_.index(tile.block, tile.layer);
      std::uint32_t latest = changed_[index];
      if (tile.blockOrder > 0)
        latest = std::max(latest, changed_[tiles_.index(tile.block - octant.sweep.y, tile.layer)]);
      if (tile.layerOrder > 0)
        latest = std::max(latest, changed_[tiles_.index(tile.block, tile.layer - octant.sweep.z)]);
      if (latest <= swept_[s][index]) return;
      BlockBuffers& block = blocks_[0][static_cast<std::size_t>(tile.blockOrder)];
      bool changed = false;
      if (spans == nullptr) {
        changed = sweepTileAlone(octant, tile, block, {0, tiles_.size.x});
      } else {
        for (const TileSpan& span : (*spans)[index]) changed |= sweepTileAlone(octant, tile, block, span);
      }
      if (changed) changed_[index] = number;
      swept_[s][index] = number;
    });
  }
  return std::any_of(changed_.begin(), changed_.end(), [&](std::uint32_t number) { return number > before; });
}

}  // namespace isolume
