// One bit per sample of a grid, in rows of 64-bit words, and sets of neighbours by operations on whole words.
//
// Bit x % 64 of word x / 64 of row (y, z); bits beyond the end of a row are 0. One bit per voxel. A word of zeros follows
// the last row, so that four bytes from any byte on may be read.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "sweep/grid.h"
#include "sweep/large_array.h"

namespace isolume {

inline constexpr int kWordBits = 64;

/// One row of bits that belongs to nobody's grid.
using BitRow = std::vector<std::uint64_t>;

/// Move-only.
class BitGrid {
 public:
  explicit BitGrid(glm::ivec3 size)
      : size_(size),
        words_((size.x + kWordBits - 1) / kWordBits),
        bits_(makeZeroArray<std::uint64_t>(voxelCount({words_, size.y, size.z}) + 1)) {}

  glm::ivec3 size() const { return size_; }
  int words() const { return words_; }
  std::uint64_t* row(int y, int z) {
    return bits_.get() +
           (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(words_);
  }
  const std::uint64_t* row(int y, int z) const { return const_cast<BitGrid*>(this)->row(y, z); }
  /// False beyond the grid.
  bool test(int x, int y, int z) const {
    if (x < 0 || y < 0 || z < 0 || x >= size_.x || y >= size_.y || z >= size_.z) return false;
    return (row(y, z)[x / kWordBits] >> (x % kWordBits) & 1) != 0;
  }
  /// Is any bit of rows (., z) set?
  bool anyInPlane(int z) const {
    const std::uint64_t* first = row(0, z);
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(words_) * size_.y,
                       [](std::uint64_t word) { return word != 0; });
  }
  void mark(int x, int y, int z) { row(y, z)[x / kWordBits] |= std::uint64_t{1} << (x % kWordBits); }
  /// The bits of the last word of a row that stand for samples.
  std::uint64_t lastWordMask() const {
    const int used = size_.x - (words_ - 1) * kWordBits;
    return ~std::uint64_t{0} >> (kWordBits - used);
  }

 private:
  glm::ivec3 size_;
  int words_;
  LargeArray<std::uint64_t> bits_;
};

/// Calls visit(x) for every bit that is set, in rising x.
template <class Visit>
void forEachBit(const std::uint64_t* row, int words, const Visit& visit) {
  for (int w = 0; w < words; ++w)
    for (std::uint64_t bits = row[w]; bits != 0; bits &= bits - 1) visit(w * kWordBits + std::countr_zero(bits));
}

/// Calls visit(begin, end) for every run of bits that are set, end not included, in rising x.
template <class Visit>
void forEachRun(const std::uint64_t* row, int words, const Visit& visit) {
  int begin = 0, end = 0;  // the run so far
  for (int w = 0; w < words; ++w)
    for (std::uint64_t left = row[w]; left != 0;) {
      const int first = std::countr_zero(left), length = std::countr_one(left >> first);
      const int x = w * kWordBits + first;
      if (x != end) {
        if (begin < end) visit(begin, end);
        begin = x;
      }
      end = x + length;
      left = first + length == kWordBits ? 0 : left & ~std::uint64_t{0} << (first + length);
    }
  if (begin < end) visit(begin, end);
}

/// A word and its two neighbours along x, of which the words before and after it hold some.
inline std::uint64_t spreadWord(std::uint64_t before, std::uint64_t own, std::uint64_t after) {
  return own | own << 1 | before >> (kWordBits - 1) | own >> 1 | after << (kWordBits - 1);
}

/// row |= its two neighbours along x; bits beyond the end are not cleared.
inline void spreadAlongX(std::uint64_t* row, int words) {
  std::uint64_t before = 0;
  for (int w = 0; w < words; ++w) {
    const std::uint64_t own = row[w];
    row[w] = spreadWord(before, own, w + 1 < words ? row[w + 1] : 0);
    before = own;
  }
}

}  // namespace isolume
