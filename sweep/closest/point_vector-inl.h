// One vector of samples on the way to their closest points (point_kernels.h). Included once per SIMD target.
#if defined(ISOLUME_POINT_VECTOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUME_POINT_VECTOR_INL_H_
#undef ISOLUME_POINT_VECTOR_INL_H_
#else
#define ISOLUME_POINT_VECTOR_INL_H_
#endif

#include <hwy/highway.h>

#include "closest_point.h"
#include "point_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::CappedTag<float, kBatchGroup>;
using IntTag = hn::RebindToSigned<FloatTag>;
using FloatVec = hn::Vec<FloatTag>;
using IntVec = hn::Vec<IntTag>;
using FloatMask = hn::Mask<FloatTag>;

inline constexpr float kPointTries = 5;            // evaluations without a nearer point, the last of them in vain
inline constexpr float kShortEnough = 1e-6F;       // of a shortening, in smallest spacings; kSettled of closest_point.cpp
inline constexpr float kSteepEnough = 1.0F / 64;   // of a cell's largest level per smallest spacing
inline constexpr float kLongestStep = 1.5F;        // in smallest spacings; a step longer than this and the offset is cut

inline constexpr float kStartSlack = static_cast<float>(2 * kOnSurface);

struct Vec3 {
  FloatVec x, y, z;
};

HWY_INLINE FloatVec dot(const Vec3& a, const Vec3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vec3 scaled(const Vec3& a, FloatVec s) { return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)}; }
HWY_INLINE Vec3 added(const Vec3& a, const Vec3& b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)}; }
HWY_INLINE Vec3 chosen(FloatMask m, const Vec3& yes, const Vec3& no) {
  return {hn::IfThenElse(m, yes.x, no.x), hn::IfThenElse(m, yes.y, no.y), hn::IfThenElse(m, yes.z, no.z)};
}
HWY_INLINE Vec3 loadBatch(const std::vector<float>* from, std::size_t i) {
  const FloatTag d;
  return {hn::LoadU(d, from[0].data() + i), hn::LoadU(d, from[1].data() + i), hn::LoadU(d, from[2].data() + i)};
}
HWY_INLINE void storeBatch(const Vec3& v, std::vector<float>* to, std::size_t i) {
  const FloatTag d;
  hn::StoreU(v.x, d, to[0].data() + i);
  hn::StoreU(v.y, d, to[1].data() + i);
  hn::StoreU(v.z, d, to[2].data() + i);
}

// LevelAtPoint for a vector of points; levels divided by a power of two near the cell's largest.
struct VectorPoint {
  FloatVec value;
  Vec3 gradient, twist;
  FloatVec bend;
  Vec3 place;  // in the cell, 0 to 1
  FloatMask mixed;
};

// The cells around the samples of one plane.
struct VectorLevel {
  VectorLevel(const PointFrame& frame_, int z_)
      : frame(frame_), z(z_), firstPlane(std::max(z_ - kPointReach, 0)),
        base(frame_.level + firstPlane * (static_cast<std::ptrdiff_t>(frame_.size.x) * frame_.size.y)) {}

  const PointFrame& frame;
  int z, firstPlane;
  const float* base;
};

// Where the points of one vector of samples may lie, relative to the sample, in samples: the grid, cut at kPointReach.
struct Bounds {
  Vec3 low, high;
  IntVec lastX, lastY, lastZ;  // the last cell along each axis
  IntVec firstX, firstY, firstZ;
};

