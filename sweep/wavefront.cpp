#include "wavefront.h"

#include <algorithm>
#include <vector>

#include "large_array.h"
#include "parallel.h"
#include "surface_start.h"
#include "tile_io.h"

namespace isolume {
namespace {

template <class T>
LargeArray<T> makeFilled(std::size_t count, T value) {
  LargeArray<T> array = makeLargeArray<T>(count);
  std::fill_n(array.get(), count, value);
  return array;
}

// Distance and light that one tile hands to another.
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

int blocksOf(int count, int size) { return (count + size - 1) / size; }

}  // namespace

// What the tiles of one block of rows hand on: upwards in z by `carried`, to the next block in y by `lastRow`, which is
// doubled because the block's next tile runs beside the reader of the last one.
struct WavefrontSweeper::Block {
  LargeArray<float> distance;
  LargeArray<float> visibility;
  Handover carried;
  Handover lastRow[2];
};

struct WavefrontSweeper::Storage {
  std::vector<Block> blocks;
  Handover outsideRow;
  std::size_t tileCount = 0;
};

WavefrontSweeper::WavefrontSweeper(glm::ivec3 size, const SweepMetric& metric)
    : storage_(std::make_unique<Storage>()), size_(size), metric_(metric) {
  const int lanes = tileLanes();
  const auto steps = static_cast<std::size_t>(paddedSteps(size.x, lanes)) * static_cast<std::size_t>(lanes);
  const auto rows = static_cast<std::size_t>(paddedRow(size.x, lanes)) * kTilePlanes;
  storage_->tileCount = steps * kTilePlanes;
  storage_->outsideRow = Handover(rows);
  storage_->blocks.resize(static_cast<std::size_t>(blocksOf(size.y, lanes)));
  for (Block& block : storage_->blocks) {
    block.distance = makeFilled(storage_->tileCount, kOutsideDistance);
    block.carried = Handover(steps);
    for (Handover& row : block.lastRow) row = Handover(rows);
  }
}

WavefrontSweeper::~WavefrontSweeper() = default;

void WavefrontSweeper::sweep(const Octant& octant, float* distance, VisibilityTarget visibility) {
  const OctantWalk walk = walkOctant(size_, octant);
  const int lanes = tileLanes();
  const int blockCount = blocksOf(size_.y, lanes);
  const int layerCount = blocksOf(size_.z, kTilePlanes);
  const bool light = visibility.as8 != nullptr || visibility.asFloat != nullptr;
  for (Block& block : storage_->blocks) {
    block.carried.reset();
    if (light && !block.visibility) block.visibility = makeFilled(storage_->tileCount, 0.0F);
  }

  const auto sweepOne = [&](int blockIndex, int layer) {
    Block& block = storage_->blocks[static_cast<std::size_t>(blockIndex)];
    const int parity = layer % 2;
    const Handover& below = blockIndex > 0 ? storage_->blocks[static_cast<std::size_t>(blockIndex) - 1].lastRow[parity]
                                           : storage_->outsideRow;
    const TileOrigin origin{blockIndex * lanes, layer * kTilePlanes};
    TileBuffers buffers;
    buffers.distance = block.distance.get();
    buffers.visibility = light ? block.visibility.get() : nullptr;
    buffers.carriedDistance = block.carried.distance.get();
    buffers.carriedLight = block.carried.light.get();
    buffers.rowDistance = below.distance.get();
    buffers.rowLight = below.light.get();
    buffers.lastRowDistance = block.lastRow[parity].distance.get();
    buffers.lastRowLight = block.lastRow[parity].light.get();
    loadTile(walk, origin, distance, buffers.distance);
    buffers.rowLength = size_.x;
    if (sweepTile(buffers, metric_, {0, size_.x})) storeTile(walk, origin, buffers.distance, distance);
    if (visibility.as8) storeTile(walk, origin, buffers.visibility, visibility.as8);
    if (visibility.asFloat) storeTile(walk, origin, buffers.visibility, visibility.asFloat);
  };

  for (int diagonal = 0; diagonal < blockCount + layerCount - 1; ++diagonal) {
    const int first = std::max(0, diagonal - layerCount + 1);
    const int last = std::min(diagonal, blockCount - 1);
    parallelFor(static_cast<std::size_t>(last - first + 1), [&](std::size_t i) {
      const int blockIndex = first + static_cast<int>(i);
      sweepOne(blockIndex, diagonal - blockIndex);
    });
  }
}

}  // namespace isolume
