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

// value[j] for j in [0, kMostSkipped].
template <class T>
HWY_INLINE hn::Vec<hn::ScalableTag<T>> chosen(const PerSkip<T>& value, IntVec j) {
  const hn::ScalableTag<T> d;
  if constexpr (hn::MaxLanes(d) > kMostSkipped)
    return hn::TableLookupLanes(hn::LoadDup128(d, value.data()), hn::IndicesFromVec(d, j));
  else
    return hn::GatherIndex(d, value.data(), j);
}

// Points [i, i + lanes) of those that are read at `layer`, the first towards the light. Lanes beyond the end may hold
// points of other layers.
struct PointVector {
  FloatVec bit, row, ahead, distance;  // ahead: layers to the one that is read, and how far that is
  FloatVec normalBit, normalRow, normalLayer, toClear;
  FloatVec liftBit, liftRow, liftLayer;  // lattice points per world unit along the normal
  FloatMask inRange;

  PointVector(const LatticeLayers& lattice, const RayPoints& points, int layer, std::size_t i, std::size_t end) {
    const FloatTag d;
    const auto farthest = hn::Set(d, kBeyondLattice);
    ahead = hn::Min(
        hn::Max(hn::Sub(hn::Set(d, static_cast<float>(layer)), hn::LoadU(d, points.layer() + i)), hn::Neg(farthest)),
        farthest);
    distance = hn::Abs(ahead);
    bit = hn::LoadU(d, points.bit() + i);
    row = hn::LoadU(d, points.row() + i);
    normalBit = hn::LoadU(d, points.normalBit() + i);
    normalRow = hn::LoadU(d, points.normalRow() + i);
    normalLayer = hn::LoadU(d, points.normalLayer() + i);
    const auto width = hn::Add(hn::Add(hn::Mul(hn::Abs(normalBit), hn::Set(d, lattice.cellBit)),
                                       hn::Mul(hn::Abs(normalRow), hn::Set(d, lattice.cellRow))),
                               hn::Mul(hn::Abs(normalLayer), hn::Set(d, lattice.cellLayer)));
    toClear = hn::Mul(width, hn::Set(d, kClearance - kLift));
    liftBit = hn::Mul(normalBit, hn::Set(d, 1 / lattice.cellBit));
    liftRow = hn::Mul(normalRow, hn::Set(d, 1 / lattice.cellRow));
    liftLayer = hn::Mul(normalLayer, hn::Set(d, 1 / lattice.cellLayer));
    inRange = hn::FirstN(d, std::min(hn::Lanes(d), end - i));
  }

  HWY_INLINE FloatVec cosine(const RayDirection& to) const {
    const FloatTag d;
    return hn::Add(hn::Add(hn::Mul(normalBit, hn::Set(d, to.weightBit)), hn::Mul(normalRow, hn::Set(d, to.weightRow))),
                   hn::Mul(normalLayer, hn::Set(d, to.weightLayer)));
  }
};

// Column and row where a ray crosses the layer that a point reads, whole numbers, of any size; and how many layers on
// it counts, along the digital line.
struct RayPlace {
  FloatVec column, row;
  FloatVec ahead;  // layers from where the ray starts to the one that is read
  IntVec skips;
};

// The ray rises: others have any place. With kBothWays those that are not among `rises` look into the solid: from the
// surface itself, without the lift of the points, and into the next layer.
template <bool kBothWays>
HWY_INLINE RayPlace placeOnRay(const PointVector& point, const RayDirection& to, const RayStep& step, FloatVec cosine,
                               FloatMask rises) {
  const FloatTag d;
  const IntTag di;
  const auto rise = hn::Mul(cosine, hn::Set(d, to.risePerCosine));
  RayPlace place;
  place.skips = hn::Zero(di);
  auto height = hn::Mul(rise, point.distance);
  for (int j = 0; j < kMostSkipped; ++j) {
    const auto low = hn::VecFromMask(di, hn::RebindMask(di, hn::Lt(height, point.toClear)));
    place.skips = hn::Sub(place.skips, low);
    height = hn::Add(height, rise);
  }
  // What is still missing after these layers, the ray is lifted by along the normal.
  auto missing = hn::Max(hn::Sub(point.toClear, height), hn::Zero(d));
  if constexpr (kBothWays) {
    place.skips = hn::IfThenElseZero(hn::RebindMask(di, rises), place.skips);
    missing = hn::IfThenElse(rises, missing, hn::Mul(point.toClear, hn::Set(d, -kLift / (kClearance - kLift))));
  }
  place.ahead = hn::Sub(point.ahead, hn::Mul(missing, point.liftLayer));
  const auto placeOf = [&](FloatVec at, float lag, float slope, FloatVec lift) {
    const auto lifted = hn::Add(hn::Sub(at, hn::Set(d, lag)), hn::Mul(missing, lift));
    return hn::Round(hn::Add(lifted, hn::Mul(place.ahead, hn::Set(d, slope))));
  };
  place.column = placeOf(point.bit, step.lagBit, step.slopeBit, point.liftBit);
  place.row = placeOf(point.row, step.lagRow, step.slopeRow, point.liftRow);
  return place;
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
