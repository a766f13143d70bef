// One bit per point of a lattice, in aligned rows of whole vectors, which BitGrid's are not.
//
// Bit i % 64 of word i / 64 of a row. Each row has at least one bit more than points; those are 0, so that a row that
// is shifted by one takes in zeros.
#pragma once

#include <cstdint>

#include "sweep/bit_grid.h"
#include "sweep/large_array.h"

namespace isolume {

struct BitRows {
  static constexpr int kRowWords = 8;  ///< a row is a multiple of 512 bits, and aligned

  LargeArray<std::uint64_t> data;
  int length = 0, rows = 0, layers = 0;  ///< points of a row, rows of a layer, layers
  int words = 0;                         ///< of a row

  BitRows() = default;
  /// Uninitialised.
  BitRows(int length_, int rows_, int layers_)
      : length(length_), rows(rows_), layers(layers_), words((length_ / (kRowWords * kWordBits) + 1) * kRowWords) {
    data = makeLargeArray<std::uint64_t>(voxelCount({words, rows, layers}));
  }
  std::uint64_t* row(int r, int layer) const {
    return data.get() + (static_cast<std::ptrdiff_t>(layer) * rows + r) * words;
  }
};

}  // namespace isolume
