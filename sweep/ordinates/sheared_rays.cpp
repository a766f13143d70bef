#include "sheared_rays.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/ordinates/sheared_rays.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "ray_reader-inl.h"

#ifndef ISOLUME_SWEEP_SHEARED_RAYS_ONCE
#define ISOLUME_SWEEP_SHEARED_RAYS_ONCE
namespace isolume {

// Rows of zeros to each side: what a shift by a row takes in, and what is read beyond the lattice: a point reads at
// most kReach from it, and the layer that it reads lies at most kMostSkipped further along its ray.
inline constexpr int kReach = 4, kGuardRows = kReach + kMostSkipped;
static_assert(kGuardRows <= BitRows::kRowEnd && 2 * kReach <= kMostBeyond);
/// Of the widest vector.
inline constexpr int kVectorWords = 8;
/// Of a layer, that are worked on for all directions before the next.
inline constexpr int kBlockWords = 1024;
/// Layers from one that is copied to one that is fetched into the cache.
inline constexpr int kFetchedAhead = 2;

// B of one direction in the last kKeptLayers layers: rows of bits one after the other, between guard rows of zeros.
// Rows end in zeros (BitRows): what a row takes in from the next or the one before is 0. Layers not yet swept are
// zeros, and so are the rows outside those that a layer is said to meet anything in.
class RayLayers {
 public:
  RayLayers(int rows, int words) : words_(words), rows_(rows + 2 * kGuardRows) {
    // What lies before the first row, and beyond the reach of all, is read too.
    const std::size_t size = static_cast<std::size_t>(layerWords()) * kKeptLayers + 2 * kVectorWords;
    bits_ = makeLargeArray<std::uint64_t>(size);
    std::fill_n(bits_.get(), size, std::uint64_t{0});
  }
  std::ptrdiff_t layerWords() const { return static_cast<std::ptrdiff_t>(rows_) * words_; }
  const std::int32_t* words32() const { return reinterpret_cast<const std::int32_t*>(first()); }
  std::uint64_t* row(int r, int layer) const {
    return first() + slotOf(layer) * layerWords() + static_cast<std::ptrdiff_t>(r + kGuardRows) * words_;
  }
  RowRange met(int layer) const { return met_[static_cast<std::size_t>(slotOf(layer))]; }
  /// What the layer that lay in the same place had in other rows is cleared.
  void setMet(int layer, RowRange rows) {
    RowRange& before = met_[static_cast<std::size_t>(slotOf(layer))];
    const auto clear = [&](int begin, int end) {
      if (begin < end) std::fill(row(begin, layer), row(end, layer), std::uint64_t{0});
    };
    if (rows.empty()) {
      clear(before.begin, before.end);
    } else {
      clear(before.begin, std::min(before.end, rows.begin));
      clear(std::max(before.begin, rows.end), before.end);
    }
    before = rows;
  }

 private:
  std::uint64_t* first() const { return bits_.get() + kVectorWords; }

  int words_, rows_;
  std::array<RowRange, kKeptLayers> met_{};
  LargeArray<std::uint64_t> bits_;
};

}  // namespace isolume
#endif

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

using WordTag = hn::CappedTag<std::uint64_t, kVectorWords>;

// to[x] = solid[x] | from[x + kShift] for the words [begin, end) of a layer, and up to a vector less one more on either
// side; `mask` clears the ends of the rows. Beyond the layer `solid` and `mask` are 0, and so is what is written there.
template <int kShift>
HWY_INLINE void advanceLayer(const std::uint64_t* from, const std::uint64_t* solid, const std::uint64_t* mask,
                             std::ptrdiff_t begin, std::ptrdiff_t end, std::uint64_t* to) {
  const WordTag d;
  const auto lanes = static_cast<std::ptrdiff_t>(hn::Lanes(d));
  for (std::ptrdiff_t w = begin / lanes * lanes; w < end; w += lanes) {
    auto met = hn::LoadU(d, from + w);
    if constexpr (kShift > 0)
      met = hn::Or(hn::ShiftRight<1>(met), hn::ShiftLeft<kWordBits - 1>(hn::LoadU(d, from + w + 1)));
    if constexpr (kShift < 0)
      met = hn::Or(hn::ShiftLeft<1>(met), hn::ShiftRight<kWordBits - 1>(hn::LoadU(d, from + w - 1)));
    hn::StoreU(hn::And(hn::Or(met, hn::Load(d, solid + w)), hn::Load(d, mask + w)), d, to + w);
  }
}

