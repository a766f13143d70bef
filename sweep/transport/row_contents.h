// Which parts of rows let all light pass, or none.
#pragma once

#include <cstdint>
#include <vector>

#include "sweep/grid.h"
#include "sweep/octants/column_shear.h"

namespace isolume {

/// -tau of rows of a grid, kSegment samples at a time: what a sweep need not compute again. One byte for each kSegment
/// voxels.
class RowContents {
 public:
  /// Borrows the distances. Threaded.
  RowContents(GridView<const float> distance, const TransmittanceRamp& ramp);

  /// As transmittanceRow(); up to ordinateLanes() values beyond the row may be set to kClear. Thread-safe.
  void writeRow(int y, int z, std::int16_t* row) const;

 private:
  enum class Part : std::uint8_t { several, clear, dark };
  std::size_t firstOf(int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(distance_.size.y) + static_cast<std::size_t>(y)) *
           static_cast<std::size_t>(parts_);
  }
  void convert(int y, int z, int first, int end, std::int16_t* row) const;

  GridView<const float> distance_;
  TransmittanceRamp ramp_;
  float perSmallest_;
  int parts_;
  std::vector<Part> contents_;
};

}  // namespace isolume
