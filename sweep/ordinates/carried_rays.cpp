#include "carried_rays.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/ordinates/carried_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "ray_reader-inl.h"

#ifndef ISOLUME_SWEEP_CARRIED_RAYS_ONCE
#define ISOLUME_SWEEP_CARRIED_RAYS_ONCE
namespace isolume {

// A layer of numbers: rows with room for a vector on either side, between guard rows; what lies around the lattice
// keeps the value that nothing has.
inline constexpr int kCarriedPad = 64, kCarriedGuardRows = 2;
template <class T>
class CarriedLayers {
 public:
  CarriedLayers(int length, int rows, int layers, T nothing)
      : length_(length),
        stride_(kCarriedPad + (length / kCarriedPad + 2) * kCarriedPad),
        layerSize_(static_cast<std::ptrdiff_t>(rows + 2 * kCarriedGuardRows) * stride_),
        nothing_(nothing) {
    // A word is gathered for every number.
    const std::size_t count = static_cast<std::size_t>(layerSize_) * static_cast<std::size_t>(layers) + kCarriedPad;
    values_ = makeLargeArray<T>(count);
    std::fill_n(values_.get(), count, nothing);
  }
  T* row(int r, int slot) const { return values_.get() + slot * layerSize_ + placeOf(r); }
  std::ptrdiff_t placeOf(int r) const {
    return static_cast<std::ptrdiff_t>(r + kCarriedGuardRows) * stride_ + kCarriedPad;
  }
  int stride() const { return stride_; }
  std::ptrdiff_t layerSize() const { return layerSize_; }
  const std::int32_t* words32() const { return reinterpret_cast<const std::int32_t*>(values_.get()); }
  /// What a vector wrote beyond the end of a row becomes nothing again.
  void closeRow(int r, int slot) const { std::fill_n(row(r, slot) + length_, kCarriedPad, nothing_); }

 private:
  int length_, stride_;
  std::ptrdiff_t layerSize_;
  T nothing_;
  LargeArray<T> values_;
};

// In a layer of values to be met: no solid.
inline constexpr std::uint8_t kOpen = 255;
static_assert(kLargestCarried < kOpen);

// The lattice points of one layer, as `kind` wants them.
class MetLayer {
 public:
  MetLayer(const LatticeLayers& lattice, bool nearest)
      : lattice_(lattice),
        nearest_(nearest),
        values_(lattice.length, lattice.rows, 1, nearest ? kOpen : std::uint8_t{0}) {}

  void fill(int layer, const SampleLayers& samples, const std::vector<std::uint8_t>& values) {
    const std::uint8_t solid = nearest_ ? 0 : kSolidShare, open = nearest_ ? kOpen : 0;
    for (int r = 0; r < lattice_.rows; ++r) {
      const std::uint64_t* bits = lattice_.data + layer * lattice_.layerStride + r * lattice_.rowStride;
      std::uint8_t* to = values_.row(r, 0);
      for (int x = 0; x < lattice_.length; x += kWordBits) {
        const std::uint64_t word = bits[x / kWordBits];
        const int count = std::min(kWordBits, lattice_.length - x);
        if (word == 0 || word == ~std::uint64_t{0}) {
          std::memset(to + x, word == 0 ? open : solid, static_cast<std::size_t>(count));
          continue;
        }
        for (int i = 0; i < count; ++i) to[x + i] = (word >> i & 1) != 0 ? solid : open;
      }
    }
    for (std::uint32_t i = samples.begin[static_cast<std::size_t>(layer)];
         i < samples.begin[static_cast<std::size_t>(layer) + 1]; ++i)
      values_.row(samples.row[i], 0)[samples.column[i]] = values[samples.sample[i]];
  }
  const std::uint8_t* row(int r) const { return values_.row(r, 0); }

 private:
  LatticeLayers lattice_;
  bool nearest_;
  CarriedLayers<std::uint8_t> values_;
};

}  // namespace isolume
#endif

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

struct Nearest {
  using State = std::uint8_t;
  static constexpr State kNothing = kOpen;
  static HWY_INLINE void advanceRow(const State* from, const std::uint8_t* met, int length, State* to) {
    const hn::ScalableTag<std::uint8_t> d;
    const auto open = hn::Set(d, kOpen);
    for (int x = 0; x < length; x += static_cast<int>(hn::Lanes(d))) {
      const auto here = hn::LoadU(d, met + x);
      hn::StoreU(hn::IfThenElse(hn::Eq(here, open), hn::LoadU(d, from + x), here), d, to + x);
    }
  }
};

