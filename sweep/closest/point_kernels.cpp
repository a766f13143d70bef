#include "point_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "closest_point.h"
#include "offset_field.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/closest/point_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "point_search-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

// Distances from the sample to the crossings of its own edges, along -x, +x, -y, ...; kUnsetOffset where there is none.
struct OwnCrossings {
  FloatVec along[3][2];
};

HWY_INLINE OwnCrossings ownCrossings(const VectorLevel& level, const PointBatch& batch, std::size_t i) {
  const FloatTag d;
  const IntTag di;
  const PointFrame& frame = level.frame;
  const auto x = hn::LoadU(di, batch.x.data() + i), y = hn::LoadU(di, batch.y.data() + i);
  const auto z = hn::LoadU(di, batch.z.data() + i);
  const auto one = hn::Set(di, 1), none = hn::Zero(di);
  const auto valueAt = [&](IntVec atX, IntVec atY, IntVec atZ) {
    const auto plane = hn::Sub(atZ, hn::Set(di, level.firstPlane));
    const auto row = hn::Add(hn::Mul(plane, hn::Set(di, frame.size.y)), atY);
    return hn::GatherIndex(d, level.base, hn::Add(hn::Mul(row, hn::Set(di, frame.size.x)), atX));
  };
  // Missing neighbours are the sample itself, which it never crosses.
  const auto before = [&](IntVec at) { return hn::Max(hn::Sub(at, one), none); };
  const auto after = [&](IntVec at, int size) { return hn::Min(hn::Add(at, one), hn::Set(di, size - 1)); };
  const auto here = valueAt(x, y, z);
  const auto inside = hn::VecFromMask(d, hn::Gt(here, hn::Zero(d)));
  const FloatVec there[3][2] = {{valueAt(before(x), y, z), valueAt(after(x, frame.size.x), y, z)},
                                {valueAt(x, before(y), z), valueAt(x, after(y, frame.size.y), z)},
                                {valueAt(x, y, before(z)), valueAt(x, y, after(z, frame.size.z))}};
  OwnCrossings crossings;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const FloatVec other = there[axis][side];
      const auto crossed = hn::MaskFromVec(hn::Xor(inside, hn::VecFromMask(d, hn::Gt(other, hn::Zero(d)))));
      const auto along = hn::Mul(hn::Div(here, hn::Sub(here, other)), hn::Set(d, frame.step[axis]));
      crossings.along[axis][side] = hn::IfThenElse(crossed, along, hn::Set(d, kUnsetOffset));
    }
  return crossings;
}

void crossingStarts(const PointFrame& frame, PointBatch& batch) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  const VectorLevel level(frame, batch);
  for (std::size_t i = 0; i < batch.padded(); i += hn::Lanes(d)) {
    const OwnCrossings own = ownCrossings(level, batch, i);
    // Along each axis the nearer one, signed.
    FloatVec crossing[3], length[3];
    for (int axis = 0; axis < 3; ++axis) {
      const auto low = own.along[axis][0], high = own.along[axis][1];
      length[axis] = hn::Min(low, high);
      crossing[axis] = hn::IfThenElse(hn::Lt(high, low), high, hn::Neg(low));
    }
    const auto nearest = hn::Min(length[0], hn::Min(length[1], length[2]));
    const auto isX = hn::Eq(length[0], nearest);
    const auto isY = hn::AndNot(isX, hn::Eq(length[1], nearest));
    storeBatch({hn::IfThenElseZero(isX, crossing[0]), hn::IfThenElseZero(isY, crossing[1]),
                hn::IfThenElse(hn::Or(isX, isY), zero, crossing[2])},
               batch.offset, i);
    // Foot on the plane through them: n / |n|^2 with n = 1 / crossing, here times the nearest.
    const Vec3 normal = {hn::Div(nearest, crossing[0]), hn::Div(nearest, crossing[1]), hn::Div(nearest, crossing[2])};
    const Vec3 foot = scaled(normal, hn::Div(nearest, dot(normal, normal)));
    const auto atSample = hn::Eq(nearest, zero);
    storeBatch({hn::IfThenZeroElse(atSample, foot.x), hn::IfThenZeroElse(atSample, foot.y),
                hn::IfThenZeroElse(atSample, foot.z)},
               batch.trial, i);
  }
}

