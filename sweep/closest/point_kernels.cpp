#include "point_kernels.h"

#include "closest_point.h"
#include "offset_field.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/closest/point_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "point_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

void crossingStarts(const PointFrame& frame, int z, PointBatch& batch) {
  const FloatTag d;
  const IntTag di;
  const auto zero = hn::Zero(d);
  const auto lanes = hn::Lanes(d);
  const std::ptrdiff_t strideZ = static_cast<std::ptrdiff_t>(frame.size.x) * frame.size.y;
  const float* plane = frame.level + z * strideZ;
  // Missing neighbours are the sample itself, which it never crosses.
  const float* planes[2] = {z > 0 ? plane - strideZ : plane, z + 1 < frame.size.z ? plane + strideZ : plane};
  const auto lastX = hn::Set(di, frame.size.x - 1), lastY = hn::Set(di, frame.size.y - 1);
  const auto strideY = hn::Set(di, frame.size.x), one = hn::Set(di, 1), none = hn::Zero(di);
  for (std::size_t i = 0; i < batch.x.size(); i += lanes) {
    const auto x = hn::LoadU(di, batch.x.data() + i), y = hn::LoadU(di, batch.y.data() + i);
    const auto row = hn::Mul(y, strideY);
    const auto at = hn::Add(row, x);
    const auto here = hn::GatherIndex(d, plane, at);
    const auto inside = hn::Gt(here, zero);
    const FloatVec there[3][2] = {
        {hn::GatherIndex(d, plane, hn::Add(row, hn::Max(hn::Sub(x, one), none))),
         hn::GatherIndex(d, plane, hn::Add(row, hn::Min(hn::Add(x, one), lastX)))},
        {hn::GatherIndex(d, plane, hn::Add(hn::Mul(hn::Max(hn::Sub(y, one), none), strideY), x)),
         hn::GatherIndex(d, plane, hn::Add(hn::Mul(hn::Min(hn::Add(y, one), lastY), strideY), x))},
        {hn::GatherIndex(d, planes[0], at), hn::GatherIndex(d, planes[1], at)}};
    // Along each axis the nearer crossing, signed, or a length that no crossing has.
    FloatVec crossing[3];
    auto nearest = hn::Set(d, kUnsetOffset);
    for (int axis = 0; axis < 3; ++axis) {
      crossing[axis] = hn::Set(d, kUnsetOffset);
      for (int side = 0; side < 2; ++side) {
        const FloatVec other = there[axis][side];
        const auto crossed = hn::Xor(hn::VecFromMask(d, inside), hn::VecFromMask(d, hn::Gt(other, zero)));
        const auto along = hn::Mul(hn::Div(here, hn::Sub(here, other)), hn::Set(d, frame.step[axis]));
        const auto nearer = hn::And(hn::MaskFromVec(crossed), hn::Lt(along, hn::Abs(crossing[axis])));
        crossing[axis] = hn::IfThenElse(nearer, side == 0 ? hn::Neg(along) : along, crossing[axis]);
      }
      nearest = hn::Min(nearest, hn::Abs(crossing[axis]));
    }
    // Foot on the plane through the crossings: n / |n|^2 with n = 1 / crossing, scaled by the nearest one.
    Vec3 normal, offset;
    const auto taken0 = hn::Eq(hn::Abs(crossing[0]), nearest);
    const auto taken1 = hn::AndNot(taken0, hn::Eq(hn::Abs(crossing[1]), nearest));
    offset.x = hn::IfThenElseZero(taken0, crossing[0]);
    offset.y = hn::IfThenElseZero(taken1, crossing[1]);
    offset.z = hn::IfThenElse(hn::Or(taken0, taken1), zero, crossing[2]);
    normal.x = hn::Div(nearest, crossing[0]);
    normal.y = hn::Div(nearest, crossing[1]);
    normal.z = hn::Div(nearest, crossing[2]);
    const Vec3 foot = scaled(normal, hn::Div(nearest, dot(normal, normal)));
    const auto atSample = hn::Eq(nearest, zero);
    storeBatch(offset, batch.offset, i);
    storeBatch({hn::IfThenElse(atSample, zero, foot.x), hn::IfThenElse(atSample, zero, foot.y),
                hn::IfThenElse(atSample, zero, foot.z)},
               batch.trial, i);
  }
}

void refineBatch(const PointFrame& frame, int z, int steps, PointBatch& batch) {
  const FloatTag d;
  const IntTag di;
  const auto lanes = hn::Lanes(d);
  const VectorLevel level(frame, z);
  const hn::Rebind<std::uint8_t, FloatTag> bytes;
  for (std::size_t i = 0; i < batch.x.size(); i += lanes) {
    Vec3 best = loadBatch(batch.offset, i);
    const auto settled = closestPoints(level, hn::LoadU(di, batch.x.data() + i), hn::LoadU(di, batch.y.data() + i),
                                       loadBatch(batch.trial, i), steps, best);
    storeBatch(best, batch.offset, i);
    const auto flag = hn::IfThenElseZero(hn::RebindMask(di, settled), hn::Set(di, 1));
    hn::StoreU(hn::DemoteTo(bytes, flag), bytes, batch.settled.data() + i);
  }
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

namespace {

constexpr int kFirstSteps = 4;  // evaluations; most samples need two or three
constexpr int kMoreSteps = 16;

}  // namespace

HWY_EXPORT(crossingStarts);
HWY_EXPORT(refineBatch);

PointFrame::PointFrame(GridView<const float> view) : level(view.data), size(view.size) {
  const LevelInterpolant interpolant(view, smallestSpacing(view.spacing));
  step = glm::vec3(interpolant.step);
  inverse = glm::vec3(interpolant.inverse);
}

bool PointFrame::fits() const {
  constexpr std::int64_t kPlanes = 2 * kPointReach + 2;
  return static_cast<std::int64_t>(size.x) * size.y * kPlanes <= std::numeric_limits<std::int32_t>::max();
}

void startAtCrossings(const PointFrame& frame, int z, PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(crossingStarts)(frame, z, batch);
}
void refinePoints(const PointFrame& frame, int z, PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(refineBatch)(frame, z, kFirstSteps, batch);
  // Few lanes need more steps: side by side, so that they hold up no others.
  static thread_local std::vector<std::size_t> slow;
  static thread_local PointBatch rest;
  slow.clear();
  for (std::size_t i = 0; i < batch.count; ++i)
    if (batch.settled[i] == 0) slow.push_back(i);
  if (slow.empty()) return;
  rest.resize(slow.size());
  for (std::size_t i = 0; i < slow.size(); ++i) {
    rest.x[i] = batch.x[slow[i]];
    rest.y[i] = batch.y[slow[i]];
    rest.set(i, batch.point(slow[i]), batch.point(slow[i]));
  }
  rest.pad();
  HWY_DYNAMIC_DISPATCH(refineBatch)(frame, z, kMoreSteps, rest);
  for (std::size_t i = 0; i < slow.size(); ++i) {
    batch.settled[slow[i]] = rest.settled[i];
    for (int axis = 0; axis < 3; ++axis) batch.offset[axis][slow[i]] = rest.offset[axis][i];
  }
}

}  // namespace isolume
#endif
