#include "sweep_tile.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/sweep_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "surface_start.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using FloatVec = hn::Vec<FloatTag>;

int lanesOfTarget() { return static_cast<int>(hn::Lanes(FloatTag())); }

// Light below this is dark: keeps the exponential decay of deep shadow out of the slow denormal numbers.
constexpr float kDarkest = 1e-20F;

// One neighbour's distance together with the spacing of its axis.
struct Axis {
  FloatVec distance, spacing, inverseSquare;
};

// Puts the nearer of two neighbours first.
HWY_INLINE void order(Axis& a, Axis& b) {
  const auto swap = hn::Lt(b.distance, a.distance);
  const Axis nearer{hn::IfThenElse(swap, b.distance, a.distance), hn::IfThenElse(swap, b.spacing, a.spacing),
                    hn::IfThenElse(swap, b.inverseSquare, a.inverseSquare)};
  b = {hn::IfThenElse(swap, a.distance, b.distance), hn::IfThenElse(swap, a.spacing, b.spacing),
       hn::IfThenElse(swap, a.inverseSquare, b.inverseSquare)};
  a = nearer;
}

// The upwind update ([Singh10] Sec. 1.1, [Zhao05] Eq. 2.4): the root d of sum ((d - a_i) / h_i)^2 = 1 over as many of
// the nearest neighbours as lie below d. With b, c the distances of the second and third above the first, and w_i =
// 1/h_i^2:
//   one:   d - a1 = h1
//   two:   d - a1 = (w2 b + sqrt(w1 + w2 - w1 w2 b^2)) / (w1 + w2)
//   three: d - a1 = (w2 b + w3 c + sqrt(W - w1 w2 b^2 - w1 w3 c^2 - w2 w3 (b - c)^2)) / W,  W = w1 + w2 + w3
// Cases that do not apply may give NaN under the root; they are never selected. No fused multiply-add: see
// sweep_tile.h.
template <bool kIsotropic>
HWY_INLINE FloatVec upwindUpdate(FloatVec ax, FloatVec ay, FloatVec az, const SweepMetric& metric) {
  const FloatTag d;
  if constexpr (kIsotropic) {
    const auto low = hn::Min(ax, ay);
    const auto high = hn::Max(ax, ay);
    const auto a1 = hn::Min(low, az);
    const auto middle = hn::Max(low, az);
    const auto a2 = hn::Min(high, middle);
    const auto a3 = hn::Max(high, middle);
    const auto b = hn::Sub(a2, a1);
    const auto c = hn::Sub(a3, a1);
    const auto bc = hn::Sub(c, b);
    const auto bb = hn::Mul(b, b);
    const auto one = hn::Add(a1, hn::Set(d, 1.0F));
    const auto two = hn::Add(a1, hn::Mul(hn::Set(d, 0.5F), hn::Add(b, hn::Sqrt(hn::Sub(hn::Set(d, 2.0F), bb)))));
    const auto root = hn::Sqrt(hn::Sub(hn::Sub(hn::Set(d, 3.0F), bb), hn::Add(hn::Mul(c, c), hn::Mul(bc, bc))));
    const auto three = hn::Add(a1, hn::Mul(hn::Set(d, 1.0F / 3.0F), hn::Add(hn::Add(b, c), root)));
    return hn::IfThenElse(hn::Le(one, a2), one, hn::IfThenElse(hn::Le(two, a3), two, three));
  } else {
    Axis first{ax, hn::Set(d, metric.spacing.x), hn::Set(d, metric.inverseSquare.x)};
    Axis second{ay, hn::Set(d, metric.spacing.y), hn::Set(d, metric.inverseSquare.y)};
    Axis third{az, hn::Set(d, metric.spacing.z), hn::Set(d, metric.inverseSquare.z)};
    order(first, second);
    order(second, third);
    order(first, second);
    const auto w1 = first.inverseSquare;
    const auto w2 = second.inverseSquare;
    const auto w3 = third.inverseSquare;
    const auto b = hn::Sub(second.distance, first.distance);
    const auto c = hn::Sub(third.distance, first.distance);
    const auto bc = hn::Sub(c, b);
    const auto w12 = hn::Add(w1, w2);
    const auto w123 = hn::Add(w12, w3);
    const auto twoRoot = hn::Mul(hn::Mul(w1, w2), hn::Mul(b, b));
    const auto one = hn::Add(first.distance, first.spacing);
    const auto two = hn::Add(first.distance, hn::Div(hn::Add(hn::Mul(w2, b), hn::Sqrt(hn::Sub(w12, twoRoot))), w12));
    const auto threeRoot = hn::Add(hn::Mul(hn::Mul(w1, w3), hn::Mul(c, c)), hn::Mul(hn::Mul(w2, w3), hn::Mul(bc, bc)));
    const auto linear = hn::Add(hn::Mul(w2, b), hn::Mul(w3, c));
    const auto root = hn::Sqrt(hn::Sub(hn::Sub(w123, twoRoot), threeRoot));
    const auto three = hn::Add(first.distance, hn::Div(hn::Add(linear, root), w123));
    return hn::IfThenElse(hn::Le(one, second.distance), one, hn::IfThenElse(hn::Le(two, third.distance), two, three));
  }
}

