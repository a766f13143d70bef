// The buffers of one block of rows (sweep_tile.h), and what one tile of a wavefront hands to another.
#pragma once

#include <algorithm>
#include <vector>

#include "sweep/large_array.h"
#include "wavefront.h"

namespace isolume {

/// `count` values, all `value`.
inline LargeArray<float> makeFilled(std::size_t count, float value) {
  LargeArray<float> array = makeLargeArray<float>(count);
  std::fill_n(array.get(), count, value);
  return array;
}

/// Floats of what a tile hands on in z, of its own buffer, and of what it hands on in y.
inline std::size_t carriedFloats(int nx, int lanes) {
  return static_cast<std::size_t>(paddedSteps(nx, lanes)) * static_cast<std::size_t>(lanes);
}
inline std::size_t tileFloats(int nx, int lanes) { return carriedFloats(nx, lanes) * kTilePlanes; }
inline std::size_t rowFloats(int nx, int lanes) { return static_cast<std::size_t>(paddedRow(nx, lanes)) * kTilePlanes; }

/// A block's tiles along z take turns in these buffers. They hand distances on upwards in z by `carried`, to the next
/// block in y by `lastRow`, which is doubled because the block's next tile runs beside the reader of the last one.
struct BlockBuffers {
  LargeArray<float> distance, carried, lastRow[2];
};

/// One set of buffers for each block of rows, all outside: at 256^3 about 1.7 MB.
inline std::vector<BlockBuffers> makeBlockBuffers(const TileGrid& grid) {
  const std::size_t tile = tileFloats(grid.size.x, grid.lanes);
  std::vector<BlockBuffers> blocks(static_cast<std::size_t>(grid.blocks));
  for (BlockBuffers& block : blocks) {
    block.distance = makeFilled(tile, kOutsideDistance);
    block.carried = makeFilled(carriedFloats(grid.size.x, grid.lanes), kOutsideDistance);
    for (auto& row : block.lastRow) row = makeFilled(rowFloats(grid.size.x, grid.lanes), kOutsideDistance);
  }
  return blocks;
}

}  // namespace isolume
