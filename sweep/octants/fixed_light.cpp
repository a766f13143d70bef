#include "fixed_light.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/octants/fixed_light.cpp"
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

// e of the planes of one step after the other.
class Dither {
 public:
  Dither(int phase, FixedWeights weights) : phase_(phase), dithers_(weights.x < kHalf && weights.y < kHalf) {
    start(0);
  }
  // From the step on that comes `step`-th.
  HWY_INLINE void start(int step) {
    const int turn = ((phase_ + step) % kCycle + kCycle) % kCycle;
    turns_[0] = valueAt(turn);
    turns_[1] = valueAt((turn + 1) % kCycle);
    turns_[2] = valueAt((turn + 2) % kCycle);
  }
  HWY_INLINE LightVec of(int plane) const { return turns_[plane]; }
  HWY_INLINE void next() {
    const auto first = turns_[0];
    turns_[0] = turns_[1];
    turns_[1] = turns_[2];
    turns_[2] = first;
  }

 private:
  static constexpr int kCycle = 3;
  static_assert(kFixedPlanes <= kCycle);
  static constexpr std::int16_t kHalf = 1 << 14;
  HWY_INLINE LightVec valueAt(int turn) const {
    const int value = !dithers_ || turn == 0 ? 0 : turn == 1 ? 1 : -1;
    return hn::Set(LightTag(), static_cast<std::int16_t>(value));
  }
  int phase_;
  bool dithers_;
  LightVec turns_[kCycle];
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

// Whether vectors hold `value` alone.
HWY_INLINE bool allAre(const std::int16_t* vectors, int count, std::int16_t value) {
  const LightTag d;
  const auto wanted = hn::Set(d, value);
  auto other = hn::Zero(d);
  for (int i = 0; i < count; ++i)
    other = hn::Or(other, hn::Xor(hn::Load(d, vectors + i * static_cast<std::ptrdiff_t>(hn::Lanes(d))), wanted));
  return hn::AllTrue(d, hn::Eq(other, hn::Zero(d)));
}
// The same of kSegment values anywhere.
using SegmentTag = hn::CappedTag<std::int16_t, kSegment>;
HWY_INLINE bool segmentIs(const std::int16_t* values, std::int16_t value) {
  const SegmentTag d;
  auto other = hn::Zero(d);
  for (int i = 0; i < kSegment; i += static_cast<int>(hn::Lanes(d)))
    other = hn::Or(other, hn::Xor(hn::LoadU(d, values + i), hn::Set(d, value)));
  return hn::AllTrue(d, hn::Eq(other, hn::Zero(d)));
}
HWY_INLINE void fillSegment(std::int16_t* values, std::int16_t value) {
  const SegmentTag d;
  for (int i = 0; i < kSegment; i += static_cast<int>(hn::Lanes(d))) hn::StoreU(hn::Set(d, value), d, values + i);
}

// Adds to vectors of all planes, or sets them anew. Not a member: what a column's steps change stays in registers.
void addToPlanes(std::int16_t* vectors, std::ptrdiff_t plane, int count, std::int16_t value, bool anew) {
  const LightTag d;
  const auto added = hn::Set(d, value);
  for (int p = 0; p < kFixedPlanes; ++p)
    for (int i = 0; i < count; ++i) {
      std::int16_t* at = vectors + p * plane + i * static_cast<std::ptrdiff_t>(hn::Lanes(d));
      hn::Store(anew ? added : hn::Add(hn::Load(d, at), added), d, at);
    }
}

// A column on its way, segment by segment. kUp: up in x.
template <bool kForward, bool kUp>
class ColumnSweep {
 public:
  ColumnSweep(const FixedColumn& column, const ColumnShape& shape, FixedWeights weights)
      : column_(column),
        steps_(shape.steps()),
        plane_(static_cast<std::ptrdiff_t>(shape.plane())),
        handover_(static_cast<std::ptrdiff_t>(shape.handover())),
        edge_(column.edge + shape.lanes),
        part_(column.part),
        dither_(column.phase, weights),
        minusX_(hn::Set(LightTag(), static_cast<std::int16_t>(-weights.x))),
        minusY_(hn::Set(LightTag(), static_cast<std::int16_t>(-weights.y))) {
    for (auto& before : before_) before = hn::Set(LightTag(), static_cast<std::int16_t>(-kFullLight));
  }

