#include "sheared_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/ordinates/sheared_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef ISOLUME_SWEEP_SHEARED_RAYS_ONCE
#define ISOLUME_SWEEP_SHEARED_RAYS_ONCE
namespace isolume {

// Rows of zeros to each side: one that a shift by a row takes in and a read beyond the lattice is sent to, and one more
// for the bit before that row's first.
inline constexpr int kGuardRows = 2;

// B of one direction in the last kKeptLayers layers: rows of bits between guard rows of zeros. Rows end in zeros
// (BitRows): what a row takes in from the next or the one before is 0. Layers not yet swept are zeros.
inline constexpr int kMostSkipped = 3;
inline constexpr int kKeptLayers = kMostSkipped + 1;
class RayLayers {
 public:
  RayLayers(int rows, int words) : words_(words), rows_(rows + 2 * kGuardRows) {
    const std::size_t size = static_cast<std::size_t>(layerWords()) * kKeptLayers;
    bits_ = makeLargeArray<std::uint64_t>(size);
    std::fill_n(bits_.get(), size, std::uint64_t{0});
  }
  std::ptrdiff_t layerWords() const { return static_cast<std::ptrdiff_t>(rows_) * words_; }
  /// Where a layer is kept; layers from -kMostSkipped on.
  static int slotOf(int layer) { return (layer + kKeptLayers) % kKeptLayers; }
  const std::int32_t* words32() const { return reinterpret_cast<const std::int32_t*>(bits_.get()); }
  std::uint64_t* row(int r, int layer) const {
    return bits_.get() + slotOf(layer) * layerWords() + static_cast<std::ptrdiff_t>(r + kGuardRows) * words_;
  }

 private:
  int words_, rows_;
  LargeArray<std::uint64_t> bits_;
};

inline int roundedOffset(double slope, int layer) { return static_cast<int>(std::floor(slope * layer + 0.5)); }

// How one direction's rays enter a layer, how far the true rays are from where the rounding puts them, and where they
// are one, two and three layers on.
struct RayStep {
  int shiftBit = 0, shiftRow = 0;
  float lagBit = 0, lagRow = 0;
  std::array<float, kMostSkipped + 1> onBit{}, onRow{};
};
inline RayStep stepInto(int layer, int towards, const RayDirection& direction) {
  RayStep step;
  const int bit = roundedOffset(direction.slopeBit, layer), row = roundedOffset(direction.slopeRow, layer);
  for (int j = 0; j <= kMostSkipped; ++j) {
    const auto i = static_cast<std::size_t>(j);
    step.onBit[i] = static_cast<float>(roundedOffset(direction.slopeBit, layer + towards * j) - bit);
    step.onRow[i] = static_cast<float>(roundedOffset(direction.slopeRow, layer + towards * j) - row);
  }
  step.shiftBit = static_cast<int>(step.onBit[1]);
  step.shiftRow = static_cast<int>(step.onRow[1]);
  step.lagBit = static_cast<float>(direction.slopeBit * layer - bit);
  step.lagRow = static_cast<float>(direction.slopeRow * layer - row);
  return step;
}

}  // namespace isolume
#endif

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using WordTag = hn::CappedTag<std::uint64_t, BitRows::kRowWords>;
using FloatTag = hn::ScalableTag<float>;

// to[x] = solid[x] | from[x + kShift], for one row; `mask` clears the bits beyond it.
template <int kShift>
HWY_INLINE void advanceRow(const std::uint64_t* from, const std::uint64_t* solid, const std::uint64_t* mask, int words,
                           std::uint64_t* to) {
  const WordTag d;
  for (int w = 0; w < words; w += static_cast<int>(hn::Lanes(d))) {
    auto met = hn::Load(d, from + w);
    if constexpr (kShift > 0)
      met = hn::Or(hn::ShiftRight<1>(met), hn::ShiftLeft<kWordBits - 1>(hn::LoadU(d, from + w + 1)));
    if constexpr (kShift < 0)
      met = hn::Or(hn::ShiftLeft<1>(met), hn::ShiftRight<kWordBits - 1>(hn::LoadU(d, from + w - 1)));
    hn::Store(hn::And(hn::Or(met, hn::Load(d, solid + w)), hn::Load(d, mask + w)), d, to + w);
  }
}

// `solid`: the rows of this layer, one after the other.
template <int kShift>
HWY_INLINE void advanceLayer(const std::uint64_t* solid, int rows, int words, int layer, int towards, int shiftRow,
                             const std::uint64_t* mask, const RayLayers& rays) {
  const std::uint64_t* from = rays.row(shiftRow, layer + towards);
  std::uint64_t* to = rays.row(0, layer);
  for (int r = 0; r < rows; ++r, from += words, to += words, solid += words)
    advanceRow<kShift>(from, solid, mask, words, to);
}

