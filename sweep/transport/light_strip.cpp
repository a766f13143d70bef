#include "light_strip.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/transport/light_strip.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using WideTag = hn::ScalableTag<std::int16_t>;
// Where vectors are wide enough to be halved.
using NarrowTag = hn::CappedTag<std::int16_t, std::max<std::size_t>(HWY_MAX_BYTES / 2, 16) / sizeof(std::int16_t)>;

int ordinateLanesOfTarget() { return static_cast<int>(hn::Lanes(WideTag())); }

// Whether `count` vectors hold `value` alone.
template <class D>
HWY_INLINE bool vectorsAre(D d, const std::int16_t* vectors, int count, std::int16_t value) {
  const auto wanted = hn::Set(d, value);
  auto other = hn::Zero(d);
  for (int i = 0; i < count; ++i)
    other = hn::Or(other, hn::Xor(hn::Load(d, vectors + i * static_cast<std::ptrdiff_t>(hn::Lanes(d))), wanted));
  return hn::AllTrue(d, hn::Eq(other, hn::Zero(d)));
}
template <class D>
HWY_INLINE void fillVectors(D d, std::int16_t* vectors, int count, std::int16_t value) {
  for (int i = 0; i < count; ++i)
    hn::Store(hn::Set(d, value), d, vectors + i * static_cast<std::ptrdiff_t>(hn::Lanes(d)));
}

// Whether all that the steps of a segment pass is clear.
HWY_INLINE bool isClear(const LightStrip& strip, int first) {
  const hn::CappedTag<std::int16_t, kSegment> d;
  constexpr int kReach = kStripRows - 1 + kSegment;
  const auto clear = hn::Set(d, kClear);
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int begin = first - (kStripRows - 1);
  auto other = hn::Zero(d);
  for (const std::int16_t* row : strip.transmittance) {
    const std::int16_t* from = strip.direction > 0 ? row + begin : row - (begin + kReach - 1);
    for (int i = 0; i < kReach; i += lanes)
      other = hn::Or(other, hn::Xor(hn::LoadU(d, from + std::min(i, kReach - lanes)), clear));
  }
  return hn::AllTrue(d, hn::Eq(other, hn::Zero(d)));
}

// What a row hands on: its N in the last step and the one before, and the same of the plane below.
template <class D>
struct RowLight {
  hn::Vec<D> last, twoAgo, below, belowTwoAgo;
  HWY_INLINE explicit RowLight(hn::Vec<D> all) : last(all), twoAgo(all), below(all), belowTwoAgo(all) {}
  template <bool kDiagonals>
  HWY_INLINE hn::Vec<D> unlike([[maybe_unused]] D d, hn::Vec<D> value) const {
    auto other = hn::Xor(last, value);
    if constexpr (kDiagonals) {
      other = hn::Or(other, hn::Xor(twoAgo, value));
      other = hn::Or(other, hn::Or(hn::Xor(below, value), hn::Xor(belowTwoAgo, value)));
    }
    return other;
  }
};

template <class D, bool kDiagonals, bool kPowers>
class StripSweep {
 public:
  StripSweep(const LightStrip& strip, const StripOrdinates& ordinates)
      : strip_(strip),
        powers_(ordinates.powers),
        wx_(hn::Load(D(), ordinates.weights)),
        wy_(hn::Load(D(), ordinates.weights + kLanes)),
        wxy_(hn::Load(D(), ordinates.weights + 2 * kLanes)),
        wxz_(hn::Load(D(), ordinates.weights + 3 * kLanes)),
        wyz_(hn::Load(D(), ordinates.weights + 4 * kLanes)),
        wxyz_(hn::Load(D(), ordinates.weights + 5 * kLanes)),
        dither_(hn::Load(D(), ordinates.dither)) {}

