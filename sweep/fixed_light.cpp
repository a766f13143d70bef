#include "fixed_light.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/fixed_light.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using LightTag = hn::ScalableTag<std::int16_t>;
using LightVec = hn::Vec<LightTag>;
using LightMask = hn::Mask<LightTag>;

int columnLanesOfTarget() { return static_cast<int>(hn::Lanes(LightTag())); }

// Shifts vectors by one lane, with a value in the lane that becomes free.
#if HWY_TARGET == HWY_SCALAR
struct LaneShift {
  HWY_INLINE LightVec up(LightVec, std::int16_t in) const { return hn::Set(LightTag(), in); }
  HWY_INLINE LightVec down(LightVec, std::int16_t in) const { return hn::Set(LightTag(), in); }
};
#else
class LaneShift {
 public:
  LaneShift() {
    const int lanes = static_cast<int>(hn::Lanes(LightTag()));
    const WordTag words;
    const auto word = hn::Iota(words, 0);
    const auto last = hn::Set(words, static_cast<std::int32_t>(hn::Lanes(words)) - 1);
    const auto block = hn::Set(words, kBlockWords);
    blockBefore_ = hn::IndicesFromVec(words, hn::Max(hn::Sub(word, block), hn::Zero(words)));
    blockAfter_ = hn::IndicesFromVec(words, hn::Min(hn::Add(word, block), last));
    const auto lane = hn::Iota(LightTag(), 0);
    firstLane_ = hn::Eq(lane, hn::Zero(LightTag()));
    lastLane_ = hn::Eq(lane, hn::Set(LightTag(), static_cast<std::int16_t>(lanes - 1)));
  }
  HWY_INLINE LightVec up(LightVec v, std::int16_t in) const {
    const LightTag d;
    const auto before = hn::BitCast(d, hn::TableLookupLanes(hn::BitCast(WordTag(), v), blockBefore_));
    constexpr int kAllButOne = kBlockBytes - static_cast<int>(sizeof(std::int16_t));
    return hn::IfThenElse(firstLane_, hn::Set(d, in), hn::CombineShiftRightBytes<kAllButOne>(d, v, before));
  }
  HWY_INLINE LightVec down(LightVec v, std::int16_t in) const {
    const LightTag d;
    const auto after = hn::BitCast(d, hn::TableLookupLanes(hn::BitCast(WordTag(), v), blockAfter_));
    return hn::IfThenElse(lastLane_, hn::Set(d, in), hn::CombineShiftRightBytes<sizeof(std::int16_t)>(d, after, v));
  }

 private:
  using WordTag = hn::RepartitionToWide<LightTag>;
  static constexpr int kBlockBytes = 16, kBlockWords = kBlockBytes / 4;
  decltype(hn::IndicesFromVec(WordTag(), hn::Zero(WordTag()))) blockBefore_, blockAfter_;
  LightMask firstLane_, lastLane_;
};
#endif

HWY_INLINE LightVec arriving(LightVec minusX, LightVec minusY, LightVec dither, LightVec x, LightVec y, LightVec z) {
  const auto dithered = hn::Add(z, dither);
  const auto fromX = hn::MulFixedPoint15(hn::SaturatedSub(x, dithered), minusX);
  const auto fromY = hn::MulFixedPoint15(hn::SaturatedSub(y, dithered), minusY);
  return hn::Max(hn::SaturatedAdd(hn::SaturatedSub(fromX, z), fromY), hn::Zero(LightTag()));
}

// The dither of one step after the other.
class Dither {
 public:
  Dither(int phase, FixedWeights weights) : phase_(((phase % kCycle) + kCycle) % kCycle) {
    const bool dithers = weights.x < kHalf && weights.y < kHalf;
    values_[1] = dithers ? std::int16_t{1} : std::int16_t{0};
    values_[2] = static_cast<std::int16_t>(-values_[1]);
  }
  HWY_INLINE LightVec next() {
    const auto value = hn::Set(LightTag(), values_[phase_]);
    phase_ = phase_ == kCycle - 1 ? 0 : phase_ + 1;
    return value;
  }

 private:
  static constexpr int kCycle = 3;
  static constexpr std::int16_t kHalf = 1 << 14;
  std::int16_t values_[kCycle] = {0, 0, 0};
  int phase_;
};

// What V leaves in a column.
struct PartVec {
  LightVec zero, factor, unit;
  explicit PartVec(const LightPart& part)
      : zero(hn::Set(LightTag(), part.zero)),
        factor(hn::Set(LightTag(), part.factor)),
        unit(hn::Set(LightTag(), part.unit)) {}
  template <bool kFirst>
  HWY_INLINE void store(LightVec light, std::int16_t* merged) const {
    const LightTag d;
    const auto part = hn::MulFixedPoint15(hn::Sub(light, zero), factor);
    hn::Store(kFirst ? part : hn::Add(hn::Load(d, merged), hn::Mul(part, unit)), d, merged);
  }
};