// What the points [begin, end) lose to the directions, or keep, all of which stand at `layer`.
template <int kChannels, bool kCosine>
void readLayer(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
               const std::vector<RayStep>& steps, const std::vector<RayLayers>& rays, int layer,
               const RayPoints& points, std::size_t begin, std::size_t end, const RayTally& tally) {
  const FloatTag d;
  const IntTag di;
  const std::size_t lanes = hn::Lanes(d);
  const auto one = hn::Set(di, 1);
  // Of each direction, from a row and column of kToWholeBits more to where the ray is in that layer and those after it,
  // in bits.
  std::vector<PerSkip<std::int32_t>> on(directions.size());
  const auto rowLength = static_cast<std::uint32_t>(lattice.words * kWordBits);
  for (std::size_t k = 0; k < directions.size(); ++k)
    for (int j = 0; j <= kMostSkipped; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const auto slot = static_cast<std::uint32_t>(slotOf(layer + towards * j) * rays.front().layerWords() * kWordBits);
      const auto row = static_cast<std::uint32_t>(static_cast<int>(steps[k].onRow[at]) + kGuardRows) - kToWholeBits;
      const auto column = static_cast<std::uint32_t>(static_cast<int>(steps[k].onBit[at])) - kToWholeBits;
      on[k][at] = static_cast<std::int32_t>(slot + row * rowLength + column);
    }
  const auto rowBits = hn::Set(di, static_cast<std::int32_t>(rowLength));
  const auto visible = hn::FirstN(d, tally.visible ? lanes : 0);
  const Within withinRows(kReach, lattice.rows), withinColumns(kReach, lattice.length);
  const std::size_t count = directions.size();
  for (std::size_t i = begin; i < end; i += lanes) {
    const PointVector point(lattice, points, layer, i, end);
    FloatVec sums[kChannels];
    for (FloatVec& sum : sums) sum = hn::Zero(d);
    for (std::size_t k = 0; k < count; ++k) {
      const RayDirection& direction = directions[k];
      const auto cosine = point.cosine(direction);
      const auto facing = hn::And(hn::Gt(cosine, hn::Zero(d)), point.inRange);
      if (hn::AllFalse(d, facing)) continue;
      const RayPlace at = placeOnRay<false>(point, direction, steps[k], cosine, facing);
      const auto row = withinRows(at.row), column = withinColumns(at.column);
      const auto place = hn::Add(hn::Add(hn::Mul(row, rowBits), column), chosen(on[k], at.low));
      const auto bits = hn::GatherIndex(di, rays[k].words32(), hn::ShiftRight<5>(place));
      const auto met = hn::TestBit(bits, hn::Shl(one, hn::And(place, hn::Set(di, 31))));
      const auto counts = hn::And(facing, hn::Xor(hn::RebindMask(d, met), visible));
      const auto share = hn::IfThenElseZero(counts, kCosine ? cosine : hn::Set(d, 1.0F));
      for (std::size_t c = 0; c < kChannels; ++c)
        sums[c] = hn::Add(sums[c], hn::Mul(share, hn::Set(d, direction.value[c])));
    }
    // Lanes beyond the end hold 0.
    for (int c = 0; c < kChannels; ++c) {
      std::int32_t* to = tally.sums + c * tally.stride + static_cast<std::ptrdiff_t>(i);
      hn::StoreU(hn::Add(hn::LoadU(di, to), hn::NearestInt(hn::Mul(sums[c], hn::Set(d, tally.scale)))), di, to);
    }
  }
}

