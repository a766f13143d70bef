#include "sweep/reference/solid_cells.h"

#include <algorithm>
#include <glm/common.hpp>

#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr int kWordSide = 4;  // bits of a word along each axis

// Bits of the 4^3 cells from `first` on: those with a corner inside.
std::uint64_t wordOfCells(GridView<const float> level, glm::ivec3 first) {
  const glm::ivec3 last = glm::min(first + kWordSide, level.size - 1);  // samples, inclusive: one more than cells
  std::uint64_t word = 0;
  for (int z = first.z; z <= last.z; ++z) {
    for (int y = first.y; y <= last.y; ++y) {
      const float* row = level.data + level.index(0, y, z);
      for (int x = first.x; x <= last.x; ++x) {
        if (!(row[x] > 0)) continue;
        // The up to eight cells around the sample that belong to this word.
        const glm::ivec3 at = glm::ivec3(x, y, z) - first;
        for (int k = std::max(at.z - 1, 0); k <= std::min(at.z, last.z - first.z - 1); ++k)
          for (int j = std::max(at.y - 1, 0); j <= std::min(at.y, last.y - first.y - 1); ++j)
            for (int i = std::max(at.x - 1, 0); i <= std::min(at.x, last.x - first.x - 1); ++i)
              word |= std::uint64_t{1} << (i | j << 2 | k << 4);
      }
    }
  }
  return word;
}

}  // namespace

SolidCells::Level SolidCells::makeWords(glm::ivec3 bits) {
  constexpr int kOctetSide = 2 * kWordSide;
  constexpr std::size_t kOctet = 8;
  Level level;
  level.octets = (bits + kOctetSide - 1) / kOctetSide;
  const std::size_t count = kOctet * voxelCount(level.octets);
  level.words = makeLargeArray<std::uint64_t>(count);
  std::fill_n(level.words.get(), count, std::uint64_t{0});
  return level;
}

SolidCells::SolidCells(GridView<const float> level) {
  glm::ivec3 bits = level.size - 1;
  for (Level& each : levels_) {
    each = makeWords(bits);
    bits = (bits + kWordSide - 1) / kWordSide;
  }

  const glm::ivec3 cells = level.size - 1;
  const glm::ivec3 words = (cells + kWordSide - 1) / kWordSide;
  parallelFor(static_cast<std::size_t>(words.z), [&](std::size_t layer) {
    const int z = static_cast<int>(layer);
    for (int y = 0; y < words.y; ++y)
      for (int x = 0; x < words.x; ++x)
        levels_[0].wordAt(x, y, z) = wordOfCells(level, kWordSide * glm::ivec3(x, y, z));
  });

  glm::ivec3 below = words;  // words of the level below are bits of the next
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    for (int z = 0; z < below.z; ++z)
      for (int y = 0; y < below.y; ++y)
        for (int x = 0; x < below.x; ++x)
          if (levels_[i - 1].wordAt(x, y, z) != 0)
            levels_[i].wordAt(x >> 2, y >> 2, z >> 2) |= std::uint64_t{1} << ((x & 3) | (y & 3) << 2 | (z & 3) << 4);
    below = (below + kWordSide - 1) / kWordSide;
  }
}

}  // namespace isolume
