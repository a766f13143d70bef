#include "column_shear.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/octants/column_shear.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using LightTag = hn::ScalableTag<std::int16_t>;
using LightVec = hn::Vec<LightTag>;
using LightMask = hn::Mask<LightTag>;

// Rows follow each other in memory, faster than the hardware guesses: values ahead to ask for.
constexpr int kAhead = 1024;

void transmittanceRowOnTarget(const float* distance, int count, float perSmallest, const TransmittanceRamp& ramp,
                              std::int16_t* row) {
  const hn::Rebind<std::int16_t, hn::ScalableTag<float>> d16;
  const hn::ScalableTag<float> d;
  const int lanes = static_cast<int>(hn::Lanes(d)), width = static_cast<int>(hn::Lanes(LightTag()));
  const auto scale = hn::Set(d, perSmallest), one = hn::Set(d, 1.0F), minusOne = hn::Set(d, -1.0F);
  const auto slope = hn::Set(d, ramp.slope), middle = hn::Set(d, ramp.middle), least = hn::Set(d, ramp.least);
  const auto units = hn::Set(d, static_cast<float>(kClear));
  const auto convert = [&](hn::Vec<decltype(d)> value) HWY_ATTR {
    // From 1 on nothing changes: it stands for all that is larger, infinity too.
    const auto near = hn::Min(hn::Max(hn::Mul(value, scale), minusOne), one);
    const auto tau = hn::Min(hn::Max(hn::Add(hn::Mul(slope, near), middle), least), one);
    return hn::DemoteTo(d16, hn::NearestInt(hn::Mul(tau, units)));
  };
  int x = 0;
  for (; x + lanes <= count; x += lanes) {
    hwy::Prefetch(distance + x + kAhead);
    hn::StoreU(convert(hn::LoadU(d, distance + x)), d16, row + x);
  }
  for (; x % width != 0 || x < count; x += lanes) {
    alignas(64) float some[hn::MaxLanes(hn::ScalableTag<float>())];
    for (int i = 0; i < lanes; ++i) some[i] = x + i < count ? distance[x + i] : 1 / perSmallest;
    hn::StoreU(convert(hn::Load(d, some)), d16, row + x);
  }
}

Content contentOfRowsOnTarget(const std::int16_t* rows, std::ptrdiff_t stride, int count) {
  const LightTag d;
  const auto first = hn::Set(d, rows[0]);
  auto other = hn::Zero(d);
  for (int y = 0; y < count; ++y) other = hn::Or(other, hn::Xor(hn::Load(d, rows + y * stride), first));
  return hn::AllTrue(d, hn::Eq(other, hn::Zero(d))) ? Content{true, rows[0]} : Content{};
}

// Takes lane j of out[t] from in[t - direction * k * unit], k two binary digits of its shift, from the one of weight
// `unit` on.
class Digits {
 public:
  Digits(int unit, bool rising) : unit_(unit) {
    const LightTag d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    alignas(64) std::int16_t digit[hn::MaxLanes(LightTag())];
    for (int j = 0; j < lanes; ++j) {
      const int shift = rising ? j : lanes - 1 - j;
      digit[j] = static_cast<std::int16_t>(shift / unit % 4);
    }
    const auto digits = hn::Load(d, digit);
    for (int k = 0; k < 3; ++k) is_[k] = hn::Eq(digits, hn::Set(d, static_cast<std::int16_t>(k + 1)));
    both_ = 2 * unit < lanes;
  }
  template <int kDirection>
  HWY_INLINE void apply(const std::int16_t* in, std::ptrdiff_t stride, std::int16_t* out, std::ptrdiff_t outStride,
                        int count) const {
    const LightTag d;
    const std::ptrdiff_t back = kDirection * unit_ * stride;
    const auto is1 = is_[0], is2 = is_[1], is3 = is_[2];
    if (both_) {
      for (int t = 0; t < count; ++t, in += stride, out += outStride) {
        auto v = hn::IfThenElse(is1, hn::LoadU(d, in - back), hn::LoadU(d, in));
        v = hn::IfThenElse(is2, hn::LoadU(d, in - 2 * back), v);
        hn::Store(hn::IfThenElse(is3, hn::LoadU(d, in - 3 * back), v), d, out);
      }
    } else {
      for (int t = 0; t < count; ++t, in += stride, out += outStride)
        hn::Store(hn::IfThenElse(is1, hn::LoadU(d, in - back), hn::LoadU(d, in)), d, out);
    }
  }