HWY_INLINE VectorPoint pointAt(const VectorLevel& level, IntVec x, IntVec y, const Bounds& bounds, const Vec3& rel) {
  const FloatTag d;
  const IntTag di;
  const PointFrame& frame = level.frame;
  const auto cellOf = [&](FloatVec r, IntVec first, IntVec last) {
    return hn::Max(hn::Min(hn::ConvertTo(di, hn::Floor(r)), last), first);
  };
  const auto cx = cellOf(rel.x, bounds.firstX, bounds.lastX);
  const auto cy = cellOf(rel.y, bounds.firstY, bounds.lastY);
  const auto cz = cellOf(rel.z, bounds.firstZ, bounds.lastZ);
  const auto tx = hn::Sub(rel.x, hn::ConvertTo(d, cx));
  const auto ty = hn::Sub(rel.y, hn::ConvertTo(d, cy));
  const auto tz = hn::Sub(rel.z, hn::ConvertTo(d, cz));
  const auto plane = hn::Add(cz, hn::Set(di, level.z - level.firstPlane));
  const auto row = hn::Add(hn::Mul(plane, hn::Set(di, frame.size.y)), hn::Add(y, cy));
  const auto at = hn::Add(hn::Mul(row, hn::Set(di, frame.size.x)), hn::Add(x, cx));
  const std::ptrdiff_t nextX = frame.size.x > 1 ? 1 : 0;
  const std::ptrdiff_t nextY = frame.size.y > 1 ? frame.size.x : 0;
  const std::ptrdiff_t nextZ = frame.size.z > 1 ? static_cast<std::ptrdiff_t>(frame.size.x) * frame.size.y : 0;
  FloatVec c[8];
  for (int i = 0; i < 8; ++i)
    c[i] = hn::GatherIndex(d, level.base + ((i & 1) * nextX + (i >> 1 & 1) * nextY + (i >> 2) * nextZ), at);
  auto highest = c[0], lowest = c[0];
  for (int i = 1; i < 8; ++i) {
    highest = hn::Max(highest, c[i]);
    lowest = hn::Min(lowest, c[i]);
  }
  VectorPoint point;
  point.mixed = hn::And(hn::Gt(highest, hn::Zero(d)), hn::Le(lowest, hn::Zero(d)));
  // 2^(127 - e) for a largest level of 2^e <= |f| < 2^(e + 1); exponent fields of 1 and less share a scale.
  constexpr std::int32_t kExponentBits = 0x7F800000, kSmallestNormal = 0x00800000, kTwiceTheBias = 0x7F000000;
  const auto size = hn::And(hn::BitCast(di, hn::Max(highest, hn::Neg(lowest))), hn::Set(di, kExponentBits));
  const auto scale =
      hn::BitCast(d, hn::Sub(hn::Set(di, kTwiceTheBias), hn::Max(size, hn::Set(di, kSmallestNormal))));
  for (FloatVec& corner : c) corner = hn::Mul(corner, scale);

  // As LevelInterpolant::at().
  const auto slope00 = hn::Sub(c[1], c[0]), slope10 = hn::Sub(c[3], c[2]);
  const auto slope01 = hn::Sub(c[5], c[4]), slope11 = hn::Sub(c[7], c[6]);
  const auto on00 = hn::Add(c[0], hn::Mul(tx, slope00)), on10 = hn::Add(c[2], hn::Mul(tx, slope10));
  const auto on01 = hn::Add(c[4], hn::Mul(tx, slope01)), on11 = hn::Add(c[6], hn::Mul(tx, slope11));
  const auto twist0 = hn::Sub(slope10, slope00), twist1 = hn::Sub(slope11, slope01);
  const auto slopeX0 = hn::Add(slope00, hn::Mul(ty, twist0)), slopeX1 = hn::Add(slope01, hn::Mul(ty, twist1));
  const auto slopeY0 = hn::Sub(on10, on00), slopeY1 = hn::Sub(on11, on01);
  const auto value0 = hn::Add(on00, hn::Mul(ty, slopeY0)), value1 = hn::Add(on01, hn::Mul(ty, slopeY1));
  const auto twistXz = hn::Sub(slopeX1, slopeX0), twistYz = hn::Sub(slopeY1, slopeY0);
  const auto slopeZ = hn::Sub(value1, value0);
  const auto twistXyz = hn::Sub(twist1, twist0);
  const auto twistXy = hn::Add(twist0, hn::Mul(tz, twistXyz));
  const auto ix = hn::Set(d, frame.inverse.x), iy = hn::Set(d, frame.inverse.y), iz = hn::Set(d, frame.inverse.z);
  point.value = hn::Add(value0, hn::Mul(tz, slopeZ));
  point.gradient = {hn::Mul(hn::Add(slopeX0, hn::Mul(tz, twistXz)), ix),
                    hn::Mul(hn::Add(slopeY0, hn::Mul(tz, twistYz)), iy), hn::Mul(slopeZ, iz)};
  point.twist = {hn::Mul(hn::Mul(twistYz, iy), iz), hn::Mul(hn::Mul(twistXz, ix), iz),
                 hn::Mul(hn::Mul(twistXy, ix), iy)};
  point.bend = hn::Add(hn::Add(hn::Abs(point.twist.x), hn::Abs(point.twist.y)),
                       hn::Add(hn::Abs(point.twist.z), hn::Abs(hn::Mul(hn::Mul(hn::Mul(twistXyz, ix), iy), iz))));
  point.place = {tx, ty, tz};
  return point;
}

