// The upwind update of vectors of voxels, for inclusion by SIMD code once per target (hence -inl and no usual guard).
//
// [Singh10] Sec. 1.1, [Zhao05] Eq. 2.3: d is the solution of  r(d) = sum over axes max(0, (d - a_i) / h_i)^2 = 1,  a_i
// the neighbours' distances. Here d is by definition the smallest even float (lowest bit of the mantissa clear:
// surface_start.h) whose r, in float, sorted terms, reaches 1. Every operation of r is monotone under correct rounding,
// so d is exactly monotone in each a_i and does not depend on the order of the axes. What follows from that:
//   a value is lowered if and only if r just below it reaches 1, which needs no root;
//   sweeps from +inf down in any order end at the same values, the greatest fixed point, to the last bit;
//   clipping all values at a bound changes none below it.
// A closed form finds d within a step or two: with b, c the distances of the second and third nearest above the first,
// w_i = 1 / h_i^2,
//   one:   d - a1 = h1
//   two:   d - a1 = (w2 b + sqrt(w1 + w2 - w1 w2 b^2)) / (w1 + w2)                                        if d > a2
//   three: d - a1 = (w2 b + w3 c + sqrt(W - w1 w2 b^2 - w1 w3 c^2 - w2 w3 (b - c)^2)) / W,  W = w1 + w2 + w3   if d >
//   a3
#if defined(ISOLUME_SWEEP_UPWIND_UPDATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUME_SWEEP_UPWIND_UPDATE_INL_H
#undef ISOLUME_SWEEP_UPWIND_UPDATE_INL_H
#else
#define ISOLUME_SWEEP_UPWIND_UPDATE_INL_H
#endif

#include <hwy/highway.h>

#include "surface_start.h"
#include "sweep_tile.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using FloatVec = hn::Vec<FloatTag>;
using FloatMask = hn::Mask<FloatTag>;

// Distances of the three upwind neighbours, >= 0.
struct Upwind {
  FloatVec x, y, z;
};

// The metric in registers.
struct VectorMetric {
  FloatVec hx, hy, hz;  // spacing
  FloatVec wx, wy, wz;  // 1 / spacing^2
};
HWY_INLINE VectorMetric vectorMetric(const SweepMetric& metric) {
  const FloatTag d;
  return {hn::Set(d, metric.spacing.x),       hn::Set(d, metric.spacing.y),       hn::Set(d, metric.spacing.z),
          hn::Set(d, metric.inverseSquare.x), hn::Set(d, metric.inverseSquare.y), hn::Set(d, metric.inverseSquare.z)};
}

// The even floats next to an even positive one.
HWY_INLINE FloatVec evenBelow(FloatVec value) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> du;
  return hn::BitCast(d, hn::Sub(hn::BitCast(du, value), hn::Set(du, 2)));
}
HWY_INLINE FloatVec evenAbove(FloatVec value) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> du;
  return hn::BitCast(d, hn::Add(hn::BitCast(du, value), hn::Set(du, 2)));
}
HWY_INLINE FloatVec withoutFixedBit(FloatVec value) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> du;
  return hn::BitCast(d, hn::AndNot(hn::Set(du, kFixedBit), hn::BitCast(du, value)));
}
HWY_INLINE FloatMask fixedLanes(FloatVec value) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> du;
  return hn::RebindMask(d, hn::TestBit(hn::BitCast(du, value), hn::Set(du, kFixedBit)));
}

// The three terms of r(value).
template <bool kIsotropic>
HWY_INLINE Upwind residualTerms(FloatVec value, const Upwind& a, const VectorMetric& metric) {
  const auto zero = hn::Zero(FloatTag());
  const auto x = hn::Max(hn::Sub(value, a.x), zero);
  const auto y = hn::Max(hn::Sub(value, a.y), zero);
  const auto z = hn::Max(hn::Sub(value, a.z), zero);
  if constexpr (kIsotropic) return {hn::Mul(x, x), hn::Mul(y, y), hn::Mul(z, z)};
  return {hn::Mul(metric.wx, hn::Mul(x, x)), hn::Mul(metric.wy, hn::Mul(y, y)), hn::Mul(metric.wz, hn::Mul(z, z))};
}