using FloatMask = hn::Mask<FloatTag>;

// value[j] where j layers go by: skips[j] tells that more than j do.
template <class Tag, class T>
HWY_INLINE hn::Vec<Tag> skipped(Tag d, const std::array<T, kMostSkipped + 1>& value, const hn::Mask<Tag>* skips) {
  auto chosen = hn::Set(d, value[0]);
  for (std::size_t j = 0; j < kMostSkipped; ++j) chosen = hn::IfThenElse(skips[j], hn::Set(d, value[j + 1]), chosen);
  return chosen;
}

// What the points [begin, end) lose to the directions, all of which stand at `layer`.
void readLayer(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
               const std::vector<RayStep>& steps, const std::vector<RayLayers>& rays, int layer,
               const RayPoints& points, std::size_t begin, std::size_t end, float scale, std::int32_t* sums) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  const std::size_t lanes = hn::Lanes(d);
  const auto one = hn::Set(di, 1);
  // Places within a layer are whole numbers below 2^24: exact in float.
  const auto rowBits = hn::Set(d, static_cast<float>(lattice.words * kWordBits));
  const auto justBefore = hn::Set(d, -1.0F), lastBit = hn::Set(d, static_cast<float>(lattice.length)),
             lastRow = hn::Set(d, static_cast<float>(lattice.rows));
  const auto farthest = hn::Set(d, kBeyondLattice);
  const auto perBit = hn::Set(d, 1 / lattice.cellBit), perRow = hn::Set(d, 1 / lattice.cellRow),
             perLayer = hn::Set(d, 1 / lattice.cellLayer);
  std::array<std::int32_t, kMostSkipped + 1> kept{};  // first word, of 32 bits, of the layers on
  for (int j = 0; j <= kMostSkipped; ++j)
    kept[static_cast<std::size_t>(j)] =
        static_cast<std::int32_t>(RayLayers::slotOf(layer + towards * j) * rays.front().layerWords() * 2);
  const auto guard = static_cast<std::int32_t>(kGuardRows * lattice.words * 2);
  for (std::size_t i = begin; i < end; i += lanes) {
    // Lanes beyond the end may hold points of other layers.
    const auto ahead = hn::Min(
        hn::Max(hn::Sub(hn::Set(d, static_cast<float>(layer)), hn::LoadU(d, points.layer() + i)), hn::Neg(farthest)),
        farthest);
    const auto layersAhead = hn::Abs(ahead);
    const auto bit = hn::LoadU(d, points.bit() + i), row = hn::LoadU(d, points.row() + i);
    const auto nb = hn::LoadU(d, points.normalBit() + i), nr = hn::LoadU(d, points.normalRow() + i),
               nl = hn::LoadU(d, points.normalLayer() + i);
    const auto width = hn::Add(
        hn::Add(hn::Mul(hn::Abs(nb), hn::Set(d, lattice.cellBit)), hn::Mul(hn::Abs(nr), hn::Set(d, lattice.cellRow))),
        hn::Mul(hn::Abs(nl), hn::Set(d, lattice.cellLayer)));
    const auto toClear = hn::Mul(width, hn::Set(d, kClearance - kLift));
    const auto inRange = hn::FirstN(d, std::min(lanes, end - i));
    auto sum = hn::Zero(d);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const RayDirection& to = directions[k];
      const RayStep& step = steps[k];
      const auto cosine = hn::Add(hn::Add(hn::Mul(nb, hn::Set(d, to.weightBit)), hn::Mul(nr, hn::Set(d, to.weightRow))),
                                  hn::Mul(nl, hn::Set(d, to.weightLayer)));
      const auto facing = hn::And(hn::Gt(cosine, hn::Zero(d)), inRange);
      if (hn::AllFalse(d, facing)) continue;
      const auto rise = hn::Mul(cosine, hn::Set(d, to.risePerCosine));
      FloatMask skips[kMostSkipped];
      auto height = hn::Mul(rise, layersAhead);
      for (FloatMask& skip : skips) {
        skip = hn::Lt(height, toClear);
        height = hn::Add(height, rise);
      }
      // What is still missing after these layers, the ray is lifted by along the normal.
      const auto missing = hn::Max(hn::Sub(toClear, height), hn::Zero(d));
      const auto layersUp = hn::Mul(hn::Mul(missing, nl), perLayer);
      const auto placeOf = [&](auto at, float lag, float slope, const auto& on, auto normal, auto perCell) {
        const auto along = hn::Mul(hn::Sub(ahead, layersUp), hn::Set(d, slope));
        const auto lifted = hn::Add(hn::Sub(at, hn::Set(d, lag)), hn::Mul(hn::Mul(missing, normal), perCell));
        return hn::Add(hn::Round(hn::Add(lifted, along)), skipped(d, on, skips));
      };
      // Beyond either end of a row there is a bit that is 0, and beyond the first and last row one of zeros.
      const auto slopeBit = static_cast<float>(to.slopeBit), slopeRow = static_cast<float>(to.slopeRow);
      const auto x = hn::Min(hn::Max(placeOf(bit, step.lagBit, slopeBit, step.onBit, nb, perBit), justBefore), lastBit);
      const auto y = hn::Min(hn::Max(placeOf(row, step.lagRow, slopeRow, step.onRow, nr, perRow), justBefore), lastRow);
      const auto place = hn::ConvertTo(di, hn::Add(hn::Mul(y, rowBits), x));
      hn::Mask<decltype(di)> whole[kMostSkipped];
      for (int j = 0; j < kMostSkipped; ++j) whole[j] = hn::RebindMask(di, skips[j]);
      const auto word = hn::Add(hn::ShiftRight<5>(place), skipped(di, kept, whole));
      const auto bits = hn::GatherIndex(di, rays[k].words32() + guard, word);
      const auto blocked = hn::TestBit(bits, hn::Shl(one, hn::And(place, hn::Set(di, 31))));
      sum = hn::Add(sum, hn::IfThenElseZero(hn::And(facing, hn::RebindMask(d, blocked)), cosine));
    }
    const auto rounded = hn::NearestInt(hn::Mul(sum, hn::Set(d, scale)));
    // Lanes beyond the end hold 0.
    hn::StoreU(hn::Add(hn::LoadU(di, sums + i), rounded), di, sums + i);
  }
}