  void sweep() {
    const int segments = stripSegments(strip_.count);
    for (int segment = 0; segment < segments; ++segment) {
      const int first = segment * kSegment, count = std::min(kSegment, stripSteps(strip_.count) - first);
      if (passOver(segment, first, count)) continue;
      const bool stores = strip_.wanted[segment] != 0;
      if (isClear(strip_, first))
        stores ? step<true, true>(first, count) : step<false, true>(first, count);
      else
        stores ? step<true, false>(first, count) : step<false, false>(first, count);
      strip_.visibilityContent[segment] = {};
      const std::int16_t* carried = strip_.carried + first * kStripRows * kLanes;
      const bool known =
          (carried[0] == 0 || carried[0] == -kFullLight) && carried[count * kStripRows * kLanes - 1] == carried[0];
      strip_.carriedContent[segment] = {known && vectorsAre(D(), carried, count * kStripRows, carried[0]), carried[0]};
    }
  }

 private:
  using V = hn::Vec<D>;
  static constexpr std::ptrdiff_t kLanes = hn::MaxLanes(D());
  static constexpr int kLag = kStripRows - 1;  // of what the last row hands on

  // Passes over a segment if it can.
  HWY_INLINE bool passOver(int segment, int first, int count) {
    const D d;
    const Content flowing = strip_.carriedContent[segment];
    if (!flowing.even) return false;
    const V value = hn::Set(d, flowing.value);
    auto other = hn::Or(rows_[0].template unlike<kDiagonals>(d, value), rows_[1].template unlike<kDiagonals>(d, value));
    other = hn::Or(other, rows_[2].template unlike<kDiagonals>(d, value));
    other = hn::Or(other, rows_[3].template unlike<kDiagonals>(d, value));
    if (kDiagonals) other = hn::Or(other, edge_.template unlike<kDiagonals>(d, value));
    std::int16_t* edge = strip_.edge + first * kLanes;
    if (!hn::AllTrue(d, hn::Eq(other, hn::Zero(d))) || !vectorsAre(d, edge, count, flowing.value)) return false;
    if (kDiagonals && !vectorsAre(d, strip_.before + first * kLanes, count, flowing.value)) return false;
    if (flowing.value != 0 && !isClear(strip_, first)) return false;
    fillVectors(d, edge - kLag * kLanes, kLag, flowing.value);
    const Content here{true, static_cast<std::int16_t>(-flowing.value)};
    Content& seen = strip_.visibilityContent[segment];
    if (strip_.wanted[segment] != 0 && !(seen == here)) {
      fillVectors(d, strip_.visibility + first * kStripRows * kLanes, count * kStripRows, here.value);
      seen = here;
    }
    return true;
  }

