#include "light_sweeper.h"

#include <algorithm>

#include "light_tile.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr int kOctantsOfWalk = kOctantCount / 2;

}  // namespace

LightSweeper::LightSweeper(GridView<const float> distance, float opacity)
    : distance_(distance), metric_(makeSweepMetric(distance.spacing, opacity)), tiles_(makeTileGrid(distance.size)) {}

LightSweeper::Walk LightSweeper::makeWalk(int firstOctant, OctantSet wanted) const {
  const std::size_t tile = tileFloats(tiles_.size.x, tiles_.lanes);
  const std::size_t rows = rowFloats(tiles_.size.x, tiles_.lanes);
  Walk walk;
  walk.firstOctant = firstOctant;
  walk.layers.resize(static_cast<std::size_t>(std::clamp(threadCount() / 2, 1, tiles_.layers)));
  for (LayerBuffers& layer : walk.layers) {
    layer.distance = makeFilled(tile, kOutsideDistance);
    layer.visibility = makeFilled(tile, 1);
    for (auto& row : layer.row) row = makeFilled(rows, 1);
  }
  for (std::size_t k = 0; k < walk.carried.size(); ++k)
    for (int block = 0; wanted[static_cast<std::size_t>(firstOctant) + k] && block < tiles_.blocks; ++block)
      walk.carried[k].push_back(makeFilled(carriedFloats(tiles_.size.x, tiles_.lanes), 1));
  return walk;
}

void LightSweeper::sweepTile(Walk& walk, LayerBuffers& layer, const Tile& tile, std::size_t octantOfWalk,
                             const std::function<void(const LitTile&)>& store) const {
  const int octantIndex = walk.firstOctant + static_cast<int>(octantOfWalk);
  const Octant& octant = kOctants[static_cast<std::size_t>(octantIndex)];
  LargeArray<float>& row = layer.row[octantOfWalk];
  if (tile.blockOrder == 0) std::fill_n(row.get(), rowFloats(tiles_.size.x, tiles_.lanes), 1.0F);
  LightBuffers buffers;
  buffers.distance = layer.distance.get();
  buffers.visibility = layer.visibility.get();
  buffers.carriedLight = walk.carried[octantOfWalk][static_cast<std::size_t>(tile.block)].get();
  buffers.rowLight = row.get();
  buffers.lastRowLight = row.get();
  const LitTile lit{octantIndex, walkOctant(tiles_.size, octant), tiles_.origin(tile, octant), buffers.visibility};
  loadTile(lit.walk, lit.origin, {0, tiles_.size.x}, distance_.data, layer.distance.get());
  sweepLightTile(buffers, metric_, static_cast<float>(smallestSpacing(distance_.spacing)), tiles_.size.x);
  store(lit);
}

void LightSweeper::sweepLayers(Walk& walk, OctantSet wanted, const std::function<void(const LitTile&)>& store) const {
  const bool up = kOctants[static_cast<std::size_t>(walk.firstOctant)].sweep.z > 0;
  // Blocks in y up and down again.
  const int turns = 2 * tiles_.blocks;
  const auto sweepTurn = [&](int layerOrder, LayerBuffers& layer, int turn) {
    const bool back = turn >= tiles_.blocks;
    Tile tile;
    tile.block = back ? turns - 1 - turn : turn;
    tile.blockOrder = back ? turn - tiles_.blocks : turn;
    tile.layer = up ? layerOrder : tiles_.layers - 1 - layerOrder;
    tile.layerOrder = layerOrder;
    for (std::size_t k = back ? 2 : 0; k < (back ? 4U : 2U); ++k)
      if (wanted[static_cast<std::size_t>(walk.firstOctant) + k]) sweepTile(walk, layer, tile, k, store);
  };
  const int atOnce = static_cast<int>(walk.layers.size());
  for (int from = 0; from < tiles_.layers; from += atOnce) {
    const int count = std::min(atOnce, tiles_.layers - from);
    for (int diagonal = 0; diagonal < turns + count - 1; ++diagonal) {
      const int begin = std::max(0, diagonal - turns + 1), end = std::min(diagonal + 1, count);
      parallelFor(static_cast<std::size_t>(end - begin), [&](std::size_t i) {
        const int layer = begin + static_cast<int>(i);
        sweepTurn(from + layer, walk.layers[static_cast<std::size_t>(layer)], diagonal - layer);
      });
    }
  }
}

void LightSweeper::sweep(OctantSet wanted, const std::function<void(const LitTile&)>& store) {
  std::array<Walk, 2> walks{makeWalk(0, wanted), makeWalk(kOctantsOfWalk, wanted)};
  parallelFor(walks.size(), [&](std::size_t w) { sweepLayers(walks[w], wanted, store); });
}

}  // namespace isolume