// Keeps the smaller magnitude and the sign of `old`; a fixed value stays as it is (surface_start.h).
HWY_INLINE FloatVec keepNearer(FloatVec old, FloatVec candidate) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> du;
  const auto fixedBit = hn::Set(du, kFixedBit);
  const auto fixed = hn::RebindMask(d, hn::TestBit(hn::BitCast(du, old), fixedBit));
  const auto nearer = hn::Min(hn::Abs(old), candidate);
  const auto untagged = hn::BitCast(d, hn::AndNot(fixedBit, hn::BitCast(du, nearer)));
  return hn::IfThenElse(fixed, old, hn::CopySignToAbs(untagged, old));
}

template <bool kIsotropic, bool kLight>
void sweepTileAs(const TileBuffers& buffers, const SweepMetric& metric, int nx) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto outside = hn::Set(d, kUnsetDistance);
  const auto light = hn::Set(d, 1.0F);
  const auto weightX = hn::Set(d, metric.weights.x);
  const auto weightY = hn::Set(d, metric.weights.y);
  const auto weightZ = hn::Set(d, metric.weights.z);
  const auto lane0 = hn::FirstN(d, 1);
  const auto lastLane = hn::Not(hn::FirstN(d, static_cast<std::size_t>(lanes) - 1));
  const auto up = hn::IndicesFromVec(d, hn::Max(hn::Sub(hn::Iota(di, 0), hn::Set(di, 1)), hn::Zero(di)));

  const std::ptrdiff_t planeStride = static_cast<std::ptrdiff_t>(paddedSteps(nx, lanes)) * lanes;
  const std::ptrdiff_t rowStride = paddedRow(nx, lanes);
  const std::ptrdiff_t origin = static_cast<std::ptrdiff_t>(frontPad()) * lanes;
  const std::ptrdiff_t rowOrigin = rowFrontPad(lanes);

  FloatVec previousDistance[kTilePlanes];
  FloatVec previousLight[kTilePlanes];
  for (int p = 0; p < kTilePlanes; ++p) {
    previousDistance[p] = outside;
    previousLight[p] = light;
  }

  const int steps = nx + lanes - 1;
  for (int u = 0; u < steps + kTilePlanes - 1; ++u) {
    // From the last plane to the first: plane p reads what plane p - 1 held one step ago.
    HWY_UNROLL(4)
    for (int p = kTilePlanes - 1; p >= 0; --p) {
      const std::ptrdiff_t t = u - p;
      const std::ptrdiff_t at = origin + t * lanes;
      const std::ptrdiff_t atRow = p * rowStride + rowOrigin + t;
      const auto below = p == 0 ? hn::Load(d, buffers.carriedDistance + at) : previousDistance[p == 0 ? 0 : p - 1];
      const auto before = previousDistance[p];
      const auto beside =
          hn::IfThenElse(lane0, hn::Set(d, buffers.rowDistance[atRow]), hn::TableLookupLanes(before, up));
      const auto candidate = upwindUpdate<kIsotropic>(hn::Abs(before), hn::Abs(beside), hn::Abs(below), metric);
      float* cell = buffers.distance + p * planeStride + at;
      const auto distance = keepNearer(hn::Load(d, cell), candidate);
      hn::Store(distance, d, cell);
      previousDistance[p] = distance;
      // The last lane is lanes - 1 voxels behind; a masked store puts it where its x is.
      float* lastRow = buffers.lastRowDistance + atRow - 2 * (lanes - 1);
      hn::BlendedStore(distance, lastLane, d, lastRow);
      if (p == kTilePlanes - 1) hn::Store(distance, d, buffers.carriedDistance + at);

      if constexpr (kLight) {
        const auto lightBelow = p == 0 ? hn::Load(d, buffers.carriedLight + at) : previousLight[p == 0 ? 0 : p - 1];
        const auto lightBefore = previousLight[p];
        const auto lightBeside =
            hn::IfThenElse(lane0, hn::Set(d, buffers.rowLight[atRow]), hn::TableLookupLanes(lightBefore, up));
        // [Singh10] Eq. 6: the neighbours' V tau, weighted.
        const auto sum = hn::Add(hn::Add(hn::Mul(weightX, lightBefore), hn::Mul(weightY, lightBeside)),
                                 hn::Mul(weightZ, lightBelow));
        const auto visibility = hn::IfThenElseZero(hn::Ge(sum, hn::Set(d, kDarkest)), sum);
        // [Singh10] Eq. 7 with h = the smallest spacing.
        const auto transmittance = hn::Min(hn::Max(hn::Add(distance, hn::Set(d, 0.5F)), hn::Zero(d)), hn::Set(d, 1.0F));
        const auto leaving = hn::Mul(visibility, transmittance);
        previousLight[p] = leaving;
        hn::Store(visibility, d, buffers.visibility + p * planeStride + at);
        hn::BlendedStore(leaving, lastLane, d, buffers.lastRowLight + atRow - 2 * (lanes - 1));
        if (p == kTilePlanes - 1) hn::Store(leaving, d, buffers.carriedLight + at);
      }
    }
  }
}