void sweepRaysOnTarget(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
                       const RayPoints& points, float scale, std::int32_t* sums) {
  std::vector<RayLayers> rays;
  for (std::size_t k = 0; k < directions.size(); ++k) rays.emplace_back(lattice.rows, lattice.words);
  const auto words = static_cast<std::size_t>(lattice.words);
  const auto mask = makeLargeArray<std::uint64_t>(words);
  std::fill_n(mask.get(), words, std::uint64_t{0});
  for (int x = 0; x < lattice.length; ++x)
    mask[static_cast<std::size_t>(x / kWordBits)] |= std::uint64_t{1} << (x % kWordBits);
  // Rows of a layer may lie far apart: copied once for all directions.
  const auto solid = makeLargeArray<std::uint64_t>(words * static_cast<std::size_t>(lattice.rows));

  std::vector<RayStep> steps(directions.size());
  const int first = towards > 0 ? lattice.layers - 1 : 0;
  for (int done = 0; done < lattice.layers; ++done) {
    const int layer = first - towards * done;
    for (int r = 0; r < lattice.rows; ++r)
      std::copy_n(lattice.data + layer * lattice.layerStride + r * lattice.rowStride, words,
                  solid.get() + static_cast<std::size_t>(r) * words);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      steps[k] = stepInto(layer, towards, directions[k]);
      const auto advance = [&](auto shift) {
        advanceLayer<decltype(shift)::value>(solid.get(), lattice.rows, lattice.words, layer, towards,
                                             steps[k].shiftRow, mask.get(), rays[k]);
      };
      if (steps[k].shiftBit == 0) advance(std::integral_constant<int, 0>());
      if (steps[k].shiftBit > 0) advance(std::integral_constant<int, 1>());
      if (steps[k].shiftBit < 0) advance(std::integral_constant<int, -1>());
    }
    // The points whose next layer towards the light is this one: those between it and the one on the other side.
    const int below = towards > 0 ? layer - 1 : layer;
    readLayer(lattice, towards, directions, steps, rays, layer, points, points.begin(below), points.begin(below + 1),
              scale, sums);
  }
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(sweepRaysOnTarget);

void sweepRays(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
               const RayPoints& points, float scale, std::int32_t* sums) {
  HWY_DYNAMIC_DISPATCH(sweepRaysOnTarget)(lattice, towards, directions, points, scale, sums);
}

LatticeLayers layersOf(const SolidLattice& lattice, glm::dvec3 spacing, int axis) {
  const BitRows& bits = axis == 0 ? lattice.alongY : lattice.alongX;
  LatticeLayers layers;
  const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
  layers.data = bits.data.get();
  layers.length = lattice.size[axes.bit];
  layers.rows = lattice.size[axes.row];
  layers.layers = lattice.size[axes.layer];
  layers.words = bits.words;
  const glm::vec3 cell(spacing / static_cast<double>(lattice.refinement));
  layers.cellBit = cell[axes.bit];
  layers.cellRow = cell[axes.row];
  layers.cellLayer = cell[axes.layer];
  const std::ptrdiff_t across = bits.words, along = across * bits.rows;
  // Rows of the storage follow each other along x or y, its layers along z.
  layers.rowStride = axes.row == 2 ? along : across;
  layers.layerStride = axes.row == 2 ? across : along;
  return layers;
}

}  // namespace isolume
#endif