template <bool kForward>
void sweepColumnsAs(const FixedColumn& up, const FixedColumn& down, const ColumnShape& shape, FixedWeights weights) {
  const LightTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int steps = shape.steps();
  const LaneShift shift;
  const PartVec part0(up.part), part1(down.part);
  const auto minusX = hn::Set(d, static_cast<std::int16_t>(-weights.x));
  const auto minusY = hn::Set(d, static_cast<std::int16_t>(-weights.y));
  const auto plane = static_cast<std::ptrdiff_t>(shape.plane());
  const auto handover = static_cast<std::ptrdiff_t>(shape.handover());

  const std::int16_t* HWY_RESTRICT clear0 = up.transmittance + lanes;
  const std::int16_t* HWY_RESTRICT clear1 = down.transmittance + lanes;
  std::int16_t* HWY_RESTRICT merged0 = up.merged + lanes;
  std::int16_t* HWY_RESTRICT merged1 = down.merged + lanes;
  std::int16_t* HWY_RESTRICT carried0 = up.carried + lanes;
  std::int16_t* HWY_RESTRICT carried1 = down.carried + lanes;
  // Read at one lane's y and written behind it, at the other's.
  std::int16_t* edge0 = up.edge + lanes;
  std::int16_t* edge1 = down.edge + lanes;
  const int readBehind = kForward ? 0 : lanes - 1, writeBehind = kForward ? lanes - 1 : 0;

  const auto full = hn::Set(d, static_cast<std::int16_t>(-kFullLight));
  LightVec before0[kFixedPlanes] = {full, full};
  LightVec before1[kFixedPlanes] = {full, full};
  Dither dither0(up.phase, weights), dither1(down.phase, weights);
  for (int n = 0; n < steps + kFixedPlanes - 1; ++n) {
    const auto offset0 = dither0.next(), offset1 = dither1.next();
    // From the last plane to the first: a plane reads what the one before held a step ago.
    HWY_UNROLL(2)
    for (int p = kFixedPlanes - 1; p >= 0; --p) {
      const std::ptrdiff_t t = kForward ? n - p : steps - 1 - (n - p);
      const std::ptrdiff_t at = t * lanes;
      const std::ptrdiff_t onEdge = p * handover + t;
      const auto below0 = p == 0 ? hn::Load(d, carried0 + at) : before0[p == 0 ? 0 : p - 1];
      const auto below1 = p == 0 ? hn::Load(d, carried1 + at) : before1[p == 0 ? 0 : p - 1];
      const auto beside0 = shift.up(before0[p], edge0[onEdge - readBehind]);
      const auto beside1 = shift.down(before1[p], edge1[onEdge - readBehind]);
      const auto light0 = arriving(minusX, minusY, offset0, beside0, before0[p], below0);
      const auto light1 = arriving(minusX, minusY, offset1, beside1, before1[p], below1);
      part0.store<kForward>(light0, merged0 + p * plane + at);
      part1.store<kForward>(light1, merged1 + p * plane + at);
      before0[p] = hn::MulFixedPoint15(light0, hn::Load(d, clear0 + p * plane + at));
      before1[p] = hn::MulFixedPoint15(light1, hn::Load(d, clear1 + p * plane + at));
      edge0[onEdge - writeBehind] = hn::ExtractLane(before0[p], static_cast<std::size_t>(lanes) - 1);
      edge1[onEdge - writeBehind] = hn::GetLane(before1[p]);
      if (p == kFixedPlanes - 1) {
        hn::Store(before0[p], d, carried0 + at);
        hn::Store(before1[p], d, carried1 + at);
      }
    }
  }
}

void sweepFixedColumnsOnTarget(const FixedColumn& up, const FixedColumn& down, const ColumnShape& shape,
                               FixedWeights weights, bool forward) {
  if (forward)
    sweepColumnsAs<true>(up, down, shape, weights);
  else
    sweepColumnsAs<false>(up, down, shape, weights);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(columnLanesOfTarget);
HWY_EXPORT(sweepFixedColumnsOnTarget);

int columnLanes() { return HWY_DYNAMIC_DISPATCH(columnLanesOfTarget)(); }

void sweepFixedColumns(const FixedColumn& up, const FixedColumn& down, const ColumnShape& shape, FixedWeights weights,
                       bool forward) {
  HWY_DYNAMIC_DISPATCH(sweepFixedColumnsOnTarget)(up, down, shape, weights, forward);
}

}  // namespace isolume
#endif
