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
inline constexpr float kMostTries = 14;           // looks without a nearer point
inline constexpr float kSteepEnough = 1.0F / 64;  // of the cell's largest level per smallest spacing
inline constexpr float kLongestStep = 1.5F;       // in smallest spacings; steps longer than this and the offset are cut
// How far beyond the face of a cell a search is put that goes there, in samples: more than the rounding of places.
inline constexpr float kBeyondFace = 0x1p-17F;
// Search::share of one that has been put at a face.
inline constexpr float kAtFace = 0;

// One vector of PointBatch.
struct Search {
  Vec3 best, trial, retreat;
  FloatVec nearest, promised, share, tries;
  FloatMask settled, stuck, failed;  // none of them: still searching
};

// The share of a step that leads just into the next cell.
HWY_INLINE FloatVec shareToFace(const Vec3& from, const Vec3& step, const Vec3& inverse) {
  const FloatTag d;
  const auto toFace = [&](FloatVec offset, FloatVec move, FloatVec perStep) {
    const auto rel = hn::Mul(offset, perStep);
    const auto place = hn::Sub(rel, hn::Floor(rel));
    const auto way = hn::IfThenElse(hn::Lt(move, hn::Zero(d)), place, hn::Sub(hn::Set(d, 1.0F), place));
    // At a face the place does not say which cell the step was found in.
    const auto isAtFace = hn::Le(hn::Abs(hn::Sub(rel, hn::Round(rel))), hn::Set(d, kBeyondFace / 2));
    return hn::Div(hn::Add(hn::IfThenZeroElse(isAtFace, way), hn::Set(d, kBeyondFace)),
                   hn::Abs(hn::Mul(move, perStep)));
  };
  return hn::Min(toFace(from.x, step.x, inverse.x),
                 hn::Min(toFace(from.y, step.y, inverse.y), toFace(from.z, step.z, inverse.z)));
}

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

  // What lies at the border and would go on outwards keeps its place along that axis: the same equations without it. So
  // does what has come to the face of a cell and would go back at once: both cells lead to the crease between them.
  const auto atFace = hn::Eq(search.share, hn::Set(d, kAtFace));
  const auto nearLow = hn::Set(d, 2 * kBeyondFace), nearHigh = hn::Set(d, 1 - 2 * kBeyondFace);
  const auto creaseX = hn::And(atFace, leadsOut(point.place.x, nearLow, nearHigh, tangential.x));
  const auto creaseY = hn::And(atFace, leadsOut(point.place.y, nearLow, nearHigh, tangential.y));
  const auto creaseZ = hn::And(atFace, leadsOut(point.place.z, nearLow, nearHigh, tangential.z));
  const auto outX = hn::Or(creaseX, leadsOut(rel.x, samples.low.x, samples.high.x, tangential.x));
  const auto outY = hn::Or(creaseY, leadsOut(rel.y, samples.low.y, samples.high.y, tangential.y));
  const auto outZ = hn::Or(creaseZ, leadsOut(rel.z, samples.low.z, samples.high.z, tangential.z));
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
  const auto onCrease = hn::And(onSurface, hn::Or(creaseX, hn::Or(creaseY, creaseZ)));
  auto nearer = hn::And(searching, hn::And(onSurface, hn::Lt(length, search.nearest)));
  const auto gain = hn::Mul(half, dot(tangential, tangential));
  // On a crease the best point may lie as much nearer as this one lies beyond the face. It stays where nothing is left
  // to gain along the crease.
  auto atBest = hn::AndNot(nearer, hn::And(searching, onCrease));
  if (!hn::AllFalse(d, atBest)) {
    const auto reach = hn::Add(hn::Sqrt(search.nearest), hn::Set(d, kBeyondFace));
    atBest = hn::And(atBest, hn::Le(length, hn::Mul(reach, reach)));
    const auto toGain = hn::Gt(hn::Mul(gain, gain), hn::Mul(hn::Set(d, kSettledGain * kSettledGain), length));
    nearer = hn::Or(nearer, hn::And(atBest, toGain));
    atBest = hn::AndNot(toGain, atBest);
    search.settled = hn::Or(search.settled, atBest);
  }
  search.best = chosen(nearer, here, search.best);
  search.nearest = hn::IfThenElse(nearer, length, search.nearest);
  search.retreat = chosen(nearer, tangential, search.retreat);
  search.promised = hn::IfThenElse(nearer, gain, search.promised);
  search.share = hn::IfThenElse(hn::AndNot(onCrease, nearer), one, search.share);
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
  search.trial = added(here, move);
  if (hn::AllFalse(d, back)) return;
  // The first time, no further than into the next cell; there the step may be another.
  const auto share = hn::IfThenElse(atFace, half, search.share);
  const auto toFace = shareToFace(search.best, search.retreat, inverse);
  const auto fresh = hn::Or(hn::Eq(search.share, one), hn::And(atFace, hn::Eq(search.tries, one)));
  const auto halts = hn::And(fresh, hn::Lt(toFace, one));
  const auto part = hn::IfThenElse(halts, toFace, share);
  const auto next = hn::IfThenElse(halts, hn::Set(d, kAtFace), hn::Mul(half, share));
  search.trial = chosen(back, added(search.best, scaled(search.retreat, part)), search.trial);
  search.share = hn::IfThenElse(back, next, search.share);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
