#include "neighbour_points.h"

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

void takeBatch(const OffsetField& field, glm::vec3 step, int z, unsigned axes, float share, PointBatch& batch) {
  const FloatTag d;
  const IntTag di;
  const hn::Rebind<std::uint8_t, FloatTag> bytes;
  const glm::ivec3 size = field.component[0].size();
  const GridView<const float> view = field.component[0].view();
  const float* planes[3][3];  // of z - 1, z, z + 1; beyond the grid z itself, where the samples are not better
  for (int dz = -1; dz <= 1; ++dz)
    for (std::size_t axis = 0; axis < 3; ++axis)
      planes[dz + 1][axis] = field.component[axis].data() + std::min(std::max(z + dz, 0), size.z - 1) * view.strideZ();
  const auto none = hn::Zero(di), one = hn::Set(di, 1), strideY = hn::Set(di, size.x);
  const auto lastX = hn::Set(di, size.x - 1), lastY = hn::Set(di, size.y - 1);
  for (std::size_t i = 0; i < batch.padded(); i += hn::Lanes(d)) {
    const auto x = hn::LoadU(di, batch.x.data() + i), y = hn::LoadU(di, batch.y.data() + i);
    const auto row = hn::Mul(y, strideY);
    auto bestX = hn::LoadU(d, batch.offset[0].data() + i);
    auto bestY = hn::LoadU(d, batch.offset[1].data() + i);
    auto bestZ = hn::LoadU(d, batch.offset[2].data() + i);
    const auto squared = [](FloatVec a, FloatVec b, FloatVec c) {
      return hn::Add(hn::Add(hn::Mul(a, a), hn::Mul(b, b)), hn::Mul(c, c));
    };
    auto nearest = hn::Mul(squared(bestX, bestY, bestZ), hn::Set(d, share));
    auto taken = hn::Lt(nearest, nearest);
    const auto offer = [&](const float* const* from, IntVec at, glm::vec3 move, auto exists) {
      const auto cx = hn::Add(hn::GatherIndex(d, from[0], at), hn::Set(d, move.x));
      const auto cy = hn::Add(hn::GatherIndex(d, from[1], at), hn::Set(d, move.y));
      const auto cz = hn::Add(hn::GatherIndex(d, from[2], at), hn::Set(d, move.z));
      const auto length = squared(cx, cy, cz);
      const auto nearer = hn::And(hn::Lt(length, nearest), hn::RebindMask(d, exists));
      bestX = hn::IfThenElse(nearer, cx, bestX);
      bestY = hn::IfThenElse(nearer, cy, bestY);
      bestZ = hn::IfThenElse(nearer, cz, bestZ);
      nearest = hn::IfThenElse(nearer, length, nearest);
      taken = hn::Or(taken, nearer);
    };
    const auto at = hn::Add(row, x);
    if ((axes & kAlongX) != 0) {
      offer(planes[1], hn::Sub(at, hn::Min(x, one)), {-step.x, 0, 0}, hn::Gt(x, none));
      offer(planes[1], hn::Add(at, hn::Min(hn::Sub(lastX, x), one)), {step.x, 0, 0}, hn::Lt(x, lastX));
    }
    if ((axes & kAlongY) != 0) {
      offer(planes[1], hn::Sub(at, hn::Mul(hn::Min(y, one), strideY)), {0, -step.y, 0}, hn::Gt(y, none));
      offer(planes[1], hn::Add(at, hn::Mul(hn::Min(hn::Sub(lastY, y), one), strideY)), {0, step.y, 0},
            hn::Lt(y, lastY));
    }
    const auto always = hn::Eq(none, none);
    if ((axes & kAlongZ) != 0 && z > 0) offer(planes[0], at, {0, 0, -step.z}, always);
    if ((axes & kAlongZ) != 0 && z + 1 < size.z) offer(planes[2], at, {0, 0, step.z}, always);
    const FloatVec best[3] = {bestX, bestY, bestZ};
    for (int axis = 0; axis < 3; ++axis) {
      hn::StoreU(best[axis], d, batch.offset[axis].data() + i);
      hn::StoreU(best[axis], d, batch.trial[axis].data() + i);
    }
    const auto state =
        hn::IfThenElseZero(hn::RebindMask(di, taken), hn::Set(di, static_cast<std::int32_t>(PointState::settled)));
    hn::StoreU(hn::DemoteTo(bytes, state), bytes, reinterpret_cast<std::uint8_t*>(batch.state.data()) + i);
  }
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(takeBatch);

void takeFromNeighbours(const OffsetField& field, glm::vec3 step, int z, unsigned axes, float share,
                        PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(takeBatch)(field, step, z, axes, share, batch);
}

}  // namespace isolume
#endif