struct Length {
  using State = std::uint16_t;
  static constexpr State kNothing = 0;
  static HWY_INLINE void advanceRow(const State* from, const std::uint8_t* met, int length, State* to) {
    const hn::ScalableTag<std::uint16_t> d;
    const hn::Rebind<std::uint8_t, decltype(d)> half;
    for (int x = 0; x < length; x += static_cast<int>(hn::Lanes(d)))
      hn::StoreU(hn::SaturatedAdd(hn::LoadU(d, from + x), hn::PromoteTo(d, hn::LoadU(half, met + x))), d, to + x);
  }
};

// exp(-x) for x >= 0 to 1e-6, without fused operations: the same bits on every target.
HWY_INLINE FloatVec decay(FloatVec x) {
  const FloatTag d;
  const IntTag di;
  constexpr float kLog2E = 1.44269504F, kLeastPower = -120;
  const auto power = hn::Max(hn::Mul(x, hn::Set(d, -kLog2E)), hn::Set(d, kLeastPower));
  const auto whole = hn::Floor(power);
  const auto part = hn::Sub(power, whole);
  // 2^part on [0, 1): Taylor's series of exp(part ln 2).
  constexpr std::array<float, 7> kTerms{
      1.54035304e-4F, 1.33335581e-3F, 9.61812911e-3F, 5.55041087e-2F, 2.40226507e-1F, 6.93147181e-1F, 1};
  auto sum = hn::Zero(d);
  for (const float term : kTerms) sum = hn::Add(hn::Mul(sum, part), hn::Set(d, term));
  const auto scale = hn::BitCast(d, hn::ShiftLeft<23>(hn::Add(hn::ConvertTo(di, whole), hn::Set(di, 127))));
  return hn::Mul(sum, scale);
}

// Over so many layers the start of a ray that looks inwards is put right.
inline constexpr int kShareLayers = 4;

// What the points [begin, end) read from the rays of one direction at `layer`.
template <class Kind>
void readCarried(const LatticeLayers& lattice, int towards, const RayDirection& direction, const RayStep& step,
                 const CarriedLayers<typename Kind::State>& rays, int layer, const RayPoints& points, std::size_t begin,
                 std::size_t end, const CarriedTally& tally) {
  using State = typename Kind::State;
  constexpr bool kLength = sizeof(State) == sizeof(std::uint16_t);
  const FloatTag d;
  const IntTag di;
  const auto stateMask = hn::Set(di, (1 << (8 * sizeof(State))) - 1);
  const auto size = static_cast<std::int32_t>(sizeof(State));
  PerSkip<std::int32_t> kept{};  // bytes
  for (int j = 0; j <= kMostSkipped; ++j)
    kept[static_cast<std::size_t>(j)] =
        size * static_cast<std::int32_t>(slotOf(layer + towards * j) * rays.layerSize() + rays.placeOf(0));
  const auto stride = hn::Set(di, rays.stride());
  const Within withinRows(1, lattice.rows), withinColumns(1, lattice.length);
  const float voxel = std::min({lattice.cellBit, lattice.cellRow, lattice.cellLayer}), perVoxel = 1 / voxel;
  const auto add = [&](std::int32_t* to, FloatVec value, float scale) {
    hn::StoreU(hn::Add(hn::LoadU(di, to), hn::NearestInt(hn::Mul(value, hn::Set(d, scale)))), di, to);
  };
  for (std::size_t i = begin; i < end; i += hn::Lanes(d)) {
    const PointVector point(lattice, points, layer, i, end, kLength ? kShareBlur * voxel : 0.0F);
    const auto cosine = point.cosine(direction);
    const auto facing = hn::And(hn::Gt(cosine, hn::Zero(d)), point.inRange);
    const auto wanted = kLength ? point.inRange : facing;
    if (hn::AllFalse(d, wanted)) continue;
    const RayPlace at = placeOnRay<kLength>(point, direction, step, cosine, facing);
    const auto row = withinRows(hn::Add(at.row, chosen(step.onRow, at.low)));
    const auto column = withinColumns(hn::Add(at.column, chosen(step.onBit, at.low)));
    const auto whole = hn::Set(di, static_cast<std::int32_t>(kToWholeBits));
    const auto place = hn::Add(hn::Mul(hn::Sub(row, whole), stride), hn::Sub(column, whole));
    const auto bytes = hn::Add(hn::Mul(place, hn::Set(di, size)), chosen(kept, at.low));
    const auto state = hn::And(hn::GatherOffset(di, rays.words32(), bytes), stateMask);
    std::int32_t* to = tally.sums + i;
    if constexpr (kLength) {
      const auto slope = hn::Abs(cosine);
      auto layers = hn::Mul(hn::ConvertTo(d, state), hn::Set(d, 1.0F / kSolidShare));
      // Those who look inwards: from the surface to the nearer edge of the next layer, and what the shares of the
      // layers that follow lack, since the surface that cuts them is the one that the ray starts from.
      const auto start = hn::Mul(point.ahead, hn::Set(d, static_cast<float>(towards)));
      const auto depthPerLayer = hn::Mul(slope, hn::Set(d, direction.risePerCosine * perVoxel));
      auto own = hn::Sub(start, hn::Set(d, 0.5F));
      for (int j = 0; j < kShareLayers; ++j) {
        const auto depth = hn::Mul(depthPerLayer, hn::Add(start, hn::Set(d, static_cast<float>(j))));
        own = hn::Add(own, hn::Max(hn::Sub(hn::Set(d, 0.5F), depth), hn::Zero(d)));
      }
      layers = hn::Max(hn::Add(layers, hn::IfThenElse(facing, hn::Zero(d), own)), hn::Zero(d));
      const auto length = hn::Mul(layers, hn::Set(d, direction.risePerCosine));
      const auto light = hn::Mul(hn::Mul(slope, hn::Set(d, direction.value[0])),
                                 decay(hn::Mul(length, hn::Set(d, 1 / tally.meanFreePath))));
      add(to, hn::IfThenElseZero(point.inRange, light), tally.scale);
      const auto inwards = hn::AndNot(facing, point.inRange);
      add(to + tally.stride,
          hn::IfThenElseZero(inwards, hn::Mul(hn::Mul(slope, hn::Set(d, direction.value[0])), length)),
          tally.lengthScale);
    } else {
      const auto met = hn::And(facing, hn::RebindMask(d, hn::Ne(state, hn::Set(di, kOpen))));
      add(to, hn::IfThenElseZero(met, hn::Mul(cosine, hn::ConvertTo(d, state))), tally.scale);
    }
  }
}

