#include "solid_lattice.h"

#include <algorithm>

#include "outline.h"
#include "sweep/near_sets.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// The rows of samples around a row of the lattice: two along y and two along z, equal where it runs through samples.
struct RowsAround {
  const float* level[4];
  const std::uint64_t* signs[4];
};

RowsAround rowsAround(GridView<const float> level, const BitGrid& inside, int refinement, int y, int z) {
  RowsAround around{};
  for (int i = 0; i < 4; ++i) {
    const int sampleY = y / refinement + (y % refinement != 0 ? i & 1 : 0);
    const int sampleZ = z / refinement + (z % refinement != 0 ? i >> 1 : 0);
    around.level[i] = &level(0, sampleY, sampleZ);
    around.signs[i] = inside.row(sampleY, sampleZ);
  }
  return around;
}

// Bit i to bit 2 i. [Warren12] Sec. 7-2.
std::uint64_t spread(std::uint32_t bits) {
  std::uint64_t x = bits;
  x = (x | x << 16) & 0x0000ffff0000ffffULL;
  x = (x | x << 8) & 0x00ff00ff00ff00ffULL;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0fULL;
  x = (x | x << 2) & 0x3333333333333333ULL;
  return (x | x << 1) & 0x5555555555555555ULL;
}

// Samples 64 w and on of a row: lattice points at the samples and halfway to the next, from interpolated levels.
struct WordPair {
  std::uint64_t at = 0, between = 0;
};
WordPair interpolatedWords(const RowsAround& around, int w, int count) {
  const int begin = w * kWordBits, end = std::min(begin + kWordBits + 1, count);
  float mean[kWordBits + 1], half[kWordBits];
  // Times 1/4, so that no sum overflows.
  for (int x = begin; x < end; ++x)
    mean[x - begin] = (0.25F * around.level[0][x] + 0.25F * around.level[1][x]) +
                      (0.25F * around.level[2][x] + 0.25F * around.level[3][x]);
  const int samples = std::min(kWordBits, end - begin), halves = end - begin - 1;
  for (int i = 0; i < halves; ++i) half[i] = 0.5F * mean[i] + 0.5F * mean[i + 1];
  WordPair words;
  positiveBits(mean, samples, &words.at);
  if (halves > 0) positiveBits(half, halves, &words.between);
  return words;
}

// Where all samples around are on one side, so is what lies between.
void refineRow(const RowsAround& around, int count, int words, std::uint64_t* to) {
  const int samplesWords = (count + kWordBits - 1) / kWordBits;
  std::fill_n(to, words, std::uint64_t{0});
  for (int w = 0; w < samplesWords; ++w) {
    std::uint64_t any = 0, all = ~std::uint64_t{0};
    std::uint64_t anyNext = 0, allNext = 1;
    for (const std::uint64_t* signs : around.signs) {
      any |= signs[w];
      all &= signs[w];
      const std::uint64_t next = w + 1 < samplesWords ? signs[w + 1] & 1 : 0;
      anyNext |= next;
      allNext &= next;
    }
    if (any == 0 && anyNext == 0) continue;
    WordPair pair{~std::uint64_t{0}, ~std::uint64_t{0}};
    if (!(all == ~std::uint64_t{0} && allNext == 1)) pair = interpolatedWords(around, w, count);
    const auto low = [](std::uint64_t bits) { return spread(static_cast<std::uint32_t>(bits)); };
    to[2 * w] = low(pair.at) | low(pair.between) << 1;
    if (2 * w + 1 < words) to[2 * w + 1] = low(pair.at >> 32) | low(pair.between >> 32) << 1;
  }
}

// Transposes 64 x 64 bits in place, by halves. [Warren12] Sec. 7-3.
void transposeBlock(std::uint64_t* rows) {
  std::uint64_t mask = 0x00000000ffffffffULL;
  for (int j = kWordBits / 2; j != 0; j >>= 1, mask ^= mask << j) {
    for (int k = 0; k < kWordBits; k = ((k | j) + 1) & ~j) {
      const std::uint64_t swapped = ((rows[k] >> j) ^ rows[k | j]) & mask;
      rows[k] ^= swapped << j;
      rows[k | j] ^= swapped;
    }
  }
}

void transposeLayer(const BitRows& from, BitRows& to, int layer) {
  std::uint64_t block[kWordBits];
  for (int r = 0; r < to.rows; ++r) std::fill_n(to.row(r, layer), to.words, std::uint64_t{0});
  for (int y = 0; y < from.rows; y += kWordBits) {
    const int high = std::min(kWordBits, from.rows - y);
    for (int x = 0; x < from.length; x += kWordBits) {
      std::uint64_t any = 0;
      for (int i = 0; i < kWordBits; ++i) any |= block[i] = i < high ? from.row(y + i, layer)[x / kWordBits] : 0;
      if (any == 0) continue;
      transposeBlock(block);
      const int wide = std::min(kWordBits, from.length - x);
      for (int i = 0; i < wide; ++i) to.row(x + i, layer)[y / kWordBits] = block[i];
    }
  }
}

}  // namespace

SolidLattice makeSolidLattice(GridView<const float> level, const BitGrid& inside, int refinement,
                              const GridView<const float>* outlines) {
  SolidLattice lattice;
  lattice.refinement = refinement;
  lattice.size = (level.size - 1) * refinement + 1;
  lattice.alongX = BitRows(lattice.size.x, lattice.size.y, lattice.size.z);
  lattice.alongY = BitRows(lattice.size.y, lattice.size.x, lattice.size.z);
  parallelFor(static_cast<std::size_t>(lattice.size.z), [&](std::size_t layer) {
    const int z = static_cast<int>(layer);
    for (int y = 0; y < lattice.size.y; ++y) {
      const RowsAround around = rowsAround(level, inside, refinement, y, z);
      std::uint64_t* row = lattice.alongX.row(y, z);
      if (refinement == 1) {
        std::fill(std::copy_n(around.signs[0], inside.words(), row), row + lattice.alongX.words, std::uint64_t{0});
      } else {
        refineRow(around, level.size.x, lattice.alongX.words, row);
      }
    }
    if (outlines != nullptr) narrowOutlines(*outlines, inside, refinement, z, lattice.alongX);
    transposeLayer(lattice.alongX, lattice.alongY, z);
  });
  return lattice;
}

}  // namespace isolume
