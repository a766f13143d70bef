#include "near_sets.h"

#include "godunov/surface_start.h"
#include "parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/near_sets.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, 16>;

// Bits of the values for which the test holds, for vectors and for one.
template <class TestVector, class TestOne>
HWY_INLINE void bitsWhere(const float* values, int count, const TestVector& vector, const TestOne& one,
                          std::uint64_t* words) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const std::uint64_t used = (std::uint64_t{1} << lanes) - 1;
  std::uint64_t word = 0;
  int x = 0;
  for (; x + lanes <= count; x += lanes) {
    std::uint8_t bytes[8] = {};  // as many as StoreMaskBits may write
    hn::StoreMaskBits(d, vector(hn::LoadU(d, values + x)), bytes);
    std::uint64_t bits;
    std::memcpy(&bits, bytes, sizeof bits);
    word |= (bits & used) << (x % kWordBits);
    if ((x + lanes) % kWordBits != 0) continue;
    words[x / kWordBits] = word;
    word = 0;
  }
  for (; x < count; ++x) word |= std::uint64_t{one(values[x])} << (x % kWordBits);
  if (count % kWordBits != 0) words[count / kWordBits] = word;
}

void positiveBitsOnTarget(const float* values, int count, std::uint64_t* words) {
  const auto isPositive = [](auto value) { return hn::Gt(value, hn::Zero(FloatTag())); };
  bitsWhere(
      values, count, isPositive, [](float value) { return value > 0; }, words);
}

void fixedBitsOnTarget(const float* values, int count, std::uint64_t* words) {
  const auto isFixedLane = [](auto value) {
    const FloatTag d;
    const hn::RebindToUnsigned<FloatTag> du;
    return hn::RebindMask(d, hn::TestBit(hn::BitCast(du, value), hn::Set(du, kFixedBit)));
  };
  bitsWhere(
      values, count, isFixedLane, [](float value) { return isFixed(value); }, words);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(positiveBitsOnTarget);
HWY_EXPORT(fixedBitsOnTarget);

void positiveBits(const float* values, int count, std::uint64_t* words) {
  HWY_DYNAMIC_DISPATCH(positiveBitsOnTarget)(values, count, words);
}

void fixedBits(const float* values, int count, std::uint64_t* words) {
  HWY_DYNAMIC_DISPATCH(fixedBitsOnTarget)(values, count, words);
}

BitGrid insideSamples(GridView<const float> level) {
  BitGrid inside(level.size);
  parallelFor(static_cast<std::size_t>(level.size.z), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    for (int y = 0; y < level.size.y; ++y) positiveBits(&level(0, y, z), level.size.x, inside.row(y, z));
  });
  return inside;
}

void crossedRow(const BitGrid& inside, int y, int z, BitRow& row) {
  const glm::ivec3 size = inside.size();
  const int words = inside.words();
  const std::uint64_t* here = inside.row(y, z);
  // A row beyond the grid is the row itself, which it never crosses.
  const std::uint64_t* others[4] = {inside.row(std::max(y - 1, 0), z), inside.row(std::min(y + 1, size.y - 1), z),
                                    inside.row(y, std::max(z - 1, 0)), inside.row(y, std::min(z + 1, size.z - 1))};
  std::uint64_t before = 0;  // the edge from the word before, at its last bit
  for (int w = 0; w < words; ++w) {
    std::uint64_t crossed = 0;
    for (const std::uint64_t* other : others) crossed |= here[w] ^ other[w];
    // Bit x of `edges`: samples x and x + 1 differ.
    std::uint64_t edges = here[w] ^ (here[w] >> 1 | (w + 1 < words ? here[w + 1] << (kWordBits - 1) : 0));
    if (w + 1 == words) edges &= inside.lastWordMask() >> 1;
    row[static_cast<std::size_t>(w)] = crossed | edges | edges << 1 | before >> (kWordBits - 1);
    before = edges;
  }
}

void capRow(const BitGrid& inside, int y, int z, BitRow& row) {
  const glm::ivec3 size = inside.size();
  const std::uint64_t* here = inside.row(y, z);
  if (y == 0 || z == 0 || y == size.y - 1 || z == size.z - 1) {
    std::copy_n(here, inside.words(), row.begin());
    return;
  }
  std::fill(row.begin(), row.end(), std::uint64_t{0});
  row.front() |= here[0] & 1;
  const int last = size.x - 1;
  row.back() |= here[last / kWordBits] & std::uint64_t{1} << (last % kWordBits);
}

void cornerRow(const BitGrid& inside, int y, int z, BitRow& row) {
  const glm::ivec3 size = inside.size();
  const int words = inside.words();
  const std::uint64_t* around[9];
  int count = 0;
  for (int k = std::max(z - 1, 0); k <= std::min(z + 1, size.z - 1); ++k)
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size.y - 1); ++j) around[count++] = inside.row(j, k);
  // Of a word of the rows around: where any sample is inside, where any is outside.
  struct Sides {
    std::uint64_t inside = 0, outside = 0;
  };
  const auto sidesOf = [&](int w) {
    std::uint64_t any = 0, all = ~std::uint64_t{0};
    for (int i = 0; i < count; ++i) {
      any |= around[i][w];
      all &= around[i][w];
    }
    return Sides{any, ~all & (w + 1 == words ? inside.lastWordMask() : ~std::uint64_t{0})};
  };
  Sides before, own = sidesOf(0);
  for (int w = 0; w < words; ++w) {
    const Sides after = w + 1 < words ? sidesOf(w + 1) : Sides();
    row[static_cast<std::size_t>(w)] =
        spreadWord(before.inside, own.inside, after.inside) & spreadWord(before.outside, own.outside, after.outside);
    before = own;
    own = after;
  }
  row.back() &= inside.lastWordMask();
}

void grownRow(const BitGrid& set, Across across, int y, int z, BitRow& row) {
  // One beyond the grid is the one at its border, which is in reach as well.
  const auto rowAt = [&](int dy, int dz) {
    return set.row(std::clamp(y + dy, 0, set.size().y - 1), std::clamp(z + dz, 0, set.size().z - 1));
  };
  const std::uint64_t* own = rowAt(0, 0);
  const std::array beside{rowAt(-1, 0), rowAt(1, 0), rowAt(0, -1), rowAt(0, 1)};
  const std::array diagonal{rowAt(-1, -1), rowAt(1, -1), rowAt(-1, 1), rowAt(1, 1)};
  const auto any = [](const auto& rows, int w) { return rows[0][w] | rows[1][w] | rows[2][w] | rows[3][w]; };
  // Those from which one more step leads along x.
  const auto inner = [&](int w) {
    return own[w] | (across >= Across::edges ? any(beside, w) : 0) | (across >= Across::corners ? any(diagonal, w) : 0);
  };
  const auto outer = [&](int w) {
    return across == Across::faces ? any(beside, w) : across == Across::edges ? any(diagonal, w) : 0;
  };
  const int words = set.words();
  std::uint64_t before = 0, here = inner(0);
  for (int w = 0; w < words; ++w) {
    const std::uint64_t after = w + 1 < words ? inner(w + 1) : 0;
    row[static_cast<std::size_t>(w)] = spreadWord(before, here, after) | outer(w);
    before = here;
    here = after;
  }
  row.back() &= set.lastWordMask();
}

}  // namespace isolume
#endif
