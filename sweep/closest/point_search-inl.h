// One look at the interpolant for a vector of searches, and where each looks next (point_kernels.h).
// Included once per SIMD target.
#if defined(ISOLUME_POINT_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUME_POINT_SEARCH_INL_H_
#undef ISOLUME_POINT_SEARCH_INL_H_
#else
#define ISOLUME_POINT_SEARCH_INL_H_
#endif

#include "point_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

// A step that promises to shorten the distance by no more than this, in smallest spacings, is not taken.
inline constexpr float kSettledGain = 1e-5F;
// What may be left where nothing nearer is found: more than this and the search is stuck.
inline constexpr float kStuckGain = 1e-3F;
inline constexpr float kMostTries = 14;           // looks without a nearer point; creases need about ten
inline constexpr float kSteepEnough = 1.0F / 64;  // of the cell's largest level per smallest spacing
inline constexpr float kLongestStep = 1.5F;       // in smallest spacings; steps longer than this and the offset are cut

// One vector of PointBatch.
struct Search {
  Vec3 best, trial, retreat;
  FloatVec nearest, promised, share, tries;
  FloatMask settled, stuck, failed;  // none of them: still searching
};

HWY_INLINE void lookOnce(const VectorLevel& level, const VectorSamples& samples, Search& search) {
  const FloatTag d;
  const auto zero = hn::Zero(d), half = hn::Set(d, 0.5F), one = hn::Set(d, 1.0F);
  const Vec3& step = level.step;
  const Vec3& inverse = level.inverse;
  const auto tolerance = hn::Set(d, static_cast<float>(kOnSurface * kOnSurface));
  const auto steepEnough = hn::Set(d, kSteepEnough * kSteepEnough);
  const auto within = [](FloatVec r, FloatVec low, FloatVec high) { return hn::Min(hn::Max(r, low), high); };
  const auto searching = hn::Not(hn::Or(search.settled, hn::Or(search.stuck, search.failed)));

  const Vec3 rel = {within(hn::Mul(search.trial.x, inverse.x), samples.low.x, samples.high.x),
                    within(hn::Mul(search.trial.y, inverse.y), samples.low.y, samples.high.y),
                    within(hn::Mul(search.trial.z, inverse.z), samples.low.z, samples.high.z)};
  Vec3 here = {hn::Mul(rel.x, step.x), hn::Mul(rel.y, step.y), hn::Mul(rel.z, step.z)};
  VectorPoint point = pointAt(level, samples, rel);
  auto steepness = dot(point.gradient, point.gradient);
  const auto flat = hn::AndNot(hn::Ge(steepness, steepEnough), point.mixed);
  auto perSteepness = hn::Div(one, steepness);
  auto multiplier = hn::Neg(hn::Mul(dot(here, point.gradient), perSteepness));
  Vec3 tangential = scaled(added(here, scaled(point.gradient, multiplier)), hn::Neg(one));

  // What lies at the border and would go on outwards keeps its place along that axis: the same equations without it.
  const auto outX = leadsOut(rel.x, samples.low.x, samples.high.x, tangential.x);
  const auto outY = leadsOut(rel.y, samples.low.y, samples.high.y, tangential.y);
  const auto outZ = leadsOut(rel.z, samples.low.z, samples.high.z, tangential.z);
  const bool border = !hn::AllFalse(d, hn::And(searching, hn::Or(outX, hn::Or(outY, outZ))));
  const auto keep = [&](const Vec3& v) {
    return Vec3{hn::IfThenZeroElse(outX, v.x), hn::IfThenZeroElse(outY, v.y), hn::IfThenZeroElse(outZ, v.z)};
  };
  if (border) {
    point.gradient = keep(point.gradient);
    point.twist = {hn::IfThenZeroElse(hn::Or(outY, outZ), point.twist.x),
                   hn::IfThenZeroElse(hn::Or(outX, outZ), point.twist.y),
                   hn::IfThenZeroElse(hn::Or(outX, outY), point.twist.z)};
    steepness = dot(point.gradient, point.gradient);
    perSteepness = hn::Div(one, steepness);
    multiplier = hn::Neg(hn::Mul(dot(here, point.gradient), perSteepness));
    tangential = keep(scaled(added(here, scaled(point.gradient, multiplier)), hn::Neg(one)));
  }
  const auto movable = hn::And(point.mixed, hn::Ge(steepness, steepEnough));

  // The step straight to the surface, and whether it ends there: a short step within the cell, since the interpolant
  // leaves its tangent plane by `bend` times the square at most.
  const auto perValue = hn::Mul(point.value, perSteepness);
  const Vec3 straight = scaled(point.gradient, hn::Neg(perValue));
  const auto squared = dot(straight, straight);
  const auto left = hn::Mul(point.bend, squared);
  const auto staysIn = [&](FloatVec place, FloatVec move, FloatVec perStep) {
    const auto moved = hn::Add(place, hn::Mul(move, perStep));
    return hn::And(hn::Ge(moved, zero), hn::Le(moved, one));
  };
  const auto inCell =
      hn::And(staysIn(point.place.x, straight.x, inverse.x),
              hn::And(staysIn(point.place.y, straight.y, inverse.y), staysIn(point.place.z, straight.z, inverse.z)));
  const auto lands = hn::And(hn::And(movable, inCell), hn::Le(hn::Mul(left, left), hn::Mul(tolerance, steepness)));
  const auto onSurface = hn::Or(lands, hn::And(movable, hn::Le(squared, tolerance)));
  here = chosen(lands, added(here, straight), here);
  multiplier = hn::IfThenElse(lands, hn::Add(multiplier, perValue), multiplier);
  point.value = hn::IfThenZeroElse(lands, point.value);
  const Vec3 toSurface = {hn::IfThenZeroElse(lands, straight.x), hn::IfThenZeroElse(lands, straight.y),
                          hn::IfThenZeroElse(lands, straight.z)};

  const auto length = dot(here, here);
  const auto nearer = hn::And(searching, hn::And(onSurface, hn::Le(length, search.nearest)));
  const auto gain = hn::Mul(half, dot(tangential, tangential));
  search.best = chosen(nearer, here, search.best);
  search.nearest = hn::IfThenElse(nearer, length, search.nearest);
  search.retreat = chosen(nearer, tangential, search.retreat);
  search.promised = hn::IfThenElse(nearer, gain, search.promised);
  search.share = hn::IfThenElse(nearer, one, search.share);
  search.tries = hn::IfThenElse(nearer, zero, hn::Add(search.tries, one));

  // Half the square of a short step along the tangent plane, over the distance, is what it shortens the distance by.
  const auto promises = [&](float most) {
    return hn::Gt(hn::Mul(search.promised, search.promised), hn::Mul(hn::Set(d, most * most), search.nearest));
  };
  const auto tired = hn::And(searching, hn::Gt(search.tries, hn::Set(d, kMostTries)));
  const auto small = hn::AndNot(promises(kSettledGain), nearer);
  search.settled = hn::Or(search.settled, hn::Or(small, hn::AndNot(promises(kStuckGain), tired)));
  search.stuck = hn::Or(search.stuck, hn::And(tired, promises(kStuckGain)));
  search.failed = hn::Or(search.failed, hn::And(searching, flat));

  // From a point that counts, and from the first trial: Newton's step. From elsewhere: straight to the surface. Where
  // that was lost, or reached in vain: back to the best point and a part of its tangential step.
  const auto unconfirmed = hn::Ge(search.promised, hn::Set(d, kNothingPromised));
  const auto first = hn::And(unconfirmed, hn::Eq(search.tries, one));
  const Vec3 newton = newtonOr(added(tangential, toSurface), point, border ? keep(here) : here, multiplier);
  Vec3 move = chosen(hn::Or(nearer, first), newton, toSurface);
  const auto squaredMove = dot(move, move);
  const auto limit = hn::Max(hn::Set(d, kLongestStep * kLongestStep), length);
  const auto tooFar = hn::Gt(squaredMove, limit);
  if (!hn::AllFalse(d, tooFar)) move = chosen(tooFar, scaled(move, hn::Sqrt(hn::Div(limit, squaredMove))), move);
  const auto back = hn::Or(hn::AndNot(nearer, onSurface), hn::Not(movable));
  search.trial = chosen(back, added(search.best, scaled(search.retreat, search.share)), added(here, move));
  search.share = hn::IfThenElse(back, hn::Mul(half, search.share), search.share);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
