// What one tile of a wavefront hands to another, and the buffers of one block of rows (sweep_tile.h).
#pragma once

#include <algorithm>
#include <vector>

#include "large_array.h"
#include "wavefront.h"

namespace isolume {

/// `count` values, all `value`.
inline LargeArray<float> makeFilled(std::size_t count, float value) {
  LargeArray<float> array = makeLargeArray<float>(count);
  std::fill_n(array.get(), count, value);
  return array;
}

/// Distance and light at a tile's upwind faces.
struct Handover {
  LargeArray<float> distance, light;
  std::size_t count = 0;
  Handover() = default;
  explicit Handover(std::size_t count_)
      : distance(makeLargeArray<float>(count_)), light(makeLargeArray<float>(count_)), count(count_) {
    reset();
  }
  /// What lies outside the grid hands on.
  void reset() {
    std::fill_n(distance.get(), count, kOutsideDistance);
    std::fill_n(light.get(), count, 1.0F);
  }
};

/// A block's tiles along z take turns in these buffers. They hand on upwards in z by `carried`, to the next block in y
/// by `lastRow`, which is doubled because the block's next tile runs beside the reader of the last one.
struct BlockBuffers {
  LargeArray<float> distance, visibility;
  Handover carried, lastRow[2];
};

/// Floats of a tile's buffer.
inline std::size_t tileFloats(int nx, int lanes) {
  return static_cast<std::size_t>(paddedSteps(nx, lanes)) * static_cast<std::size_t>(lanes) * kTilePlanes;
}
inline std::size_t rowFloats(int nx, int lanes) { return static_cast<std::size_t>(paddedRow(nx, lanes)) * kTilePlanes; }

/// One set of buffers for each block of rows: at 256^3 about 2.5 MB, and 1.2 MB more with light.
inline std::vector<BlockBuffers> makeBlockBuffers(const TileGrid& grid, bool light) {
  const std::size_t tile = tileFloats(grid.size.x, grid.lanes);
  std::vector<BlockBuffers> blocks(static_cast<std::size_t>(grid.blocks));
  for (BlockBuffers& block : blocks) {
    block.distance = makeFilled(tile, kOutsideDistance);
    if (light) block.visibility = makeFilled(tile, 1.0F);
    block.carried = Handover(tile / kTilePlanes);
    for (Handover& row : block.lastRow) row = Handover(rowFloats(grid.size.x, grid.lanes));
  }
  return blocks;
}

}  // namespace isolume
