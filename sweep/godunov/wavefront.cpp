#include "wavefront.h"

#include <algorithm>

#include "sweep/parallel.h"

namespace isolume {

TileOrigin TileGrid::origin(const Tile& tile, const Octant& octant) const {
  return {octant.sweep.y > 0 ? tile.block * lanes : size.y - (tile.block + 1) * lanes,
          octant.sweep.z > 0 ? tile.layer * kTilePlanes : size.z - (tile.layer + 1) * kTilePlanes};
}

TileGrid makeTileGrid(glm::ivec3 size) {
  TileGrid grid;
  grid.size = size;
  grid.lanes = tileLanes();
  grid.blocks = (size.y + grid.lanes - 1) / grid.lanes;
  grid.layers = (size.z + kTilePlanes - 1) / kTilePlanes;
  return grid;
}

void sweepWavefront(const TileGrid& grid, const Octant& octant, const std::function<void(const Tile&)>& body) {
  for (int diagonal = 0; diagonal < grid.blocks + grid.layers - 1; ++diagonal) {
    const int first = std::max(0, diagonal - grid.layers + 1);
    const int last = std::min(diagonal, grid.blocks - 1);
    parallelFor(static_cast<std::size_t>(last - first + 1), [&](std::size_t i) {
      Tile tile;
      tile.blockOrder = first + static_cast<int>(i);
      tile.layerOrder = diagonal - tile.blockOrder;
      tile.block = octant.sweep.y > 0 ? tile.blockOrder : grid.blocks - 1 - tile.blockOrder;
      tile.layer = octant.sweep.z > 0 ? tile.layerOrder : grid.layers - 1 - tile.layerOrder;
      body(tile);
    });
  }
}

}  // namespace isolume