  // kAllClear: all that is passed lets light through.
  template <bool kStores, bool kAllClear>
  HWY_INLINE void step(int first, int count) {
    const D d;
    const V wx = wx_, wy = wy_, wxy = wxy_, wxz = wxz_, wyz = wyz_, wxyz = wxyz_;
    constexpr int kCycle = 3;
    const V dithers[kCycle] = {hn::Zero(d), dither_, hn::Neg(dither_)};
    const int phase = strip_.phase + first;
    V dither = dithers[phase % kCycle], next = dithers[(phase + 1) % kCycle], afterNext = dithers[(phase + 2) % kCycle];
    std::int16_t* HWY_RESTRICT edge = strip_.edge + first * kLanes;
    std::int16_t* before = strip_.before + first * kLanes;
    std::int16_t* HWY_RESTRICT carried = strip_.carried + first * kStripRows * kLanes;
    std::int16_t* HWY_RESTRICT visibility = strip_.visibility + first * kStripRows * kLanes;
    const std::ptrdiff_t direction = strip_.direction, start = first * direction;
    const std::int16_t* through0 = strip_.transmittance[0] + start;
    const std::int16_t* through1 = strip_.transmittance[1] + start - direction;
    const std::int16_t* through2 = strip_.transmittance[2] + start - 2 * direction;
    const std::int16_t* through3 = strip_.transmittance[3] + start - 3 * direction;
    const auto advance = [&](const RowLight<D>& up, RowLight<D>& own, int r, const std::int16_t* tau) HWY_ATTR {
      const V z = hn::Load(d, carried + r * kLanes), base = hn::Add(z, dither);
      const auto from = [&](V n, V w) HWY_ATTR { return hn::MulFixedPoint15(hn::SaturatedSub(n, base), w); };
      // A mean of N_x and N_z, which no rounding takes beyond what they hold; the others may.
      V light = hn::SaturatedAdd(hn::Sub(from(own.last, wx), z), from(up.last, wy));
      if constexpr (kDiagonals) {
        light = hn::SaturatedAdd(light, hn::SaturatedAdd(from(up.twoAgo, wxy), from(own.below, wxz)));
        light = hn::SaturatedAdd(light, hn::SaturatedAdd(from(up.below, wyz), from(up.belowTwoAgo, wxyz)));
        own.twoAgo = own.last;
        own.belowTwoAgo = own.below;
        own.below = z;
      }
      light = hn::Max(light, hn::Zero(d));
      if constexpr (kStores) hn::Store(light, d, visibility + r * kLanes);
      constexpr int kUnits = -kClear / kPowerSteps;
      if constexpr (kAllClear)
        own.last = hn::Neg(light);
      else if constexpr (kPowers)
        own.last = hn::MulFixedPoint15(light, hn::Load(d, powers_ + (kUnits / 2 - *tau) / kUnits * kLanes));
      else
        own.last = hn::MulFixedPoint15(light, hn::Set(d, *tau));
      hn::Store(own.last, d, carried + r * kLanes);
    };
    RowLight<D> row0 = rows_[0], row1 = rows_[1], row2 = rows_[2], row3 = rows_[3], above = edge_;
    for (int t = 0; t < count; ++t) {
      above.twoAgo = above.last;
      above.last = hn::Load(d, edge);
      if constexpr (kDiagonals) {
        above.belowTwoAgo = above.below;
        above.below = hn::Load(d, before);
        hn::Store(above.last, d, before);
        before += kLanes;
      }
      // From the last row on: each reads what the row before it had in the steps before.
      advance(row2, row3, 3, through3);
      advance(row1, row2, 2, through2);
      advance(row0, row1, 1, through1);
      advance(above, row0, 0, through0);
      hn::Store(row3.last, d, edge - kLag * kLanes);
      through0 += direction;
      through1 += direction;
      through2 += direction;
      through3 += direction;
      edge += kLanes;
      carried += kStripRows * kLanes;
      if constexpr (kStores) visibility += kStripRows * kLanes;
      const V turned = dither;
      dither = next;
      next = afterNext;
      afterNext = turned;
    }
    rows_[0] = row0;
    rows_[1] = row1;
    rows_[2] = row2;
    rows_[3] = row3;
    edge_ = above;
  }

  const LightStrip& strip_;
  const std::int16_t* powers_;
  V wx_, wy_, wxy_, wxz_, wyz_, wxyz_, dither_;
  RowLight<D> edge_{hn::Set(D(), static_cast<std::int16_t>(-kFullLight))};
  RowLight<D> rows_[kStripRows] = {edge_, edge_, edge_, edge_};
};

template <class D, bool kDiagonals, bool kPowers>
void sweepStripAs(D, const LightStrip& strip, const StripOrdinates& ordinates) {
  StripSweep<D, kDiagonals, kPowers>(strip, ordinates).sweep();
}

template <class D>
void sweepStripIn(D d, const LightStrip& strip, const StripOrdinates& ordinates) {
  if (ordinates.diagonals)
    ordinates.powers ? sweepStripAs<D, true, true>(d, strip, ordinates)
                     : sweepStripAs<D, true, false>(d, strip, ordinates);
  else
    ordinates.powers ? sweepStripAs<D, false, true>(d, strip, ordinates)
                     : sweepStripAs<D, false, false>(d, strip, ordinates);
}

void sweepLightStripOnTarget(const LightStrip& strip, const StripOrdinates& ordinates) {
  if (ordinates.lanes == static_cast<int>(hn::Lanes(WideTag())))
    sweepStripIn(WideTag(), strip, ordinates);
  else
    sweepStripIn(NarrowTag(), strip, ordinates);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(ordinateLanesOfTarget);
HWY_EXPORT(sweepLightStripOnTarget);

int ordinateLanes() { return HWY_DYNAMIC_DISPATCH(ordinateLanesOfTarget)(); }

void sweepLightStrip(const LightStrip& strip, const StripOrdinates& ordinates) {
  HWY_DYNAMIC_DISPATCH(sweepLightStripOnTarget)(strip, ordinates);
}

}  // namespace isolume
#endif