// What lies at the border of its bounds and would go on outwards stays where it is along that axis.
HWY_INLINE FloatMask leadsOut(FloatVec at, FloatVec low, FloatVec high, FloatVec direction) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  return hn::Or(hn::And(hn::Le(at, low), hn::Le(direction, zero)), hn::And(hn::Ge(at, high), hn::Ge(direction, zero)));
}

// newtonStep() of closest_point.cpp; where its matrix is not positive, `plain`.
HWY_INLINE Vec3 newtonOr(const Vec3& plain, const VectorPoint& point, const Vec3& o, FloatVec multiplier) {
  const FloatTag d;
  const auto one = hn::Set(d, 1.0F);
  const Vec3& g = point.gradient;
  const Vec3 h = scaled(point.twist, multiplier);
  const Vec3 diagonal = {hn::Sub(one, hn::Mul(h.x, h.x)), hn::Sub(one, hn::Mul(h.y, h.y)),
                         hn::Sub(one, hn::Mul(h.z, h.z))};
  const Vec3 off = {hn::Sub(hn::Mul(h.y, h.z), h.x), hn::Sub(hn::Mul(h.x, h.z), h.y), hn::Sub(hn::Mul(h.x, h.y), h.z)};
  const auto adjugate = [&](const Vec3& u) {
    return Vec3{dot({diagonal.x, off.z, off.y}, u), dot({off.z, diagonal.y, off.x}, u),
                dot({off.y, off.x, diagonal.z}, u)};
  };
  const auto determinant = hn::Add(hn::Add(diagonal.x, hn::Mul(h.z, off.z)), hn::Mul(h.y, off.y));
  const Vec3 adjugateO = adjugate(o), adjugateG = adjugate(g);
  const auto along = dot(g, adjugateG);
  const auto positive = hn::And(hn::Gt(determinant, hn::Zero(d)), hn::Gt(along, hn::Zero(d)));
  const auto next = hn::Sub(hn::Mul(point.value, determinant), dot(g, adjugateO));
  const auto share = hn::Div(hn::Set(d, -1.0F), hn::Mul(along, determinant));
  const Vec3 newton = scaled(added(scaled(adjugateO, along), scaled(adjugateG, next)), share);
  return chosen(positive, newton, plain);
}

HWY_INLINE Bounds boundsOf(const PointFrame& frame, IntVec x, IntVec y, int z) {
  const FloatTag d;
  const IntTag di;
  const auto reach = hn::Set(d, static_cast<float>(kPointReach));
  Bounds bounds;
  const auto bound = [&](IntVec at, int size, IntVec& first, IntVec& last, FloatVec& low, FloatVec& high) {
    first = hn::Neg(at);
    last = hn::Sub(hn::Set(di, std::max(size - 2, 0)), at);
    low = hn::Max(hn::ConvertTo(d, first), hn::Neg(reach));
    high = hn::Min(hn::ConvertTo(d, hn::Sub(hn::Set(di, size - 1), at)), reach);
  };
  bound(x, frame.size.x, bounds.firstX, bounds.lastX, bounds.low.x, bounds.high.x);
  bound(y, frame.size.y, bounds.firstY, bounds.lastY, bounds.low.y, bounds.high.y);
  bound(hn::Set(di, z), frame.size.z, bounds.firstZ, bounds.lastZ, bounds.low.z, bounds.high.z);
  return bounds;
}