  // Passes over a segment if it can, and says if not.
  HWY_INLINE bool enter(int segment) {
    const int first = segment * kSegment, count = std::min(kSegment, steps_ - first);
    const Content carried = column_.carriedContent[segment];
    Content& merged = column_.mergedContent[segment];
    if (!carried.even || !staysAs(segment, carried.value)) {
      if (!kForward && merged.even) addToPlanes(column_.merged + first * kLanes, plane_, count, merged.value, true);
      merged = {};
      dither_.start(kForward ? first : steps_ - first - count);
      return true;
    }
    for (int p = 0; p < kFixedPlanes; ++p) fillSegment(edge_ + p * handover_ + first - kWriteBehind, carried.value);
    const LightPart& part = column_.part;
    constexpr int kOne = 1 << 15;
    const int light = -carried.value, left = ((light - part.zero) * part.factor + kOne / 2) >> 15;
    const auto added = static_cast<std::int16_t>(kForward ? left : left * part.unit);
    if (kForward)
      merged = {true, added};
    else if (merged.even)
      merged.value = static_cast<std::int16_t>(merged.value + added);
    else if (added != 0)
      addToPlanes(column_.merged + first * kLanes, plane_, count, added, false);
    return false;
  }

  HWY_INLINE void step(std::ptrdiff_t t) {
    const LightTag d;
    const std::ptrdiff_t at = t * static_cast<std::ptrdiff_t>(hn::Lanes(d));
    auto below = hn::Load(d, column_.carried + at);
    HWY_UNROLL(2)
    for (int p = 0; p < kFixedPlanes; ++p) {
      const std::ptrdiff_t onEdge = p * handover_ + t, inPlane = p * plane_ + at;
      const std::int16_t in = edge_[onEdge - kReadBehind];
      const auto beside = kUp ? shift_.up(before_[p], in) : shift_.down(before_[p], in);
      const auto light = arriving(minusX_, minusY_, dither_.of(p), beside, before_[p], below);
      part_.template store<kForward>(light, column_.merged + inPlane);
      below = hn::MulFixedPoint15(light, hn::Load(d, column_.transmittance + inPlane));
      before_[p] = below;
      edge_[onEdge - kWriteBehind] = kUp ? hn::ExtractLane(below, kLanes - 1) : hn::GetLane(below);
    }
    hn::Store(below, d, column_.carried + at);
    dither_.next();
  }

  // After the steps of a segment.
  HWY_INLINE void leave(int segment) {
    const int first = segment * kSegment, count = std::min(kSegment, steps_ - first);
    const std::int16_t* carried = column_.carried + static_cast<std::ptrdiff_t>(first) * kLanes;
    const bool known = carried[0] == 0 || carried[0] == -kFullLight;
    column_.carriedContent[segment] = {known && allAre(carried, count, carried[0]), carried[0]};
  }

 private:
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(LightTag()));
  // An edge is read at one lane's y and written behind it, at the other's.
  static constexpr int kReadBehind = kForward ? 0 : kLanes - 1, kWriteBehind = kForward ? kLanes - 1 : 0;

  // Whether all that flows in beside what is carried has the value, and goes on as it.
  HWY_INLINE bool staysAs(int segment, std::int16_t value) const {
    const Content through = column_.transmittanceContent[segment];
    if (value != 0 && !(through.even && through.value == kClear)) return false;
    const LightTag d;
    auto other = hn::Zero(d);
    for (const auto& before : before_) other = hn::Or(other, hn::Xor(before, hn::Set(d, value)));
    if (!hn::AllTrue(d, hn::Eq(other, hn::Zero(d)))) return false;
    for (int p = 0; p < kFixedPlanes; ++p)
      if (!segmentIs(edge_ + p * handover_ + segment * kSegment - kReadBehind, value)) return false;
    return true;
  }
  FixedColumn column_;
  int steps_;
  std::ptrdiff_t plane_, handover_;
  std::int16_t* edge_;
  PartVec part_;
  Dither dither_;
  LightVec minusX_, minusY_, before_[kFixedPlanes];
  LaneShift shift_;
};

template <bool kForward>
void sweepColumnsAs(const FixedColumn& up, const FixedColumn& down, const ColumnShape& shape, FixedWeights weights) {
  ColumnSweep<kForward, true> first(up, shape, weights);
  ColumnSweep<kForward, false> second(down, shape, weights);
  const int segments = shape.segments();
  for (int i = 0; i < segments; ++i) {
    const int segment = kForward ? i : segments - 1 - i;
    const bool sweepFirst = first.enter(segment), sweepSecond = second.enter(segment);
    const int begin = segment * kSegment, end = std::min(begin + kSegment, shape.steps());
    const auto stepOf = [&](int n) { return kForward ? n : begin + end - 1 - n; };
    if (sweepFirst && sweepSecond) {
      for (int n = begin; n < end; ++n) {
        first.step(stepOf(n));
        second.step(stepOf(n));
      }
    } else if (sweepFirst) {
      for (int n = begin; n < end; ++n) first.step(stepOf(n));
    } else if (sweepSecond) {
      for (int n = begin; n < end; ++n) second.step(stepOf(n));
    }
    if (sweepFirst) first.leave(segment);
    if (sweepSecond) second.leave(segment);
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
