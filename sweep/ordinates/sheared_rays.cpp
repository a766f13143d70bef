#include "sheared_rays.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/ordinates/sheared_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef ISOLUME_SWEEP_SHEARED_RAYS_ONCE
#define ISOLUME_SWEEP_SHEARED_RAYS_ONCE
namespace isolume {

// A position beyond the lattice by kBeyondLattice, plus a step of at most as many layers, plus half a point: 5 rows.
inline constexpr int kGuardRows = 5;
inline constexpr int kWordBits = BitRows::kWordBits;

// B_k of one direction: rows of bits between guard rows of zeros, and a word to each side that a shifted load may read.
// Rows end in zeros (BitRows): what a row takes in from the next or the one before is 0.
class RayLayer {
 public:
  RayLayer(int rows, int words) : words_(words), bits_(makeLargeArray<std::uint64_t>(size(rows, words))) {
    std::fill_n(bits_.get(), size(rows, words), std::uint64_t{0});
  }
  std::uint64_t* row(int r) const { return bits_.get() + static_cast<std::ptrdiff_t>(r + kGuardRows) * words_; }

 private:
  static std::size_t size(int rows, int words) {
    return static_cast<std::size_t>(words) * static_cast<std::size_t>(rows + 2 * kGuardRows);
  }
  int words_;
  LargeArray<std::uint64_t> bits_;
};

inline int roundedOffset(double slope, int layer) { return static_cast<int>(std::floor(slope * layer + 0.5)); }

// How one direction's rays enter a layer, and how far the true rays are from where the rounding puts them.
struct RayStep {
  int shiftBit = 0, shiftRow = 0;
  float lagBit = 0, lagRow = 0;
  float slopeBit = 0, slopeRow = 0;
};
inline RayStep stepInto(int layer, int towards, const RayDirection& direction) {
  RayStep step;
  const int bit = roundedOffset(direction.slopeBit, layer), row = roundedOffset(direction.slopeRow, layer);
  step.shiftBit = roundedOffset(direction.slopeBit, layer + towards) - bit;
  step.shiftRow = roundedOffset(direction.slopeRow, layer + towards) - row;
  step.lagBit = static_cast<float>(direction.slopeBit * layer - bit);
  step.lagRow = static_cast<float>(direction.slopeRow * layer - row);
  step.slopeBit = static_cast<float>(direction.slopeBit);
  step.slopeRow = static_cast<float>(direction.slopeRow);
  return step;
}

}  // namespace isolume
#endif

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using WordTag = hn::CappedTag<std::uint64_t, BitRows::kRowWords>;
using FloatTag = hn::ScalableTag<float>;

// to[x] = solid[x] | from[x + kShift], for one row; `mask` clears the bits beyond it. May be in place.
template <int kShift>
HWY_INLINE void advanceRow(const std::uint64_t* from, const std::uint64_t* solid, const std::uint64_t* mask, int words,
                           std::uint64_t* to) {
  const WordTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto step = [&](int w) {
    auto met = hn::Load(d, from + w);
    if constexpr (kShift > 0)
      met = hn::Or(hn::ShiftRight<1>(met), hn::ShiftLeft<kWordBits - 1>(hn::LoadU(d, from + w + 1)));
    if constexpr (kShift < 0)
      met = hn::Or(hn::ShiftLeft<1>(met), hn::ShiftRight<kWordBits - 1>(hn::LoadU(d, from + w - 1)));
    hn::Store(hn::And(hn::Or(met, hn::Load(d, solid + w)), hn::Load(d, mask + w)), d, to + w);
  };
  // In the order in which a shift in place reads words that are still old.
  if constexpr (kShift < 0) {
    for (int w = words - lanes; w >= 0; w -= lanes) step(w);
  } else {
    for (int w = 0; w < words; w += lanes) step(w);
  }
}

// `solid`: the rows of this layer, one after the other.
template <int kShift>
HWY_INLINE void advanceLayer(const std::uint64_t* solid, int rows, int words, int shiftRow, const std::uint64_t* mask,
                             const RayLayer& rays) {
  const auto advance = [&](int r) {
    advanceRow<kShift>(rays.row(r + shiftRow), solid + static_cast<std::ptrdiff_t>(r) * words, mask, words,
                       rays.row(r));
  };
  // Downwards too where a shifted load takes in the end of the row before: a load of what was just stored waits.
  if (shiftRow < 0 || (shiftRow == 0 && kShift < 0)) {
    for (int r = rows - 1; r >= 0; --r) advance(r);
  } else {
    for (int r = 0; r < rows; ++r) advance(r);
  }
}