 private:
  int unit_;
  bool both_ = true;
  LightMask is_[3];
};

// Lanes of a vector need digits of weight 1, 4 and 16 at most. A pass is as much longer than the stretch that is asked
// for as the passes after it reach: those of the large digits come first.
constexpr int kLanes = static_cast<int>(hn::MaxLanes(LightTag()));
constexpr int kReachOf1 = std::min(3, kLanes - 1), kReachOf4 = std::min(3 * 4, kLanes - 1 - kReachOf1);
constexpr int kReach = kReachOf1 + kReachOf4;

void shearRowsOnTarget(const std::int16_t* rows, std::ptrdiff_t stride, bool rising, Stretch steps,
                       std::int16_t* scratch, std::int16_t* second, std::int16_t* diagonals) {
  const int count = steps.end - steps.begin;
  const std::int16_t* from = rows + steps.begin * stride;
  std::int16_t* for1 = scratch + kReachOf1 * kLanes;
  if constexpr (kLanes <= 16) {
    Digits(4, rising).apply<1>(from - kReachOf1 * stride, stride, scratch, kLanes, count + kReachOf1);
  } else {
    Digits(16, rising).apply<1>(from - kReach * stride, stride, second, kLanes, count + kReach);
    Digits(4, rising).apply<1>(second + kReachOf4 * kLanes, kLanes, scratch, kLanes, count + kReachOf1);
  }
  Digits(1, rising).apply<1>(for1, kLanes, diagonals + static_cast<std::ptrdiff_t>(steps.begin) * kLanes, kLanes,
                             count);
}

void unshearRowsOnTarget(const std::int16_t* diagonals, bool rising, Stretch rows, std::int16_t* scratch,
                         std::int16_t* second, std::int16_t* values, std::ptrdiff_t stride) {
  const int count = rows.end - rows.begin;
  const std::int16_t* from = diagonals + static_cast<std::ptrdiff_t>(rows.begin) * kLanes;
  if constexpr (kLanes <= 16) {
    Digits(4, rising).apply<-1>(from, kLanes, scratch, kLanes, count + kReachOf1);
  } else {
    Digits(16, rising).apply<-1>(from, kLanes, second, kLanes, count + kReach);
    Digits(4, rising).apply<-1>(second, kLanes, scratch, kLanes, count + kReachOf1);
  }
  Digits(1, rising).apply<-1>(scratch, kLanes, values + rows.begin * stride, stride, count);
}

// Calls pack(rising, falling, voxels) for each vector of 32-bit lanes; the last of a row goes through a buffer.
template <class T, class Pack>
HWY_INLINE void forEachVector(const MergedRows& rows, T* voxels, const Pack& pack) {
  constexpr int lanes = static_cast<int>(hn::MaxLanes(hn::ScalableTag<float>()));
  const std::int16_t *rising = rows.rising, *falling = rows.falling;
  for (int y = 0; y < rows.ny; ++y, rising += rows.stride, falling += rows.stride, voxels += rows.nx) {
    int x = 0;
    for (; x + lanes <= rows.nx; x += lanes) {
      hwy::Prefetch(voxels + x + kAhead);
      pack(rising + x, falling + x, voxels + x);
    }
    if (x == rows.nx) continue;
    alignas(64) T some[lanes];
    for (int i = 0; i < lanes; ++i) some[i] = x + i < rows.nx ? voxels[x + i] : 0;
    pack(rising + x, falling + x, some);
    for (int i = 0; x + i < rows.nx; ++i) voxels[x + i] = some[i];
  }
}