void sweepRaysOnTarget(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
                       const RayPoints& points, const RayTally& tally) {
  const auto read = tally.channels == 1   ? readLayer<1, true>
                    : tally.channels == 3 ? readLayer<3, true>
                                          : readLayer<4, false>;
  std::vector<RayLayers> rays;
  for (std::size_t k = 0; k < directions.size(); ++k) rays.emplace_back(lattice.rows, lattice.words);
  const auto words = static_cast<std::size_t>(lattice.words);
  const std::size_t layerWords = words * static_cast<std::size_t>(lattice.rows);
  const auto zeros = [layerWords] {
    auto bits = makeLargeArray<std::uint64_t>(layerWords + kVectorWords);
    std::fill_n(bits.get(), layerWords + kVectorWords, std::uint64_t{0});
    return bits;
  };
  const auto mask = zeros();
  for (std::size_t r = 0; r < static_cast<std::size_t>(lattice.rows); ++r)
    for (int x = 0; x < lattice.length; x += kWordBits)
      mask[r * words + static_cast<std::size_t>(x / kWordBits)] =
          ~std::uint64_t{0} >> (kWordBits - std::min(kWordBits, lattice.length - x));
  // Rows of a layer may lie far apart: copied once for all directions.
  const auto solid = zeros();

  const int blockRows = std::max(1, kBlockWords / lattice.words);
  std::vector<RowRange> met(directions.size());
  std::vector<RayStep> steps(directions.size());
  // The points whose next layer towards the light is this one: those between it and the one on the other side.
  const auto readAt = [&](int layer) {
    const int below = towards > 0 ? layer - 1 : layer;
    read(lattice, towards, directions, steps, rays, layer, points, points.begin(below), points.begin(below + 1), tally);
  };
  const RowRange rowsRead = points.rowsRead();
  const int first = towards > 0 ? lattice.layers - 1 : 0;
  if (tally.visible) {
    // Those beyond the first layer have nothing before them.
    for (std::size_t k = 0; k < directions.size(); ++k) steps[k] = stepInto(first + towards, towards, directions[k]);
    readAt(first + towards);
  }
  for (int done = 0; done < lattice.layers; ++done) {
    const int layer = first - towards * done;
    if (!points.anyFrom(layer, towards)) break;
    const std::uint64_t* from = lattice.data + layer * lattice.layerStride;
    std::uint64_t* to = solid.get();
    RowRange solidRows;
    for (int r = 0; r < lattice.rows; ++r, from += lattice.rowStride) {
      // No hardware sees so long a stride.
      if (done + kFetchedAhead < lattice.layers) hwy::Prefetch(from - towards * kFetchedAhead * lattice.layerStride);
      std::uint64_t any = 0;
      for (int w = 0; w < lattice.words; ++w) any |= * to++ = from[w];
      if (any != 0) solidRows = {solidRows.empty() ? r : solidRows.begin, r + 1};
    }
    for (std::size_t k = 0; k < directions.size(); ++k) {
      steps[k] = stepInto(layer, towards, directions[k]);
      // Rows that are open so far and stay so are left alone.
      const RowRange before = rays[k].met(layer + towards);
      const RowRange carried{before.begin - steps[k].shiftRow, before.end - steps[k].shiftRow};
      met[k] = sharedBy(unionOf(solidRows, carried), rowsRead);
      rays[k].setMet(layer, met[k]);
    }
    // By blocks of rows, which stay in a first cache for all directions.
    for (int begin = 0; begin < lattice.rows; begin += blockRows)
      for (std::size_t k = 0; k < directions.size(); ++k) {
        const RowRange block{std::max(begin, met[k].begin), std::min(begin + blockRows, met[k].end)};
        if (block.empty()) continue;
        const auto advance = [&](auto shift) {
          advanceLayer<decltype(shift)::value>(rays[k].row(steps[k].shiftRow, layer + towards), solid.get(), mask.get(),
                                               static_cast<std::ptrdiff_t>(block.begin) * lattice.words,
                                               static_cast<std::ptrdiff_t>(block.end) * lattice.words,
                                               rays[k].row(0, layer));
        };
        if (steps[k].shiftBit == 0) advance(std::integral_constant<int, 0>());
        if (steps[k].shiftBit > 0) advance(std::integral_constant<int, 1>());
        if (steps[k].shiftBit < 0) advance(std::integral_constant<int, -1>());
      }
    readAt(layer);
  }
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(sweepRaysOnTarget);

int raysAtATime(const LatticeLayers& lattice) {
  constexpr std::size_t kRoom = std::size_t{7} << 18;  // 1.75 MiB
  const auto rows = static_cast<std::size_t>(lattice.rows + 2 * kGuardRows);
  const std::size_t kept = rows * static_cast<std::size_t>(lattice.words) * kKeptLayers * sizeof(std::uint64_t);
  return static_cast<int>(std::clamp<std::size_t>(kRoom / kept, kRayGroup / 2, kRayGroup));
}

void sweepRays(const LatticeLayers& lattice, int towards, const std::vector<RayDirection>& directions,
               const RayPoints& points, const RayTally& tally) {
  assert(tally.channels == 1 || tally.channels == 3 || tally.channels == 4);
  HWY_DYNAMIC_DISPATCH(sweepRaysOnTarget)(lattice, towards, directions, points, tally);
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
