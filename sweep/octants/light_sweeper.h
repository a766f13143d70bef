// The sweep of light through given distances: [Singh10] Eq. 6 to 8 for all octants, layer by layer.
//
// The four octants that run the same way in z share a walk: a layer of kTilePlanes planes is swept by the two that run
// up in y, block of rows after block, and then by the two that run down again, so that its distances stay in the
// cache until all four have passed. The two walks, up and down in z, need nothing of each other and run beside each
// other. On more than two threads each walk takes several layers at a time, in a wavefront ([Detrixhe13]).
//
// Bitwise the same for any number of threads and any SIMD width. Memory: O(n^(2/3)), about 40 bytes per voxel of a
// plane.
#pragma once

#include <array>
#include <bitset>
#include <functional>
#include <vector>

#include "sweep/godunov/tile_handover.h"
#include "sweep/godunov/tile_io.h"
#include "sweep/godunov/wavefront.h"
#include "sweep/grid.h"

namespace isolume {

/// V of one octant in one tile, in the layout of sweep_tile.h.
struct LitTile {
  int octant = 0;
  OctantWalk walk;
  TileOrigin origin;
  const float* visibility = nullptr;
};

using OctantSet = std::bitset<kOctantCount>;

class LightSweeper {
 public:
  /// Distances in world units, < 0 inside, +-inf where there is no surface. Opacity of [Singh10] Eq. 8.
  explicit LightSweeper(GridView<const float> distance, float opacity = 1);

  /// Calls store(tile) once for each tile of each wanted octant, from several threads, two octants of the same tile at
  /// a time among them. A single octant may be written in place of the distance.
  void sweep(OctantSet wanted, const std::function<void(const LitTile&)>& store);

 private:
  // What a layer at work needs: a tile, and what the tile before hands on in y, of each octant.
  struct LayerBuffers {
    LargeArray<float> distance, visibility;
    std::array<LargeArray<float>, kOctantCount / 2> row;
  };
  // The walk up (down) in z, and what the layer before handed on, of each octant and block.
  struct Walk {
    int firstOctant = 0;
    std::vector<LayerBuffers> layers;
    std::array<std::vector<LargeArray<float>>, kOctantCount / 2> carried;
  };
  Walk makeWalk(int firstOctant, OctantSet wanted) const;
  void sweepLayers(Walk& walk, OctantSet wanted, const std::function<void(const LitTile&)>& store) const;
  void sweepTile(Walk& walk, LayerBuffers& layer, const Tile& tile, std::size_t octantOfWalk,
                 const std::function<void(const LitTile&)>& store) const;

  GridView<const float> distance_;
  SweepMetric metric_;
  TileGrid tiles_;
};

}  // namespace isolume