template <class Kind>
void sweepKind(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
               const RayPoints& points, const SampleLayers& samples, const std::vector<std::uint8_t>& values,
               const CarriedTally& tally) {
  using Rays = CarriedLayers<typename Kind::State>;
  std::vector<Rays> rays;
  for (std::size_t k = 0; k < directions.size(); ++k)
    rays.emplace_back(lattice.length, lattice.rows, kKeptLayers, Kind::kNothing);
  MetLayer met(lattice, tally.kind == CarriedTally::Kind::nearest);
  const auto readAt = [&](int layer, std::size_t k, const RayStep& step) {
    const int below = towards > 0 ? layer - 1 : layer;
    readCarried<Kind>(lattice, towards, directions[k], step, rays[k], layer, points, points.begin(below),
                      points.begin(below + 1), tally);
  };
  const RowRange rows = unionOf(points.rowsRead(), samples.rows);
  const int first = towards > 0 ? lattice.layers - 1 : 0, beyond = first + towards;
  // Points beyond the first layer have nothing before them, and see all light.
  for (std::size_t k = 0; k < directions.size(); ++k) readAt(beyond, k, stepInto(beyond, towards, directions[k]));
  for (int done = 0; done < lattice.layers; ++done) {
    const int layer = first - towards * done, slot = slotOf(layer), before = slotOf(layer + towards);
    if (!points.anyFrom(layer, towards)) break;
    met.fill(layer, samples, values);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const RayStep step = stepInto(layer, towards, directions[k]);
      for (int r = rows.begin; r < rows.end; ++r) {
        Kind::advanceRow(rays[k].row(r + step.shiftRow, before) + step.shiftBit, met.row(r), lattice.length,
                         rays[k].row(r, slot));
        rays[k].closeRow(r, slot);
      }
      readAt(layer, k, step);
    }
  }
}

void sweepCarriedOnTarget(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
                          const RayPoints& points, const SampleLayers& samples, const std::vector<std::uint8_t>& values,
                          const CarriedTally& tally) {
  if (tally.kind == CarriedTally::Kind::nearest)
    sweepKind<Nearest>(lattice, towards, directions, points, samples, values, tally);
  else
    sweepKind<Length>(lattice, towards, directions, points, samples, values, tally);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(sweepCarriedOnTarget);

void sweepCarriedRays(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
                      const RayPoints& points, const SampleLayers& samples, const std::vector<std::uint8_t>& values,
                      const CarriedTally& tally) {
  HWY_DYNAMIC_DISPATCH(sweepCarriedOnTarget)(lattice, towards, directions, points, samples, values, tally);
}

}  // namespace isolume
#endif
