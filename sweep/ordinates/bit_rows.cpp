#include "bit_rows.h"

#include <algorithm>

#include "sweep/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/ordinates/bit_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void packSignsOnTarget(const float* values, int count, std::uint64_t* words) {
  const hn::CappedTag<float, 16> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  std::fill_n(words, (count + BitRows::kWordBits - 1) / BitRows::kWordBits, std::uint64_t{0});
  int x = 0;
  for (; x + lanes <= count; x += lanes) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, hn::Gt(hn::LoadU(d, values + x), hn::Zero(d)), bytes);
    std::uint64_t bits = bytes[0] | static_cast<std::uint64_t>(bytes[1]) << 8;
    words[x / BitRows::kWordBits] |= bits << (x % BitRows::kWordBits);
  }
  for (; x < count; ++x)
    words[x / BitRows::kWordBits] |= static_cast<std::uint64_t>(values[x] > 0) << (x % BitRows::kWordBits);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(packSignsOnTarget);

void packSigns(const float* values, int count, std::uint64_t* words) {
  HWY_DYNAMIC_DISPATCH(packSignsOnTarget)(values, count, words);
}

BitRows signBits(GridView<const float> level) {
  BitRows bits(level.size.x, level.size.y, level.size.z);
  parallelFor(static_cast<std::size_t>(level.size.z), [&](std::size_t layer) {
    const int z = static_cast<int>(layer);
    for (int y = 0; y < level.size.y; ++y) {
      std::uint64_t* row = bits.row(y, z);
      std::fill_n(row, bits.words, std::uint64_t{0});
      packSigns(&level(0, y, z), level.size.x, row);
    }
  });
  return bits;
}

}  // namespace isolume
#endif
