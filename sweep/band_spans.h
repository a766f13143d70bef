// Which parts of a grid a band of distances can reach, for sweeping nothing else.
//
// The grid is cut into cells of 8 x 4 x 4 samples. An update is never below the smallest upwind value by more than
// delta = 1 / sqrt(sum 1 / h_i^2) added to it, so a value below K hangs on a start value by a chain of at most K /
// delta neighbours: cells that hold a fixed sample, grown by so many samples along each axis, hold all values below K.
// One byte per cell. Deterministic.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "wavefront.h"

namespace isolume {

class BandCells {
 public:
  static constexpr glm::ivec3 kCell{8, 4, kTilePlanes};

  explicit BandCells(glm::ivec3 size);

  /// Notes the fixed samples of a row. Rows of different layers of cells may be marked at once.
  void markRow(int y, int z, const float* row);
  /// To all values below `bound`; spacing in units of the smallest.
  void grow(glm::dvec3 spacing, float bound);
  /// Runs of cells along x that a tile's rows touch.
  std::vector<TileSpan> spans(const TileGrid& tiles, int block, int layer) const;
  int layers() const { return count_.z; }

 private:
  std::uint8_t* rowOf(int y, int z) { return cells_.data() + (static_cast<std::size_t>(z) * count_.y + y) * count_.x; }
  const std::uint8_t* rowOf(int y, int z) const { return const_cast<BandCells*>(this)->rowOf(y, z); }
  glm::ivec3 size_;
  glm::ivec3 count_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace isolume
