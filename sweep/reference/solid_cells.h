// Which cells a ray can enter the solid in: one bit per cell, in a tree of 64-bit words.
//
// A cell (i, j, k) lies between the samples (i, j, k) and (i + 1, j + 1, k + 1). Its bit is set if one of its corners
// is inside (level > 0); in all others the interpolant is <= 0 throughout. A word holds 4^3 bits: of cells (lowest
// level), of words below (4^3 and 16^3 cells to a bit). Memory: 1/8 byte per voxel, and 1/64 of that above it.
// Thread-safe once built; built in O(n), threaded.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "sweep/grid.h"
#include "sweep/large_array.h"

namespace isolume {

class SolidCells {
 public:
  /// At least two samples along each axis.
  explicit SolidCells(GridView<const float> level);

  /// Side of an aligned cube of cells around `cell` without a set bit: a power of two up to 64; 0 if the cell's own bit
  /// is set. The cube may reach beyond the grid, where no bit is set.
  int emptyCube(glm::ivec3 cell) const;

 private:
  struct Level {
    glm::ivec3 octets{0};  ///< eight words, 2^3, lie together: a cache line, for a ray that goes any way
    LargeArray<std::uint64_t> words;
    std::uint64_t& wordAt(int x, int y, int z) const {
      const std::size_t octet =
          (static_cast<std::size_t>(z >> 1) * static_cast<std::size_t>(octets.y) + static_cast<std::size_t>(y >> 1)) *
              static_cast<std::size_t>(octets.x) +
          static_cast<std::size_t>(x >> 1);
      return words[8 * octet + static_cast<std::size_t>((x & 1) | (y & 1) << 1 | (z & 1) << 2)];
    }
  };
  static Level makeWords(glm::ivec3 bits);

  std::array<Level, 3> levels_;
};

inline int SolidCells::emptyCube(glm::ivec3 cell) const {
  int scale = 0;  // of the level: a bit stands for (2^scale)^3 cells
  for (const Level& level : levels_) {
    const glm::ivec3 at(cell.x >> scale, cell.y >> scale, cell.z >> scale);
    if (const std::uint64_t word = level.wordAt(at.x >> 2, at.y >> 2, at.z >> 2); word != 0) {
      const unsigned bit = static_cast<unsigned>((at.x & 3) | (at.y & 3) << 2 | (at.z & 3) << 4);
      if (word >> bit & 1) return 0;  // at the lowest level only: above it, the word below was 0
      // The cube of 2^3 bits around it: its first bit has even coordinates.
      constexpr unsigned kEven = 0b101010;
      constexpr std::uint64_t kTwoCube = 0x0033'0033;
      return (word >> (bit & kEven) & kTwoCube) != 0 ? 1 << scale : 2 << scale;
    }
    scale += 2;
  }
  return 1 << scale;
}

}  // namespace isolume
