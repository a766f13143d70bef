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

// Added to a number below 2^22, rounds it to the nearest whole one, to even halfway, and leaves it in the low bits:
// 1.5 * 2^23.
inline constexpr float kToWhole = 12582912;
inline constexpr std::uint32_t kToWholeBits = 0x4B400000;
// Places that kToWhole rounded, no further than `reach` beyond [0, count), as whole numbers and kToWholeBits more.
class Within {
 public:
  Within(int reach, int count)
      : low_(hn::Set(FloatTag(), kToWhole - static_cast<float>(reach))),
        high_(hn::Set(FloatTag(), kToWhole + static_cast<float>(count + reach - 1))) {}
  HWY_INLINE IntVec operator()(FloatVec place) const {
    return hn::BitCast(IntTag(), hn::Min(hn::Max(place, low_), high_));
  }

 private:
  FloatVec low_, high_;
};

// In which lanes a ray is too low in the first layer, still in the second, and in the third.
struct TooLow {
  FloatMask in[kMostSkipped];
};

// value[j] where j layers go by.
HWY_INLINE IntVec chosen(const PerSkip<std::int32_t>& value, const TooLow& low) {
  const IntTag di;
  IntVec at = hn::Set(di, value[0]);
  for (std::size_t j = 0; j < kMostSkipped; ++j)
    at = hn::IfThenElse(hn::RebindMask(di, low.in[j]), hn::Set(di, value[j + 1]), at);
  return at;
}
HWY_INLINE FloatVec chosen(const PerSkip<float>& value, const TooLow& low) {
  const FloatTag d;
  FloatVec at = hn::Set(d, value[0]);
  for (std::size_t j = 0; j < kMostSkipped; ++j) at = hn::IfThenElse(low.in[j], hn::Set(d, value[j + 1]), at);
  return at;
}

// Points [i, i + lanes) of those that are read at `layer`, the first towards the light. Lanes beyond the end may hold
// points of other layers.
struct PointVector {
  FloatVec bit, row, ahead, distance;  // ahead: layers to the one that is read, and how far that is
  FloatVec normalBit, normalRow, normalLayer, toClear;
  FloatVec liftBit, liftRow;  // lattice points within the layer per world unit that a ray gains in height
  FloatMask inRange;

  // `blur`: what lies that high above the surface counts in part, world units.
  PointVector(const LatticeLayers& lattice, const RayPoints& points, int layer, std::size_t i, std::size_t end,
              float blur = 0) {
    const FloatTag d;
    const auto one = hn::Set(d, 1.0F);
    ahead = hn::Min(
        hn::Max(hn::Sub(hn::Set(d, static_cast<float>(layer)), hn::LoadU(d, points.layer() + i)), hn::Neg(one)), one);
    distance = hn::Abs(ahead);
    bit = hn::LoadU(d, points.bit() + i);
    row = hn::LoadU(d, points.row() + i);
    normalBit = hn::LoadU(d, points.normalBit() + i);
    normalRow = hn::LoadU(d, points.normalRow() + i);
    normalLayer = hn::LoadU(d, points.normalLayer() + i);
    const auto perBit = hn::Mul(normalBit, hn::Set(d, lattice.cellBit));
    const auto perRow = hn::Mul(normalRow, hn::Set(d, lattice.cellRow));
    toClear = hn::Add(hn::Mul(hn::Add(hn::Abs(perBit), hn::Abs(perRow)), hn::Set(d, kClearance)), hn::Set(d, blur));
    const auto steepest =
        hn::Max(hn::Add(hn::Mul(perBit, perBit), hn::Mul(perRow, perRow)), hn::Set(d, kSmallestSquare));
    liftBit = hn::Div(perBit, steepest);
    liftRow = hn::Div(perRow, steepest);
    inRange = hn::FirstN(d, std::min(hn::Lanes(d), end - i));
  }

  HWY_INLINE FloatVec cosine(const RayDirection& to) const {
    const FloatTag d;
    return hn::Add(hn::Add(hn::Mul(normalBit, hn::Set(d, to.weightBit)), hn::Mul(normalRow, hn::Set(d, to.weightRow))),
                   hn::Mul(normalLayer, hn::Set(d, to.weightLayer)));
  }
};

// Column and row where a ray crosses the layer that a point reads, rounded by kToWhole, of any size; and how many
// layers on it counts, along the digital line.
struct RayPlace {
  FloatVec column, row;
  TooLow low;
};

// The ray rises: others have any place. With kBothWays those that are not among `rises` look into the solid, into the
// next layer.
template <bool kBothWays>
HWY_INLINE RayPlace placeOnRay(const PointVector& point, const RayDirection& to, const RayStep& step, FloatVec cosine,
                               FloatMask rises) {
  const FloatTag d;
  const auto rise = hn::Mul(cosine, hn::Set(d, to.risePerCosine));
  RayPlace place;
  auto height = hn::Mul(rise, point.distance);
  for (int j = 0; j < kMostSkipped; ++j) {
    place.low.in[j] = hn::Le(height, point.toClear);
    height = hn::Add(height, rise);
  }
  // What is still missing after these layers, the ray is lifted by, the shortest way within the layer.
  auto missing = hn::Max(hn::Sub(point.toClear, height), hn::Zero(d));
  if constexpr (kBothWays) {
    for (FloatMask& low : place.low.in) low = hn::And(low, rises);
    missing = hn::IfThenElseZero(rises, missing);
  }
  const auto placeOf = [&](FloatVec at, float lag, float slope, FloatVec lift) {
    const auto lifted = hn::Add(hn::Sub(at, hn::Set(d, lag)), hn::Mul(missing, lift));
    return hn::Add(hn::Add(lifted, hn::Mul(point.ahead, hn::Set(d, slope))), hn::Set(d, kToWhole));
  };
  place.column = placeOf(point.bit, step.lagBit, step.slopeBit, point.liftBit);
  place.row = placeOf(point.row, step.lagRow, step.slopeRow, point.liftRow);
  return place;
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