void packBytesOnTarget(const MergedRows& rows, std::uint32_t* voxels) {
  const hn::ScalableTag<std::uint32_t> d;
  const hn::Rebind<std::uint16_t, decltype(d)> d16;
  const hn::Rebind<std::int16_t, decltype(d)> di16;
  const auto low = hn::Set(d16, std::uint16_t{0xFF});
  const auto pack = [&](const std::int16_t* rising, const std::int16_t* falling, std::uint32_t* out) HWY_ATTR {
    const auto outer = hn::BitCast(d16, hn::LoadU(di16, rising));
    const auto inner = hn::BitCast(d16, hn::LoadU(di16, falling));
    const auto first = hn::Or(hn::And(outer, low), hn::ShiftLeft<8>(inner));
    const auto second = hn::Or(hn::ShiftRight<8>(inner), hn::AndNot(low, outer));
    hn::StoreU(hn::Or(hn::PromoteTo(d, first), hn::ShiftLeft<16>(hn::PromoteTo(d, second))), d, out);
  };
  forEachVector(rows, voxels, pack);
}

void packMeansOnTarget(const MergedRows& rows, bool last, int total, std::uint16_t* voxels) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> d32;
  const hn::Rebind<std::int16_t, decltype(d)> d16;
  const hn::Rebind<std::uint16_t, decltype(d)> du16;
  const auto scale = hn::Set(d, 65535.0F / static_cast<float>(total));
  const auto all = hn::Set(d32, total);
  const auto pack = [&](const std::int16_t* rising, const std::int16_t* falling, std::uint16_t* out) HWY_ATTR {
    auto missing = hn::PromoteTo(d32, hn::Add(hn::LoadU(d16, rising), hn::LoadU(d16, falling)));
    if (last) {
      missing = hn::Add(missing, hn::PromoteTo(d32, hn::LoadU(du16, out)));
      missing = hn::NearestInt(hn::Mul(scale, hn::ConvertTo(d, hn::Sub(all, missing))));
    }
    hn::StoreU(hn::DemoteTo(du16, missing), du16, out);
  };
  forEachVector(rows, voxels, pack);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(transmittanceRowOnTarget);
HWY_EXPORT(contentOfRowsOnTarget);
HWY_EXPORT(shearRowsOnTarget);
HWY_EXPORT(unshearRowsOnTarget);
HWY_EXPORT(packBytesOnTarget);
HWY_EXPORT(packMeansOnTarget);

void transmittanceRow(const float* distance, int count, float perSmallest, const TransmittanceRamp& ramp,
                      std::int16_t* row) {
  HWY_DYNAMIC_DISPATCH(transmittanceRowOnTarget)(distance, count, perSmallest, ramp, row);
}

Content contentOfRows(const std::int16_t* rows, std::ptrdiff_t stride, int count) {
  return HWY_DYNAMIC_DISPATCH(contentOfRowsOnTarget)(rows, stride, count);
}

void shearRows(const std::int16_t* rows, std::ptrdiff_t stride, const ColumnShape& shape, bool rising, Stretch steps,
               std::int16_t* scratch, std::int16_t* diagonals) {
  std::int16_t* second = scratch + shearScratch(shape) / 2;
  HWY_DYNAMIC_DISPATCH(shearRowsOnTarget)(rows, stride, rising, steps, scratch, second, diagonals);
}

void unshearRows(const std::int16_t* diagonals, const ColumnShape& shape, bool rising, Stretch rows,
                 std::int16_t* scratch, std::int16_t* values, std::ptrdiff_t stride) {
  std::int16_t* second = scratch + shearScratch(shape) / 2;
  HWY_DYNAMIC_DISPATCH(unshearRowsOnTarget)(diagonals, rising, rows, scratch, second, values, stride);
}

void packBytes(const MergedRows& rows, glm::u8vec4* voxels) {
  // x86-64: channel 0 is the lowest byte.
  static_assert(sizeof(glm::u8vec4) == sizeof(std::uint32_t));
  HWY_DYNAMIC_DISPATCH(packBytesOnTarget)(rows, reinterpret_cast<std::uint32_t*>(voxels));
}

void packMeans(const MergedRows& rows, bool last, int total, std::uint16_t* voxels) {
  HWY_DYNAMIC_DISPATCH(packMeansOnTarget)(rows, last, total, voxels);
}

}  // namespace isolume
#endif
