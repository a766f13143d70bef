// The interpolant of level_cell.h and Newton's step of closest_point.cpp for a vector of samples, in float.
// Included once per SIMD target.
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

struct Vec3 {
  FloatVec x, y, z;
};

HWY_INLINE FloatVec dot(const Vec3& a, const Vec3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vec3 scaled(const Vec3& a, FloatVec s) { return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)}; }
HWY_INLINE Vec3 added(const Vec3& a, const Vec3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vec3 chosen(FloatMask m, const Vec3& yes, const Vec3& no) {
  return {hn::IfThenElse(m, yes.x, no.x), hn::IfThenElse(m, yes.y, no.y), hn::IfThenElse(m, yes.z, no.z)};
}
HWY_INLINE Vec3 loadBatch(const std::array<PointBatch::Floats, 3>& from, std::size_t i) {
  const FloatTag d;
  return {hn::LoadU(d, from[0].data() + i), hn::LoadU(d, from[1].data() + i), hn::LoadU(d, from[2].data() + i)};
}
HWY_INLINE void storeBatch(const Vec3& v, std::array<PointBatch::Floats, 3>& to, std::size_t i) {
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

// The level, addressed from the first plane within reach of the samples of a batch.
struct VectorLevel {
  VectorLevel(const PointFrame& frame_, const PointBatch& batch)
      : frame(frame_),
        firstPlane(std::max(batch.firstPlane - kPointReach, 0)),
        base(frame_.level + firstPlane * (static_cast<std::ptrdiff_t>(frame_.size.x) * frame_.size.y)) {
    const FloatTag d;
    step = {hn::Set(d, frame.step.x), hn::Set(d, frame.step.y), hn::Set(d, frame.step.z)};
    inverse = {hn::Set(d, frame.inverse.x), hn::Set(d, frame.inverse.y), hn::Set(d, frame.inverse.z)};
  }

  const PointFrame& frame;
  int firstPlane;
  const float* base;
  Vec3 step, inverse;
};

// A vector of samples, and where their points may lie, in samples from them: the grid, cut at kPointReach.
struct VectorSamples {
  VectorSamples(const VectorLevel& level, const PointBatch& batch, std::size_t i) {
    const FloatTag d;
    const IntTag di;
    x = hn::LoadU(di, batch.x.data() + i);
    y = hn::LoadU(di, batch.y.data() + i);
    z = hn::LoadU(di, batch.z.data() + i);
    const auto reach = hn::Set(d, static_cast<float>(kPointReach));
    const auto bound = [&](IntVec at, int size, IntVec& first, IntVec& last, FloatVec& lowest, FloatVec& highest) {
      first = hn::Neg(at);
      last = hn::Sub(hn::Set(di, std::max(size - 2, 0)), at);
      lowest = hn::Max(hn::ConvertTo(d, first), hn::Neg(reach));
      highest = hn::Min(hn::ConvertTo(d, hn::Sub(hn::Set(di, size - 1), at)), reach);
    };
    const glm::ivec3 size = level.frame.size;
    bound(x, size.x, firstX, lastX, low.x, high.x);
    bound(y, size.y, firstY, lastY, low.y, high.y);
    bound(z, size.z, firstZ, lastZ, low.z, high.z);
  }

  IntVec x, y, z;
  IntVec firstX, firstY, firstZ, lastX, lastY, lastZ;  // cells along each axis
  Vec3 low, high;
};

// first = from[at], second = from[at + 1]. A gather costs by the number of its places, so that one of pairs is cheaper.
HWY_INLINE void gatherPairs(const float* from, IntVec at, FloatVec& first, FloatVec& second) {
  const FloatTag d;
#if HWY_TARGET <= HWY_AVX2
  const hn::RepartitionToWide<IntTag> dPair;
  const auto pairs = [&](auto places) {
    const auto bytes = hn::ShiftLeft<2>(hn::PromoteTo(dPair, places));  // 4 bytes each
    return hn::BitCast(d, hn::GatherOffset(dPair, reinterpret_cast<const std::int64_t*>(from), bytes));
  };
  const auto low = pairs(hn::LowerHalf(at));
  const auto high = pairs(hn::UpperHalf(hn::Half<IntTag>(), at));
  first = hn::ConcatEven(d, high, low);
  second = hn::ConcatOdd(d, high, low);
#else
  first = hn::GatherIndex(d, from, at);
  second = hn::GatherIndex(d, from + 1, at);
#endif
}

HWY_INLINE VectorPoint pointAt(const VectorLevel& level, const VectorSamples& samples, const Vec3& rel) {
  const FloatTag d;
  const IntTag di;
  const PointFrame& frame = level.frame;
  const auto cellOf = [&](FloatVec r, IntVec first, IntVec last) {
    return hn::Max(hn::Min(hn::ConvertTo(di, hn::Floor(r)), last), first);
  };
  const auto cx = cellOf(rel.x, samples.firstX, samples.lastX);
  const auto cy = cellOf(rel.y, samples.firstY, samples.lastY);
  const auto cz = cellOf(rel.z, samples.firstZ, samples.lastZ);
  const auto tx = hn::Sub(rel.x, hn::ConvertTo(d, cx));
  const auto ty = hn::Sub(rel.y, hn::ConvertTo(d, cy));
  const auto tz = hn::Sub(rel.z, hn::ConvertTo(d, cz));
  const auto plane = hn::Add(cz, hn::Sub(samples.z, hn::Set(di, level.firstPlane)));
  const auto row = hn::Add(hn::Mul(plane, hn::Set(di, frame.size.y)), hn::Add(samples.y, cy));
  const auto at = hn::Add(hn::Mul(row, hn::Set(di, frame.size.x)), hn::Add(samples.x, cx));
  const std::ptrdiff_t nextY = frame.size.y > 1 ? frame.size.x : 0;
  const std::ptrdiff_t nextZ = frame.size.z > 1 ? static_cast<std::ptrdiff_t>(frame.size.x) * frame.size.y : 0;
  FloatVec c[8];
  for (int i = 0; i < 8; i += 2) {
    const float* edge = level.base + ((i >> 1 & 1) * nextY + (i >> 2) * nextZ);
    if (frame.size.x > 1) {
      gatherPairs(edge, at, c[i], c[i + 1]);
    } else {
      c[i] = c[i + 1] = hn::GatherIndex(d, edge, at);
    }
  }
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
  const auto scale = hn::BitCast(d, hn::Sub(hn::Set(di, kTwiceTheBias), hn::Max(size, hn::Set(di, kSmallestNormal))));
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
  const auto ix = level.inverse.x, iy = level.inverse.y, iz = level.inverse.z;
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

// Is `at` on the border of low to high, and does `direction` not lead away from it?
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

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
