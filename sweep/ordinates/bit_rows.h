// One bit per point of a lattice, in rows that follow each other without a gap.
//
// Bit i % 64 of word i / 64 of a row. Each row ends in at least kRowEnd zeros, so that a row that is shifted by one
// takes in zeros, and a few steps beyond either end there is nothing.
#pragma once

#include <cstdint>

#include "sweep/bit_grid.h"
#include "sweep/large_array.h"

namespace isolume {

struct BitRows {
  static constexpr int kRowEnd = 7;

  LargeArray<std::uint64_t> data;
  int length = 0, rows = 0, layers = 0;  ///< points of a row, rows of a layer, layers
  int words = 0;                         ///< of a row

  BitRows() = default;
  /// Uninitialised.
  BitRows(int length_, int rows_, int layers_)
      : length(length_), rows(rows_), layers(layers_), words((length_ + kRowEnd - 1) / kWordBits + 1) {
    data = makeLargeArray<std::uint64_t>(voxelCount({words, rows, layers}));
  }
  std::uint64_t* row(int r, int layer) const {
    return data.get() + (static_cast<std::ptrdiff_t>(layer) * rows + r) * words;
  }
};

}  // namespace isolume