HWY_INLINE Upwind sorted(const Upwind& a) {
  const auto low = hn::Min(a.x, a.y);
  const auto high = hn::Max(a.x, a.y);
  const auto middle = hn::Max(low, a.z);
  return {hn::Min(low, a.z), hn::Min(high, middle), hn::Max(high, middle)};
}

// r(value) >= 1. In the isotropic case `a` is sorted, nearest first, so its terms are too.
template <bool kIsotropic>
HWY_INLINE FloatMask reachesOne(FloatVec value, const Upwind& a, const VectorMetric& metric) {
  Upwind terms = residualTerms<kIsotropic>(value, a, metric);
  if constexpr (!kIsotropic) {
    const Upwind rising = sorted(terms);
    terms = {rising.z, rising.y, rising.x};
  }
  return hn::Ge(hn::Add(hn::Add(terms.z, terms.y), terms.x), hn::Set(FloatTag(), 1.0F));
}

// Lanes that the update may lower; all that it does, and hardly another.
template <bool kIsotropic>
HWY_INLINE FloatMask mayLower(FloatVec magnitude, const Upwind& a, const VectorMetric& metric) {
  const FloatTag d;
  // Three additions in another order differ by less than this from the sorted ones.
  constexpr float kAlmostOne = 1 - 0x1p-21F;
  const Upwind terms = residualTerms<kIsotropic>(evenBelow(magnitude), a, metric);
  const auto sum = hn::Add(hn::Add(terms.x, terms.y), terms.z);
  const auto fixed = fixedLanes(magnitude);
  const auto lowers = hn::AndNot(fixed, hn::Ge(sum, hn::Set(d, kAlmostOne)));
  if constexpr (kIsotropic) return lowers;
  const auto nearest = hn::Min(hn::Min(hn::Add(a.x, metric.hx), hn::Add(a.y, metric.hy)), hn::Add(a.z, metric.hz));
  // Start values only: what lies outside the grid is fixed too.
  const auto start = hn::And(fixed, hn::Lt(magnitude, hn::Set(d, kUnsetDistance)));
  return hn::Or(lowers, hn::And(start, hn::Lt(nearest, magnitude)));
}

// The closed form, at equal spacings; `a` sorted. One root: the case is chosen before.
HWY_INLINE FloatVec estimateIsotropic(const Upwind& a) {
  const FloatTag d;
  const auto one = hn::Set(d, 1.0F);
  const auto b = hn::Sub(a.y, a.x);
  const auto c = hn::Sub(a.z, a.x);
  const auto bc = hn::Sub(c, b);
  const auto bb = hn::Mul(b, b);
  const auto ccbc = hn::Add(hn::Mul(c, c), hn::Mul(bc, bc));
  const auto isThree = hn::Lt(ccbc, one);  // r(a3) < 1
  const auto isTwo = hn::Lt(b, one);       // r(a2) < 1
  const auto square = hn::IfThenElse(isTwo, hn::Sub(hn::Set(d, 2.0F), bb), one);
  const auto root = hn::Sqrt(hn::IfThenElse(isThree, hn::Sub(hn::Sub(hn::Set(d, 3.0F), bb), ccbc), square));
  const auto linear = hn::IfThenElse(isThree, hn::Add(b, c), hn::IfThenElseZero(isTwo, b));
  const auto share = hn::IfThenElse(isThree, hn::Set(d, 1.0F / 3.0F), hn::IfThenElse(isTwo, hn::Set(d, 0.5F), one));
  return hn::Add(a.x, hn::Mul(share, hn::Add(linear, root)));
}