void sweepTileOnTarget(const TileBuffers& buffers, const SweepMetric& metric, int nx) {
  const bool light = buffers.visibility != nullptr;
  if (metric.isotropic) {
    light ? sweepTileAs<true, true>(buffers, metric, nx) : sweepTileAs<true, false>(buffers, metric, nx);
  } else {
    light ? sweepTileAs<false, true>(buffers, metric, nx) : sweepTileAs<false, false>(buffers, metric, nx);
  }
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(lanesOfTarget);
HWY_EXPORT(sweepTileOnTarget);

int tileLanes() { return HWY_DYNAMIC_DISPATCH(lanesOfTarget)(); }

SweepMetric makeSweepMetric(glm::dvec3 spacing) {
  const double smallest = std::min({spacing.x, spacing.y, spacing.z});
  const glm::dvec3 h = spacing / smallest;
  SweepMetric metric;
  metric.spacing = glm::vec3(h);
  metric.inverseSquare = glm::vec3(1.0 / (h * h));
  const double sum = 1 / h.x + 1 / h.y + 1 / h.z;
  metric.weights.x = static_cast<float>(1 / h.x / sum);
  metric.weights.y = static_cast<float>(1 / h.y / sum);
  metric.weights.z = 1.0F - (metric.weights.x + metric.weights.y);  // so that open space stays exactly 1
  metric.isotropic = h.x == 1 && h.y == 1 && h.z == 1;
  return metric;
}

void sweepTile(const TileBuffers& buffers, const SweepMetric& metric, int nx) {
  HWY_DYNAMIC_DISPATCH(sweepTileOnTarget)(buffers, metric, nx);
}

}  // namespace isolume
#endif