void sheetsBatch(const PointFrame& frame, PointBatch& batch) {
  const FloatTag d;
  const IntTag di;
  const VectorLevel level(frame, batch);
  const hn::Rebind<std::uint8_t, FloatTag> bytes;
  const auto slope = hn::Set(d, static_cast<float>(kSameSheet * kSameSheet));
  for (std::size_t i = 0; i < batch.padded(); i += hn::Lanes(d)) {
    const OwnCrossings own = ownCrossings(level, batch, i);
    const Vec3 o = loadBatch(batch.offset, i);
    const FloatVec component[3] = {o.x, o.y, o.z};
    const auto length = dot(o, o);
    auto other = hn::Lt(length, length);
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        // The crossing c = (s, 0, 0) and the plane through o across o: ((c - o) . o)^2 > slope^2 |o|^2 |c - o|^2.
        const auto along = own.along[axis][side];
        const auto s = side == 0 ? hn::Neg(along) : along;
        const auto product = hn::Mul(s, component[axis]);
        const auto out = hn::Sub(product, length);
        const auto apart = hn::Add(hn::Sub(hn::Mul(s, s), hn::Add(product, product)), length);
        const auto leaves = hn::Gt(hn::Mul(out, out), hn::Mul(hn::Mul(slope, length), apart));
        other = hn::Or(other, hn::And(leaves, hn::Lt(along, hn::Set(d, kUnsetOffset))));
      }
    auto* states = reinterpret_cast<std::uint8_t*>(batch.state.data()) + i;
    const auto state = hn::PromoteTo(di, hn::LoadU(bytes, states));
    const auto stuck = hn::Set(di, static_cast<std::int32_t>(PointState::stuck));
    hn::StoreU(hn::DemoteTo(bytes, hn::IfThenElse(hn::RebindMask(di, other), hn::Max(stuck, state), state)), bytes,
               states);
  }
}

// Searches that have not begun: the first point that counts may be as far off as the surface is thick.
HWY_INLINE Search begin(const PointBatch& batch, std::size_t i) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  const auto none = hn::Lt(zero, zero);
  const Vec3 best = loadBatch(batch.offset, i);
  const auto reached = hn::Add(hn::Sqrt(dot(best, best)), hn::Set(d, static_cast<float>(2 * kOnSurface)));
  return {best,
          loadBatch(batch.trial, i),
          {zero, zero, zero},
          hn::Mul(reached, reached),
          hn::Set(d, kNothingPromised),
          hn::Set(d, 1.0F),
          zero,
          none,
          none,
          none};
}

HWY_INLINE Search resume(const PointBatch& batch, std::size_t i) {
  const FloatTag d;
  const auto none = hn::Lt(hn::Zero(d), hn::Zero(d));
  return {loadBatch(batch.offset, i),
          loadBatch(batch.trial, i),
          loadBatch(batch.retreat, i),
          hn::LoadU(d, batch.nearest.data() + i),
          hn::LoadU(d, batch.promised.data() + i),
          hn::LoadU(d, batch.share.data() + i),
          hn::LoadU(d, batch.tries.data() + i),
          none,
          none,
          none};
}

void searchBatch(const PointFrame& frame, bool first, int looks, PointBatch& batch) {
  const FloatTag d;
  const IntTag di;
  const hn::Rebind<std::uint8_t, FloatTag> bytes;
  const VectorLevel level(frame, batch);
  const auto stateOf = [&](PointState state) { return hn::Set(di, static_cast<std::int32_t>(state)); };
  for (std::size_t i = 0; i < batch.padded(); i += hn::Lanes(d)) {
    const VectorSamples samples(level, batch, i);
    Search search = first ? begin(batch, i) : resume(batch, i);
    bool ended = false;
    for (int look = 0; look < looks && !ended; ++look) {
      lookOnce(level, samples, search);
      ended = hn::AllTrue(d, hn::Or(search.settled, hn::Or(search.stuck, search.failed)));
    }
    storeBatch(search.best, batch.offset, i);
    auto state = hn::IfThenElseZero(hn::RebindMask(di, search.settled), stateOf(PointState::settled));
    state = hn::IfThenElse(hn::RebindMask(di, search.stuck), stateOf(PointState::stuck), state);
    state = hn::IfThenElse(hn::RebindMask(di, search.failed), stateOf(PointState::failed), state);
    hn::StoreU(hn::DemoteTo(bytes, state), bytes, reinterpret_cast<std::uint8_t*>(batch.state.data()) + i);
    if (ended) continue;
    storeBatch(search.trial, batch.trial, i);
    storeBatch(search.retreat, batch.retreat, i);
    hn::StoreU(search.nearest, d, batch.nearest.data() + i);
    hn::StoreU(search.promised, d, batch.promised.data() + i);
    hn::StoreU(search.share, d, batch.share.data() + i);
    hn::StoreU(search.tries, d, batch.tries.data() + i);
  }
}