// Moves `best`, points of the surface, to closest points, searching from `trial`. True where that is settled.
HWY_INLINE FloatMask closestPoints(const VectorLevel& level, IntVec x, IntVec y, Vec3 trial, int steps, Vec3& best) {
  const FloatTag d;
  const PointFrame& frame = level.frame;
  const auto zero = hn::Zero(d), half = hn::Set(d, 0.5F), one = hn::Set(d, 1.0F);
  const Bounds bounds = boundsOf(frame, x, y, level.z);
  const Vec3 step = {hn::Set(d, frame.step.x), hn::Set(d, frame.step.y), hn::Set(d, frame.step.z)};
  const Vec3 inverse = {hn::Set(d, frame.inverse.x), hn::Set(d, frame.inverse.y), hn::Set(d, frame.inverse.z)};
  const auto tolerance = hn::Set(d, static_cast<float>(kOnSurface * kOnSurface));
  const auto steepEnough = hn::Set(d, kSteepEnough * kSteepEnough);
  const auto within = [](FloatVec r, FloatVec low, FloatVec high) { return hn::Min(hn::Max(r, low), high); };

  // The first point that counts may be as far off as the surface is thick.
  const auto reached = hn::Add(hn::Sqrt(dot(best, best)), hn::Set(d, kStartSlack));
  auto nearest = hn::Mul(reached, reached);
  Vec3 retreat = {zero, zero, zero};  // the tangential step at `best`
  auto share = one;                   // of it that is tried next
  auto tries = zero;                  // evaluations since `best` moved last
  auto settled = hn::Lt(zero, zero);
  auto counted = settled;             // has a point that the interpolant has confirmed
  auto active = hn::Not(settled);
  for (int i = 0; i < steps; ++i) {
    const Vec3 rel = {within(hn::Mul(trial.x, inverse.x), bounds.low.x, bounds.high.x),
                      within(hn::Mul(trial.y, inverse.y), bounds.low.y, bounds.high.y),
                      within(hn::Mul(trial.z, inverse.z), bounds.low.z, bounds.high.z)};
    Vec3 here = {hn::Mul(rel.x, step.x), hn::Mul(rel.y, step.y), hn::Mul(rel.z, step.z)};
    VectorPoint point = pointAt(level, x, y, bounds, rel);
    auto steepness = dot(point.gradient, point.gradient);
    const auto steep = hn::Ge(steepness, steepEnough);
    const auto flat = hn::AndNot(steep, point.mixed);
    auto perSteepness = hn::Div(one, steepness);
    auto multiplier = hn::Neg(hn::Mul(dot(here, point.gradient), perSteepness));
    Vec3 tangential = scaled(added(here, scaled(point.gradient, multiplier)), hn::Neg(one));
    const auto outX = leadsOut(rel.x, bounds.low.x, bounds.high.x, tangential.x);
    const auto outY = leadsOut(rel.y, bounds.low.y, bounds.high.y, tangential.y);
    const auto outZ = leadsOut(rel.z, bounds.low.z, bounds.high.z, tangential.z);
    const auto anyOut = hn::Or(outX, hn::Or(outY, outZ));
    const bool border = !hn::AllFalse(d, hn::And(active, anyOut));
    const auto keep = [&](const Vec3& v) {
      return Vec3{hn::IfThenZeroElse(outX, v.x), hn::IfThenZeroElse(outY, v.y), hn::IfThenZeroElse(outZ, v.z)};
    };
    if (border) {  // steps along the border: the same equations without that axis
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
    // The step straight to the surface, and whether it ends there: by a short step within the cell the interpolant
    // leaves its tangent plane by `bend` times the square at most.
    const Vec3 straight = scaled(point.gradient, hn::Neg(hn::Mul(point.value, perSteepness)));
    const auto squared = dot(straight, straight);
    const auto left = hn::Mul(point.bend, squared);
    const auto inCell = [&](FloatVec place, FloatVec move, FloatVec perStep) {
      const auto moved = hn::Add(place, hn::Mul(move, perStep));
      return hn::And(hn::Ge(moved, zero), hn::Le(moved, one));
    };
    const auto lands = hn::And(hn::Le(hn::Mul(left, left), hn::Mul(tolerance, steepness)),
                               hn::And(inCell(point.place.x, straight.x, inverse.x),
                                       hn::And(inCell(point.place.y, straight.y, inverse.y),
                                               inCell(point.place.z, straight.z, inverse.z))));
    const auto onSurface = hn::And(movable, hn::Or(lands, hn::Le(squared, tolerance)));
    const auto landed = hn::And(movable, lands);
    here = chosen(landed, added(here, straight), here);
    multiplier = hn::IfThenElse(landed, hn::Add(multiplier, hn::Mul(point.value, perSteepness)), multiplier);
    point.value = hn::IfThenZeroElse(landed, point.value);
    const auto length = dot(here, here);
    const auto nearer = hn::And(active, hn::And(onSurface, hn::Le(length, nearest)));
    const auto gain = hn::Mul(half, dot(tangential, tangential));
    const auto small = hn::Le(hn::Mul(gain, gain), hn::Mul(hn::Set(d, kShortEnough * kShortEnough), length));

    best = chosen(nearer, here, best);
    counted = hn::Or(counted, nearer);
    nearest = hn::IfThenElse(nearer, length, nearest);
    retreat = chosen(nearer, tangential, retreat);
    share = hn::IfThenElse(nearer, one, share);
    tries = hn::IfThenElse(nearer, zero, hn::Add(tries, one));
    // Too flat for float: left unsettled. Nothing nearer within a few tries: it stays where it is.
    const auto done = hn::Or(hn::And(nearer, small), hn::Gt(tries, hn::Set(d, kPointTries)));
    settled = hn::Or(settled, hn::And(hn::And(active, counted), hn::AndNot(flat, done)));
    active = hn::AndNot(hn::Or(flat, done), active);
    if (hn::AllFalse(d, active)) break;

    // From a point that counts, Newton's step; from the first trial too; else straight to the surface; back to a part
    // of the tangential step where the surface was reached in vain or lost.
    const auto fresh = hn::Or(nearer, hn::Eq(hn::Set(d, static_cast<float>(i)), zero));
    const Vec3 o = border ? keep(here) : here;
    const Vec3 onward = scaled(point.gradient, hn::Neg(hn::Mul(point.value, perSteepness)));
    Vec3 move = chosen(fresh, newtonOr(added(tangential, onward), point, o, multiplier), onward);
    const auto far = dot(move, move);
    const auto limit = hn::Max(hn::Set(d, kLongestStep * kLongestStep), length);
    const auto tooFar = hn::Gt(far, limit);
    if (!hn::AllFalse(d, tooFar)) move = chosen(tooFar, scaled(move, hn::Sqrt(hn::Div(limit, far))), move);
    const auto back = hn::Or(hn::AndNot(nearer, onSurface), hn::Not(movable));
    trial = chosen(back, added(best, scaled(retreat, share)), added(here, move));
    share = hn::IfThenElse(back, hn::Mul(half, share), share);
  }
  return hn::Or(settled, hn::And(counted, hn::And(active, hn::Eq(hn::Set(d, static_cast<float>(steps)), hn::Set(d, 16.0F)))));
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