// What the points [begin, end) lose to the directions, all of which stand at `layer`.
void readLayer(const std::vector<RayDirection>& directions, const std::vector<RayStep>& steps,
               const std::vector<RayLayer>& rays, int length, int words, int layer, const RayPoints& points,
               std::size_t begin, std::size_t end, float scale, std::int32_t* sums) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  const std::size_t lanes = hn::Lanes(d);
  const auto one = hn::Set(di, 1);
  // Places are whole numbers below 2^24: exact in float.
  const auto rowBits = hn::Set(d, static_cast<float>(words * kWordBits));
  const auto firstBit = hn::Set(d, -1.0F), lastBit = hn::Set(d, static_cast<float>(length));
  for (std::size_t i = begin; i < end; i += lanes) {
    // Lanes beyond the end may hold points of other layers.
    const auto ahead = hn::Min(hn::Max(hn::Sub(hn::Set(d, static_cast<float>(layer)), hn::LoadU(d, points.layer() + i)),
                                       hn::Set(d, -kBeyondLattice)),
                               hn::Set(d, kBeyondLattice));
    const auto bit = hn::LoadU(d, points.bit() + i), row = hn::LoadU(d, points.row() + i);
    const auto nb = hn::LoadU(d, points.normalBit() + i), nr = hn::LoadU(d, points.normalRow() + i),
               nl = hn::LoadU(d, points.normalLayer() + i);
    const auto inRange = hn::FirstN(d, std::min(lanes, end - i));
    auto sum = hn::Zero(d);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const RayDirection& to = directions[k];
      const auto cosine = hn::Add(hn::Add(hn::Mul(nb, hn::Set(d, to.weightBit)), hn::Mul(nr, hn::Set(d, to.weightRow))),
                                  hn::Mul(nl, hn::Set(d, to.weightLayer)));
      const auto facing = hn::And(hn::Gt(cosine, hn::Zero(d)), inRange);
      if (hn::AllFalse(d, facing)) continue;
      const auto placeOf = [&](auto at, float lag, float slope) {
        return hn::Round(hn::Add(hn::Sub(at, hn::Set(d, lag)), hn::Mul(ahead, hn::Set(d, slope))));
      };
      // Beyond either end of a row there is a bit that is 0.
      const auto x = hn::Min(hn::Max(placeOf(bit, steps[k].lagBit, steps[k].slopeBit), firstBit), lastBit);
      const auto y = placeOf(row, steps[k].lagRow, steps[k].slopeRow);
      const auto place = hn::ConvertTo(di, hn::Add(hn::Mul(y, rowBits), x));
      const auto bits =
          hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(rays[k].row(0)), hn::ShiftRight<5>(place));
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
  std::vector<RayLayer> rays;
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
      const int shiftRow = steps[k].shiftRow;
      if (steps[k].shiftBit == 0)
        advanceLayer<0>(solid.get(), lattice.rows, lattice.words, shiftRow, mask.get(), rays[k]);
      if (steps[k].shiftBit > 0)
        advanceLayer<1>(solid.get(), lattice.rows, lattice.words, shiftRow, mask.get(), rays[k]);
      if (steps[k].shiftBit < 0)
        advanceLayer<-1>(solid.get(), lattice.rows, lattice.words, shiftRow, mask.get(), rays[k]);
    }
    // The points whose next layer towards the light is this one: those between it and the one on the other side.
    const int below = towards > 0 ? layer - 1 : layer;
    readLayer(directions, steps, rays, lattice.length, lattice.words, layer, points, points.begin(below),
              points.begin(below + 1), scale, sums);
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

LatticeLayers layersOf(const SolidLattice& lattice, int axis) {
  const BitRows& bits = axis == 0 ? lattice.alongY : lattice.alongX;
  LatticeLayers layers;
  const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
  layers.data = bits.data.get();
  layers.length = lattice.size[axes.bit];
  layers.rows = lattice.size[axes.row];
  layers.layers = lattice.size[axes.layer];
  layers.words = bits.words;
  const std::ptrdiff_t across = bits.words, along = across * bits.rows;
  // Rows of the storage follow each other along x or y, its layers along z.
  layers.rowStride = axes.row == 2 ? along : across;
  layers.layerStride = axes.row == 2 ? across : along;
  return layers;
}

}  // namespace isolume
#endif
