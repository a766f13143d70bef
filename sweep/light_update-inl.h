// The light of a vector of voxels, for inclusion by SIMD code once per target (hence -inl and no usual guard): the same
// operations in the same order whether distances are swept beside it or not.
#if defined(ISOLUME_SWEEP_LIGHT_UPDATE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUME_SWEEP_LIGHT_UPDATE_INL_H
#undef ISOLUME_SWEEP_LIGHT_UPDATE_INL_H
#else
#define ISOLUME_SWEEP_LIGHT_UPDATE_INL_H
#endif

#include <hwy/highway.h>

#include "light_tile.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using FloatVec = hn::Vec<FloatTag>;

struct LightWeights {
  FloatVec x, y, z;
};
HWY_INLINE LightWeights lightWeights(const SweepMetric& metric) {
  const FloatTag d;
  return {hn::Set(d, metric.weights.x), hn::Set(d, metric.weights.y), hn::Set(d, metric.weights.z)};
}

// [Singh10] Eq. 6: the neighbours' V tau, weighted.
HWY_INLINE FloatVec arrivingLight(const LightWeights& weights, FloatVec x, FloatVec y, FloatVec z) {
  const FloatTag d;
  const auto sum = hn::Add(hn::Add(hn::Mul(weights.x, x), hn::Mul(weights.y, y)), hn::Mul(weights.z, z));
  return hn::IfThenElseZero(hn::Ge(sum, hn::Set(d, kDarkest)), sum);
}

// [Singh10] Eq. 7 and 8 with h = the smallest spacing; signed distances in that unit. With t the ramp of Eq. 7,
// 1 - (1 - t) alpha = min(max(alpha D + (1 - alpha / 2), 1 - alpha), 1): at alpha = 1 the bits of Eq. 7, at 0
// exactly 1.
struct Translucency {
  FloatVec opacity, middle, least;
};
HWY_INLINE Translucency translucency(const SweepMetric& metric) {
  const FloatTag d;
  return {hn::Set(d, metric.opacity), hn::Set(d, 1 - metric.opacity / 2), hn::Set(d, 1 - metric.opacity)};
}
HWY_INLINE FloatVec transmittance(const Translucency& solid, FloatVec distance) {
  const FloatTag d;
  const auto ramp = hn::Add(hn::Mul(solid.opacity, distance), solid.middle);
  return hn::Min(hn::Max(ramp, solid.least), hn::Set(d, 1.0F));
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
