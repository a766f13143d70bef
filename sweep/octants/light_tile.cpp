#include "light_tile.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/octants/light_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "sweep/godunov/surface_start.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using FloatVec = hn::Vec<FloatTag>;

// Light below this is dark: keeps the exponential decay of deep shadow out of the slow denormal numbers.
constexpr float kDarkest = 1e-20F;

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

// The distance as the sweep of distances has it at a fixed value.
HWY_INLINE FloatVec fixedDistance(FloatVec distance, FloatVec perSmallest) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> du;
  // From 1/2 on all light passes: 2 stands for all larger magnitudes, infinity too.
  const auto magnitude = hn::Min(hn::Mul(hn::Abs(distance), perSmallest), hn::Set(d, 2.0F));
  const auto fixed = hn::BitCast(d, hn::Or(hn::BitCast(du, magnitude), hn::Set(du, kFixedBit)));
  return hn::CopySignToAbs(fixed, distance);
}

void sweepLightTileOnTarget(const LightBuffers& buffers, const SweepMetric& metric, float smallestSpacing, int nx) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto perSmallest = hn::Set(d, 1 / smallestSpacing);
  const LightWeights weights = lightWeights(metric);
  const Translucency solid = translucency(metric);
  const auto lane0 = hn::FirstN(d, 1);
  const auto lastLane = hn::Not(hn::FirstN(d, static_cast<std::size_t>(lanes) - 1));
  const auto up = hn::IndicesFromVec(d, hn::Max(hn::Sub(hn::Iota(di, 0), hn::Set(di, 1)), hn::Zero(di)));

  const std::ptrdiff_t planeStride = static_cast<std::ptrdiff_t>(paddedSteps(nx, lanes)) * lanes;
  const std::ptrdiff_t rowStride = paddedRow(nx, lanes);
  const std::ptrdiff_t origin = static_cast<std::ptrdiff_t>(frontPad()) * lanes;
  const std::ptrdiff_t rowOrigin = rowFrontPad(lanes);

  const float* HWY_RESTRICT distances = buffers.distance + origin;
  float* HWY_RESTRICT visibilities = buffers.visibility + origin;
  float* HWY_RESTRICT carried = buffers.carriedLight + origin;
  // Read and written: a row may take the place of the one below.
  const float* rowLight = buffers.rowLight + rowOrigin;
  float* lastRowLight = buffers.lastRowLight + rowOrigin - 2 * (lanes - 1);

  FloatVec previous[kTilePlanes];
  for (FloatVec& light : previous) light = hn::Set(d, 1.0F);

  const int steps = nx + lanes - 1;
  for (int u = 0; u < steps + kTilePlanes - 1; ++u) {
    // From the last plane to the first: plane p reads what plane p - 1 held one step ago.
    HWY_UNROLL(4)
    for (int p = kTilePlanes - 1; p >= 0; --p) {
      const std::ptrdiff_t t = u - p;
      const std::ptrdiff_t at = t * lanes;
      const std::ptrdiff_t atRow = p * rowStride + t;
      const auto below = p == 0 ? hn::Load(d, carried + at) : previous[p == 0 ? 0 : p - 1];
      const auto beside = hn::IfThenElse(lane0, hn::Set(d, rowLight[atRow]), hn::TableLookupLanes(previous[p], up));
      const auto visibility = arrivingLight(weights, previous[p], beside, below);
      const auto distance = hn::Load(d, distances + p * planeStride + at);
      const auto leaving = hn::Mul(visibility, transmittance(solid, fixedDistance(distance, perSmallest)));
      previous[p] = leaving;
      hn::Store(visibility, d, visibilities + p * planeStride + at);
      // The last lane is lanes - 1 voxels behind; a masked store puts it where its x is.
      hn::BlendedStore(leaving, lastLane, d, lastRowLight + atRow);
      if (p == kTilePlanes - 1) hn::Store(leaving, d, carried + at);
    }
  }
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(sweepLightTileOnTarget);

void sweepLightTile(const LightBuffers& buffers, const SweepMetric& metric, float smallestSpacing, int nx) {
  HWY_DYNAMIC_DISPATCH(sweepLightTileOnTarget)(buffers, metric, smallestSpacing, nx);
}

}  // namespace isolume
#endif
