#include "neighbour_points.h"

#include "closest_point.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/closest/neighbour_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::CappedTag<float, kBatchGroup>;
using IntTag = hn::RebindToSigned<FloatTag>;
using FloatVec = hn::Vec<FloatTag>;
using IntVec = hn::Vec<IntTag>;

struct Vec3 {
  FloatVec x, y, z;
};

HWY_INLINE FloatVec dot(const Vec3& a, const Vec3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Vec3 offsetsOf(const PointBatch& batch, std::size_t i) {
  const FloatTag d;
  return {hn::LoadU(d, batch.offset[0].data() + i), hn::LoadU(d, batch.offset[1].data() + i),
          hn::LoadU(d, batch.offset[2].data() + i)};
}

// Calls offer(candidate, exists) for neighbours along the axes: their points, as seen from the samples.
template <class Offer>
HWY_INLINE void forNeighbours(const OffsetField& field, glm::vec3 step, int z, unsigned axes, IntVec x, IntVec y,
                              const Offer& offer) {
  const FloatTag d;
  const IntTag di;
  const glm::ivec3 size = field.component[0].size();
  const std::ptrdiff_t strideZ = field.component[0].view().strideZ();
  const auto none = hn::Zero(di), one = hn::Set(di, 1), strideY = hn::Set(di, size.x);
  const auto lastX = hn::Set(di, size.x - 1), lastY = hn::Set(di, size.y - 1);
  const auto at = hn::Add(hn::Mul(y, strideY), x);
  const auto give = [&](int plane, IntVec from, glm::vec3 move, auto exists) {
    const std::ptrdiff_t first = plane * strideZ;
    offer(Vec3{hn::Add(hn::GatherIndex(d, field.component[0].data() + first, from), hn::Set(d, move.x)),
               hn::Add(hn::GatherIndex(d, field.component[1].data() + first, from), hn::Set(d, move.y)),
               hn::Add(hn::GatherIndex(d, field.component[2].data() + first, from), hn::Set(d, move.z))},
          hn::RebindMask(d, exists));
  };
  if ((axes & kAlongX) != 0) {
    give(z, hn::Sub(at, hn::Min(x, one)), {-step.x, 0, 0}, hn::Gt(x, none));
    give(z, hn::Add(at, hn::Min(hn::Sub(lastX, x), one)), {step.x, 0, 0}, hn::Lt(x, lastX));
  }
  if ((axes & kAlongY) != 0) {
    give(z, hn::Sub(at, hn::Mul(hn::Min(y, one), strideY)), {0, -step.y, 0}, hn::Gt(y, none));
    give(z, hn::Add(at, hn::Mul(hn::Min(hn::Sub(lastY, y), one), strideY)), {0, step.y, 0}, hn::Lt(y, lastY));
  }
  const auto always = hn::Eq(none, none);
  if ((axes & kAlongZ) != 0 && z > 0) give(z - 1, at, {0, 0, -step.z}, always);
  if ((axes & kAlongZ) != 0 && z + 1 < size.z) give(z + 1, at, {0, 0, step.z}, always);
}

HWY_INLINE void storeState(hn::Mask<FloatTag> chosen, PointState state, PointBatch& batch, std::size_t i) {
  const IntTag di;
  const hn::Rebind<std::uint8_t, FloatTag> bytes;
  const auto states = hn::IfThenElseZero(hn::RebindMask(di, chosen), hn::Set(di, static_cast<std::int32_t>(state)));
  hn::StoreU(hn::DemoteTo(bytes, states), bytes, reinterpret_cast<std::uint8_t*>(batch.state.data()) + i);
}

void takeBatch(const OffsetField& field, glm::vec3 step, int z, unsigned axes, float share, PointBatch& batch) {
  const FloatTag d;
  const IntTag di;
  for (std::size_t i = 0; i < batch.padded(); i += hn::Lanes(d)) {
    Vec3 best = offsetsOf(batch, i);
    auto nearest = hn::Mul(dot(best, best), hn::Set(d, share));
    auto taken = hn::Lt(nearest, nearest);
    forNeighbours(field, step, z, axes, hn::LoadU(di, batch.x.data() + i), hn::LoadU(di, batch.y.data() + i),
                  [&](const Vec3& candidate, auto exists) {
                    const auto length = dot(candidate, candidate);
                    const auto nearer = hn::And(hn::Lt(length, nearest), exists);
                    best = {hn::IfThenElse(nearer, candidate.x, best.x), hn::IfThenElse(nearer, candidate.y, best.y),
                            hn::IfThenElse(nearer, candidate.z, best.z)};
                    nearest = hn::IfThenElse(nearer, length, nearest);
                    taken = hn::Or(taken, nearer);
                  });
    for (auto* to : {&batch.offset, &batch.trial}) {
      hn::StoreU(best.x, d, (*to)[0].data() + i);
      hn::StoreU(best.y, d, (*to)[1].data() + i);
      hn::StoreU(best.z, d, (*to)[2].data() + i);
    }
    storeState(taken, PointState::settled, batch, i);
  }
}

void doubtBatch(const OffsetField& field, glm::vec3 step, int z, PointBatch& batch) {
  const FloatTag d;
  const IntTag di;
  const auto slope = hn::Set(d, static_cast<float>(kSameSheet * kSameSheet));
  const auto unset = hn::Set(d, kUnsetOffset / 2);
  for (std::size_t i = 0; i < batch.padded(); i += hn::Lanes(d)) {
    const Vec3 o = offsetsOf(batch, i);
    const auto length = dot(o, o);
    auto other = hn::Lt(length, length);
    forNeighbours(field, step, z, kAlongX | kAlongY | kAlongZ, hn::LoadU(di, batch.x.data() + i),
                  hn::LoadU(di, batch.y.data() + i), [&](const Vec3& c, auto exists) {
                    const Vec3 apart = {hn::Sub(c.x, o.x), hn::Sub(c.y, o.y), hn::Sub(c.z, o.z)};
                    const auto out = dot(apart, o);
                    const auto leaves = hn::Gt(hn::Mul(out, out), hn::Mul(hn::Mul(slope, length), dot(apart, apart)));
                    other = hn::Or(other, hn::And(hn::And(leaves, exists), hn::Lt(c.x, unset)));
                  });
    storeState(other, PointState::stuck, batch, i);
  }
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(takeBatch);
HWY_EXPORT(doubtBatch);

void takeFromNeighbours(const OffsetField& field, glm::vec3 step, int z, unsigned axes, float share,
                        PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(takeBatch)(field, step, z, axes, share, batch);
}

void doubtNeighbours(const OffsetField& field, glm::vec3 step, int z, PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(doubtBatch)(field, step, z, batch);
}

}  // namespace isolume
#endif