// One neighbour's distance together with the metric of its axis.
struct Axis {
  FloatVec distance, spacing, weight;
};
HWY_INLINE void order(Axis& a, Axis& b) {
  const auto swap = hn::Lt(b.distance, a.distance);
  const Axis nearer{hn::IfThenElse(swap, b.distance, a.distance), hn::IfThenElse(swap, b.spacing, a.spacing),
                    hn::IfThenElse(swap, b.weight, a.weight)};
  b = {hn::IfThenElse(swap, a.distance, b.distance), hn::IfThenElse(swap, a.spacing, b.spacing),
       hn::IfThenElse(swap, a.weight, b.weight)};
  a = nearer;
}
HWY_INLINE FloatVec estimateAnisotropic(const Upwind& a, const VectorMetric& metric) {
  Axis first{a.x, metric.hx, metric.wx};
  Axis second{a.y, metric.hy, metric.wy};
  Axis third{a.z, metric.hz, metric.wz};
  order(first, second);
  order(second, third);
  order(first, second);
  const auto one = hn::Set(FloatTag(), 1.0F);
  const auto w1 = first.weight;
  const auto w2 = second.weight;
  const auto w3 = third.weight;
  const auto b = hn::Sub(second.distance, first.distance);
  const auto c = hn::Sub(third.distance, first.distance);
  const auto bc = hn::Sub(c, b);
  const auto w12 = hn::Add(w1, w2);
  const auto onB = hn::Mul(w1, hn::Mul(b, b));
  const auto onC = hn::Add(hn::Mul(w1, hn::Mul(c, c)), hn::Mul(w2, hn::Mul(bc, bc)));
  const auto isThree = hn::Lt(onC, one);
  const auto isTwo = hn::Lt(onB, one);
  const auto weight = hn::IfThenElse(isThree, hn::Add(w12, w3), hn::IfThenElse(isTwo, w12, w1));
  const auto lessTwo = hn::IfThenElseZero(isTwo, hn::Mul(w2, onB));
  const auto less = hn::IfThenElse(isThree, hn::Add(lessTwo, hn::Mul(w3, onC)), lessTwo);
  const auto linearTwo = hn::IfThenElseZero(isTwo, hn::Mul(w2, b));
  const auto linear = hn::IfThenElse(isThree, hn::Add(linearTwo, hn::Mul(w3, c)), linearTwo);
  return hn::Add(first.distance, hn::Div(hn::Add(linear, hn::Sqrt(hn::Sub(weight, less))), weight));
}

// The new magnitude of lanes that mayLower() names; the others keep theirs. A call costs nothing that could be
// measured, and inlining it into every unrolled plane costs minutes of compiling with sanitizers.
template <bool kIsotropic>
HWY_NOINLINE FloatVec lowered(FloatVec magnitude, FloatMask lanes, Upwind a, const VectorMetric& metric) {
  if constexpr (kIsotropic) a = sorted(a);
  const auto estimate = kIsotropic ? estimateIsotropic(a) : estimateAnisotropic(a, metric);
  auto value = withoutFixedBit(estimate);
  for (;;) {
    const auto below = evenBelow(value);
    const auto down = hn::And(lanes, reachesOne<kIsotropic>(below, a, metric));
    const auto up = hn::AndNot(reachesOne<kIsotropic>(value, a, metric), lanes);
    value = hn::IfThenElse(down, below, hn::IfThenElse(up, evenAbove(value), value));
    if (hn::AllFalse(FloatTag(), hn::Or(down, up))) break;
  }
  if constexpr (!kIsotropic) {
    // A start value is fixed but for one thing: it exceeds no neighbour's by more than the spacing.
    const FloatTag d;
    const hn::RebindToUnsigned<FloatTag> du;
    const auto nearest = hn::Min(hn::Min(hn::Add(a.x, metric.hx), hn::Add(a.y, metric.hy)), hn::Add(a.z, metric.hz));
    const auto tagged = hn::BitCast(d, hn::Or(hn::BitCast(du, nearest), hn::Set(du, kFixedBit)));
    value = hn::IfThenElse(fixedLanes(magnitude), tagged, value);
  }
  return hn::IfThenElse(lanes, hn::Min(magnitude, value), magnitude);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
