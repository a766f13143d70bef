// Runs of set samples along the rows of a grid: what a BitGrid says, in O(runs) memory for sets near a surface.
//
// 8 bytes per run and 8 per row. Thread-safe for reading.
#pragma once

#include <span>

#include "sweep/bit_grid.h"

namespace isolume {

struct Run {
  int begin = 0, end = 0;  ///< x, end not included
};

class NearRuns {
 public:
  explicit NearRuns(const BitGrid& set) : rows_(set.size().y), first_(1, 0) {
    for (int z = 0; z < set.size().z; ++z)
      for (int y = 0; y < set.size().y; ++y) {
        addRow(set.row(y, z), set.words());
        first_.push_back(runs_.size());
      }
  }

  std::span<const Run> row(int y, int z) const {
    const auto at = static_cast<std::size_t>(z) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(y);
    return {runs_.data() + first_[at], first_[at + 1] - first_[at]};
  }
  bool empty() const { return runs_.empty(); }

 private:
  void addRow(const std::uint64_t* bits, int words) {
    const std::size_t rowBegin = runs_.size();
    for (int w = 0; w < words; ++w)
      for (std::uint64_t left = bits[w]; left != 0;) {
        const int begin = std::countr_zero(left);
        const int length = std::countr_one(left >> begin);
        const int x = w * kWordBits + begin;
        if (runs_.size() > rowBegin && runs_.back().end == x) {
          runs_.back().end += length;
        } else {
          runs_.push_back({x, x + length});
        }
        left = begin + length == kWordBits ? 0 : left & ~std::uint64_t{0} << (begin + length);
      }
  }

  int rows_;
  std::vector<std::size_t> first_;
  std::vector<Run> runs_;
};

}  // namespace isolume
