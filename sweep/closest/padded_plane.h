// One z plane of offsets in scratch memory, with an unset frame, so that vector code needs no special case at borders.
#pragma once

#include <cstddef>

#include "sweep/closest/offset_field.h"
#include "sweep/large_array.h"

namespace isolume {

/// Rows that step 3 of the pass takes side by side, and the widest vector: rows and columns are padded to it.
inline constexpr int kRowGroup = 16;

class PaddedPlane {
 public:
  PaddedPlane(int nx, int ny)
      : nx_(nx),
        rowStride_(roundUp(nx) + 2 * kRowGroup),
        planeStride_(static_cast<std::ptrdiff_t>(rowStride_) * (roundUp(ny) + 2)),
        values_(makeLargeArray<float>(static_cast<std::size_t>(3 * planeStride_))) {
    std::fill_n(values_.get(), planeStride_, kUnsetOffset);
    std::fill_n(values_.get() + planeStride_, 2 * planeStride_, 0.0F);
  }

  /// Component `axis` of row y, -1 <= y <= ny; 64-byte aligned; columns -1 to the padded end may be read.
  float* row(int axis, int y) {
    return values_.get() + axis * planeStride_ + static_cast<std::ptrdiff_t>(y + 1) * rowStride_ + kRowGroup;
  }
  const float* row(int axis, int y) const { return const_cast<PaddedPlane*>(this)->row(axis, y); }
  /// Makes the columns from nx to the padded end unset again.
  void clearTail(int y) {
    const int count = roundUp(nx_) - nx_;
    std::fill_n(row(0, y) + nx_, count, kUnsetOffset);
    std::fill_n(row(1, y) + nx_, count, 0.0F);
    std::fill_n(row(2, y) + nx_, count, 0.0F);
  }

  static constexpr int roundUp(int n) { return (n + kRowGroup - 1) / kRowGroup * kRowGroup; }

 private:
  int nx_;
  int rowStride_;
  std::ptrdiff_t planeStride_;
  LargeArray<float> values_;
};

}  // namespace isolume
