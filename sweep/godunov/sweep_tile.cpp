#include "sweep_tile.h"

#include <algorithm>
#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/godunov/sweep_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "surface_start.h"
#include "upwind_update-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

int lanesOfTarget() { return static_cast<int>(hn::Lanes(FloatTag())); }

template <bool kIsotropic>
bool sweepTileAs(const TileBuffers& buffers, const SweepMetric& gridMetric, TileSpan span) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  const hn::RebindToUnsigned<FloatTag> du;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const VectorMetric metric = vectorMetric(gridMetric);
  const auto lane0 = hn::FirstN(d, 1);
  const auto lastLane = hn::Not(hn::FirstN(d, static_cast<std::size_t>(lanes) - 1));
  const auto up = hn::IndicesFromVec(d, hn::Max(hn::Sub(hn::Iota(di, 0), hn::Set(di, 1)), hn::Zero(di)));

  const std::ptrdiff_t planeStride = static_cast<std::ptrdiff_t>(paddedSteps(buffers.rowLength, lanes)) * lanes;
  const std::ptrdiff_t rowStride = paddedRow(buffers.rowLength, lanes);
  const std::ptrdiff_t origin = static_cast<std::ptrdiff_t>(frontPad()) * lanes;
  const std::ptrdiff_t carriedOrigin = origin + static_cast<std::ptrdiff_t>(span.first) * lanes;
  const std::ptrdiff_t rowOrigin = rowFrontPad(lanes) + span.first;

  FloatVec previous[kTilePlanes];
  for (FloatVec& distance : previous) distance = hn::Set(d, kOutsideDistance);

  auto difference = hn::Zero(du);
  const int steps = span.count + lanes - 1;
  for (int u = 0; u < steps + kTilePlanes - 1; ++u) {
    // From the last plane to the first: plane p reads what plane p - 1 held one step ago.
    HWY_UNROLL(4)
    for (int p = kTilePlanes - 1; p >= 0; --p) {
      const std::ptrdiff_t t = u - p;
      const std::ptrdiff_t atRow = p * rowStride + rowOrigin + t;
      const std::ptrdiff_t carried = carriedOrigin + t * lanes;
      // The last lane is lanes - 1 voxels behind; a masked store puts it where its x is.
      const std::ptrdiff_t atLastRow = atRow - 2 * (lanes - 1);
      float* cell = buffers.distance + p * planeStride + origin + t * lanes;
      const auto below = p == 0 ? hn::Load(d, buffers.carried + carried) : previous[p == 0 ? 0 : p - 1];
      const auto before = previous[p];
      const auto beside = hn::IfThenElse(lane0, hn::Set(d, buffers.row[atRow]), hn::TableLookupLanes(before, up));
      const Upwind upwind{hn::Abs(before), hn::Abs(beside), hn::Abs(below)};
      const auto old = hn::Load(d, cell);
      auto distance = old;
      const auto lower = mayLower<kIsotropic>(hn::Abs(old), upwind, metric);
      if (!hn::AllFalse(d, lower)) {
        distance = hn::CopySignToAbs(lowered<kIsotropic>(hn::Abs(old), lower, upwind, metric), old);
        difference = hn::Or(difference, hn::Xor(hn::BitCast(du, distance), hn::BitCast(du, old)));
        hn::Store(distance, d, cell);
      }
      previous[p] = distance;
      hn::BlendedStore(distance, lastLane, d, buffers.lastRow + atLastRow);
      if (p == kTilePlanes - 1) hn::Store(distance, d, buffers.carried + carried);
    }
  }
  return !hn::AllTrue(du, hn::Eq(difference, hn::Zero(du)));
}

bool sweepTileOnTarget(const TileBuffers& buffers, const SweepMetric& metric, TileSpan span) {
  return metric.isotropic ? sweepTileAs<true>(buffers, metric, span) : sweepTileAs<false>(buffers, metric, span);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(lanesOfTarget);
HWY_EXPORT(sweepTileOnTarget);

int tileLanes() { return HWY_DYNAMIC_DISPATCH(lanesOfTarget)(); }

SweepMetric makeSweepMetric(glm::dvec3 spacing, float opacity) {
  assert(opacity >= 0 && opacity <= 1);
  const double smallest = smallestSpacing(spacing);
  const glm::dvec3 h = spacing / smallest;
  SweepMetric metric;
  metric.spacing = glm::vec3(h);
  metric.inverseSquare = glm::vec3(1.0 / (h * h));
  const double sum = 1 / h.x + 1 / h.y + 1 / h.z;
  metric.weights.x = static_cast<float>(1 / h.x / sum);
  metric.weights.y = static_cast<float>(1 / h.y / sum);
  metric.weights.z = 1.0F - (metric.weights.x + metric.weights.y);  // so that open space stays exactly 1
  metric.opacity = opacity;
  metric.isotropic = h.x == 1 && h.y == 1 && h.z == 1;
  return metric;
}

bool sweepTile(const TileBuffers& buffers, const SweepMetric& metric, TileSpan span) {
  return HWY_DYNAMIC_DISPATCH(sweepTileOnTarget)(buffers, metric, span);
}

}  // namespace isolume
#endif
