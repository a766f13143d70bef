// A set of samples of a grid whose members are numbered in the order of the samples: x fastest, then y, then z. So an
// array can hold numbers for the members alone, and the place of each is found at once.
//
// number(at) = members before the word of `at`, stored, + those before it in the word, counted.
// Memory: 1/8 byte per voxel for the bits and half of that for the counts, rows rounded up to words. Fewer than 2^32
// members. Thread-safe for reading.
#pragma once

#include <bit>
#include <cstdint>

#include "sweep/bit_grid.h"

namespace isolume {

class RankedBits {
 public:
  /// Threaded.
  explicit RankedBits(BitGrid bits);

  const BitGrid& bits() const { return bits_; }
  glm::ivec3 size() const { return bits_.size(); }
  std::size_t count() const { return count_; }
  std::size_t bytes() const { return words() * (sizeof(std::uint64_t) + sizeof(std::uint32_t)); }
  /// False beyond the grid.
  bool test(glm::ivec3 at) const { return bits_.test(at.x, at.y, at.z); }

  /// Of a member; of another sample of the grid that of the next member.
  std::uint32_t number(glm::ivec3 at) const {
    const auto word = static_cast<std::size_t>(at.x / kWordBits);
    const std::uint64_t before = (std::uint64_t{1} << (at.x % kWordBits)) - 1;
    return firstOf(at.y, at.z)[word] + static_cast<std::uint32_t>(std::popcount(bits_.row(at.y, at.z)[word] & before));
  }
  /// By word of a row: the number of its first member, or the next.
  const std::uint32_t* firstOf(int y, int z) const {
    return first_.get() +
           (static_cast<std::size_t>(z) * static_cast<std::size_t>(size().y) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(bits_.words());
  }

 private:
  std::size_t words() const { return voxelCount({bits_.words(), size().y, size().z}); }

  BitGrid bits_;
  LargeArray<std::uint32_t> first_;
  std::size_t count_ = 0;
};

}  // namespace isolume
