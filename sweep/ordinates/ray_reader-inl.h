// Where rays are read: for a vector of points and a direction the ray that passes closest, once it has risen enough
// over the point's plane (sheared_rays.h). For inclusion by SIMD code once per target (hence -inl and no usual guard).
#if defined(ISOLUME_SWEEP_RAY_READER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUME_SWEEP_RAY_READER_INL_H
#undef ISOLUME_SWEEP_RAY_READER_INL_H
#else
#define ISOLUME_SWEEP_RAY_READER_INL_H
#endif

#include <hwy/highway.h>

#include "ray_points.h"
#include "ray_step.h"
#include "sheared_rays.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::RebindToSigned<FloatTag>;
using FloatVec = hn::Vec<FloatTag>;
using IntVec = hn::Vec<IntTag>;
using FloatMask = hn::Mask<FloatTag>;

// value[j] where j layers go by: skips[j] tells that more than j do.
template <class Tag, class T>
HWY_INLINE hn::Vec<Tag> skipped(Tag d, const std::array<T, kMostSkipped + 1>& value, const hn::Mask<Tag>* skips) {
  auto chosen = hn::Set(d, value[0]);
  for (std::size_t j = 0; j < kMostSkipped; ++j) chosen = hn::IfThenElse(skips[j], hn::Set(d, value[j + 1]), chosen);
  return chosen;
}

// Points [i, i + lanes) of those that are read at `layer`, the first towards the light. Lanes beyond the end may hold
// points of other layers.
struct PointVector {
  FloatVec bit, row, ahead, normalBit, normalRow, normalLayer, toClear;
  FloatMask inRange;

  PointVector(const LatticeLayers& lattice, const RayPoints& points, int layer, std::size_t i, std::size_t end) {
    const FloatTag d;
    const auto farthest = hn::Set(d, kBeyondLattice);
    ahead = hn::Min(
        hn::Max(hn::Sub(hn::Set(d, static_cast<float>(layer)), hn::LoadU(d, points.layer() + i)), hn::Neg(farthest)),
        farthest);
    bit = hn::LoadU(d, points.bit() + i);
    row = hn::LoadU(d, points.row() + i);
    normalBit = hn::LoadU(d, points.normalBit() + i);
    normalRow = hn::LoadU(d, points.normalRow() + i);
    normalLayer = hn::LoadU(d, points.normalLayer() + i);
    const auto width = hn::Add(hn::Add(hn::Mul(hn::Abs(normalBit), hn::Set(d, lattice.cellBit)),
                                       hn::Mul(hn::Abs(normalRow), hn::Set(d, lattice.cellRow))),
                               hn::Mul(hn::Abs(normalLayer), hn::Set(d, lattice.cellLayer)));
    toClear = hn::Mul(width, hn::Set(d, kClearance - kLift));
    inRange = hn::FirstN(d, std::min(hn::Lanes(d), end - i));
  }

  HWY_INLINE FloatVec cosine(const RayDirection& to) const {
    const FloatTag d;
    return hn::Add(hn::Add(hn::Mul(normalBit, hn::Set(d, to.weightBit)), hn::Mul(normalRow, hn::Set(d, to.weightRow))),
                   hn::Mul(normalLayer, hn::Set(d, to.weightLayer)));
  }
};

// Column and row of the lattice, whole numbers, one beyond it at most; and whether more than j layers are skipped.
struct RayPlace {
  FloatVec column, row;
  FloatVec ahead;  // layers from where the ray starts to the one that is read
  hn::Mask<IntTag> skips[kMostSkipped];
};

// `rises`: those that face the light. The others look into the solid: from the surface itself, without the lift of the
// points, and into the next layer.
HWY_INLINE RayPlace placeOnRay(const LatticeLayers& lattice, const PointVector& point, const RayDirection& to,
                               const RayStep& step, FloatVec cosine, FloatMask rises) {
  const FloatTag d;
  const auto rise = hn::Mul(cosine, hn::Set(d, to.risePerCosine));
  FloatMask skips[kMostSkipped];
  auto height = hn::Mul(rise, hn::Abs(point.ahead));
  for (FloatMask& skip : skips) {
    skip = hn::And(hn::Lt(height, point.toClear), rises);
    height = hn::Add(height, rise);
  }
  // What is still missing after these layers, the ray is lifted by along the normal.
  const auto missing = hn::IfThenElse(rises, hn::Max(hn::Sub(point.toClear, height), hn::Zero(d)),
                                      hn::Mul(point.toClear, hn::Set(d, -kLift / (kClearance - kLift))));
  const auto layersUp = hn::Mul(hn::Mul(missing, point.normalLayer), hn::Set(d, 1 / lattice.cellLayer));
  const auto ahead = hn::Sub(point.ahead, layersUp);
  const auto placeOf = [&](FloatVec at, float lag, double slope, const auto& on, FloatVec normal, float cell) {
    const auto along = hn::Mul(ahead, hn::Set(d, static_cast<float>(slope)));
    const auto lifted = hn::Add(hn::Sub(at, hn::Set(d, lag)), hn::Mul(hn::Mul(missing, normal), hn::Set(d, 1 / cell)));
    return hn::Add(hn::Round(hn::Add(lifted, along)), skipped(d, on, skips));
  };
  const auto within = [d](FloatVec at, int count) {
    return hn::Min(hn::Max(at, hn::Set(d, -1.0F)), hn::Set(d, static_cast<float>(count)));
  };
  RayPlace place;
  place.ahead = ahead;
  place.column = within(placeOf(point.bit, step.lagBit, to.slopeBit, step.onBit, point.normalBit, lattice.cellBit),
                        lattice.length);
  place.row =
      within(placeOf(point.row, step.lagRow, to.slopeRow, step.onRow, point.normalRow, lattice.cellRow), lattice.rows);
  for (int j = 0; j < kMostSkipped; ++j) place.skips[j] = hn::RebindMask(IntTag(), skips[j]);
  return place;
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
