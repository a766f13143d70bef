// How the tiles of a grid share one sweep over the threads: wavefronts over blocks of rows (y) and layers of planes
// (z).
//
// A tile waits for the tile upwind in y and the one upwind in z ([Detrixhe13]); all tiles of an anti-diagonal run in
// parallel, which changes no result. The partition is the same for all octants: where the size is not a multiple, the
// last tile in +y (+z) has empty lanes (planes), whichever way it is swept.
#pragma once

#include <algorithm>
#include <functional>
#include <glm/vec3.hpp>

#include "sweep/octants.h"
#include "sweep_tile.h"
#include "tile_io.h"

namespace isolume {

/// One tile: its place in the grid, and when it comes in the order of the octants' sweep.
struct Tile {
  int block = 0, layer = 0;            ///< rows from block * lanes on, planes from layer * kTilePlanes on
  int blockOrder = 0, layerOrder = 0;  ///< 0 for those that the sweep meets first
};

struct TileGrid {
  glm::ivec3 size{0};
  int lanes = 1;
  int blocks = 0, layers = 0;
  std::size_t count() const { return static_cast<std::size_t>(blocks) * static_cast<std::size_t>(layers); }
  std::size_t index(int block, int layer) const {
    return static_cast<std::size_t>(layer) * static_cast<std::size_t>(blocks) + static_cast<std::size_t>(block);
  }
  /// Calls visit(y, z) for the rows of the grid that a tile holds.
  template <class Visit>
  void forEachRow(int block, int layer, const Visit& visit) const {
    const int firstY = block * lanes, firstZ = layer * kTilePlanes;
    for (int z = firstZ; z < std::min(firstZ + kTilePlanes, size.z); ++z)
      for (int y = firstY; y < std::min(firstY + lanes, size.y); ++y) visit(y, z);
  }
  /// First canonical row and plane of a tile; below 0 where the first lanes or planes are empty.
  TileOrigin origin(const Tile& tile, const Octant& octant) const;
};
TileGrid makeTileGrid(glm::ivec3 size);

/// Calls body(tile) for all tiles, upwind ones of octants with these signs in y and z first. Threaded.
void sweepWavefront(const TileGrid& grid, const Octant& octant, const std::function<void(const Tile&)>& body);

}  // namespace isolume