// The samples of `from` that are still searching, in order, to the start of `to` and of `toOrigin`, which have room for
// all and a vector more; sample i was fromOrigin[i], or i. Returns how many.
std::size_t takeSearching(const PointBatch& from, const std::int32_t* fromOrigin, PointBatch& to,
                          std::int32_t* toOrigin) {
  const FloatTag d;
  const IntTag di;
  const hn::Rebind<std::uint8_t, FloatTag> bytes;
  const auto searching = hn::Set(di, static_cast<std::int32_t>(PointState::searching));
  std::size_t count = 0;
  for (std::size_t i = 0; i < from.count; i += hn::Lanes(d)) {
    const auto* states = reinterpret_cast<const std::uint8_t*>(from.state.data()) + i;
    const auto isOne = hn::FirstN(di, std::min(from.count - i, hn::Lanes(d)));
    const auto taken = hn::And(isOne, hn::Eq(hn::PromoteTo(di, hn::LoadU(bytes, states)), searching));
    if (hn::AllFalse(di, taken)) continue;
    const auto takenFloats = hn::RebindMask(d, taken);
    const auto put = [&](const PointBatch::Floats& values, PointBatch::Floats& out) {
      hn::StoreU(hn::Compress(hn::LoadU(d, values.data() + i), takenFloats), d, out.data() + count);
    };
    const auto putPlace = [&](const std::vector<std::int32_t>& values, std::vector<std::int32_t>& out) {
      hn::StoreU(hn::Compress(hn::LoadU(di, values.data() + i), taken), di, out.data() + count);
    };
    putPlace(from.x, to.x);
    putPlace(from.y, to.y);
    putPlace(from.z, to.z);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      put(from.offset[axis], to.offset[axis]);
      put(from.trial[axis], to.trial[axis]);
      put(from.retreat[axis], to.retreat[axis]);
    }
    put(from.nearest, to.nearest);
    put(from.promised, to.promised);
    put(from.share, to.share);
    put(from.tries, to.tries);
    const auto origin =
        fromOrigin == nullptr ? hn::Iota(di, static_cast<std::int32_t>(i)) : hn::LoadU(di, fromOrigin + i);
    hn::StoreU(hn::Compress(origin, taken), di, toOrigin + count);
    count += hn::CountTrue(di, taken);
  }
  return count;
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

namespace {

// Looks between which the searches that go on are put side by side again, so that they hold up no others: most need
// two.
constexpr int kLooks[] = {2, 1, 1, 2, 4, 6, 16};

}  // namespace

HWY_EXPORT(crossingStarts);
HWY_EXPORT(searchBatch);
HWY_EXPORT(sheetsBatch);
HWY_EXPORT(takeSearching);

PointFrame::PointFrame(GridView<const float> view) : level(view.data), size(view.size) {
  const LevelInterpolant interpolant(view, smallestSpacing(view.spacing));
  step = glm::vec3(interpolant.step);
  inverse = glm::vec3(interpolant.inverse);
}

bool PointFrame::fits() const {
  constexpr std::int64_t kPlanes = 2 * kPointReach + kBatchPlanes + 1;
  return static_cast<std::int64_t>(size.x) * size.y * kPlanes <= std::numeric_limits<std::int32_t>::max();
}

void startAtCrossings(const PointFrame& frame, PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(crossingStarts)(frame, batch);
}

void doubtOtherSheets(const PointFrame& frame, PointBatch& batch) { HWY_DYNAMIC_DISPATCH(sheetsBatch)(frame, batch); }

void searchPoints(const PointFrame& frame, PointBatch& batch) {
  // The samples of `batch` that are still searching, and what they were there.
  static thread_local std::vector<std::int32_t> origin, nextOrigin;
  static thread_local PointBatch part, next;
  PointBatch* now = &batch;
  part.firstPlane = next.firstPlane = batch.firstPlane;
  const auto giveBack = [&](std::size_t i, PointState state) {
    const auto at = static_cast<std::size_t>(origin[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) batch.offset[axis][at] = now->offset[axis][i];
    batch.state[at] = state;
  };
  for (std::size_t phase = 0; phase < std::size(kLooks); ++phase) {
    now->pad();
    HWY_DYNAMIC_DISPATCH(searchBatch)(frame, phase == 0, kLooks[phase], *now);
    if (phase != 0)
      for (std::size_t i = 0; i < now->count; ++i)
        if (now->state[i] != PointState::searching) giveBack(i, now->state[i]);
    next.makeRoom(now->count);
    nextOrigin.resize(now->count + kBatchGroup);
    next.count =
        HWY_DYNAMIC_DISPATCH(takeSearching)(*now, phase == 0 ? nullptr : origin.data(), next, nextOrigin.data());
    if (next.count == 0) return;
    std::swap(part, next);
    std::swap(origin, nextOrigin);
    now = &part;
  }
  for (std::size_t i = 0; i < now->count; ++i) giveBack(i, PointState::stuck);
}

}  // namespace isolume
#endif
