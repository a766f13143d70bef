#include "neighbour_points.h"

#include <array>

#include "closest_point.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/closest/neighbour_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "point_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

HWY_INLINE Vec3 ownPoints(const OffsetField& field, int z, IntVec x, IntVec y) {
  const FloatTag d;
  const IntTag di;
  const GridView<const float> view = field.component[0].view();
  const std::ptrdiff_t first = z * view.strideZ();
  const auto at = hn::Add(hn::Mul(y, hn::Set(di, view.size.x)), x);
  const auto own = hn::GatherIndex(d, field.component[0].data() + first, at);
  // The other components of an unset sample may hold anything.
  const auto unset = hn::Eq(own, hn::Set(d, kUnsetOffset));
  return {own, hn::IfThenZeroElse(unset, hn::GatherIndex(d, field.component[1].data() + first, at)),
          hn::IfThenZeroElse(unset, hn::GatherIndex(d, field.component[2].data() + first, at))};
}

HWY_INLINE void storePoints(const Vec3& points, PointBatch& batch, std::size_t i) {
  storeBatch(points, batch.offset, i);
  storeBatch(points, batch.trial, i);
}

// Calls offer(candidate, exists) for the neighbours at those steps: their points, as seen from the samples.
template <class Offer>
HWY_INLINE void forNeighbours(const OffsetField& field, glm::vec3 unit, int z, NeighbourSteps steps, IntVec x, IntVec y,
                              const Offer& offer) {
  const FloatTag d;
  const IntTag di;
  const glm::ivec3 size = field.component[0].size();
  const std::ptrdiff_t strideZ = field.component[0].view().strideZ();
  const auto within = [&](IntVec at, int last) {
    return hn::And(hn::Gt(at, hn::Set(di, -1)), hn::Lt(at, hn::Set(di, last + 1)));
  };
  const auto clamped = [&](IntVec at, int last) { return hn::Min(hn::Max(at, hn::Zero(di)), hn::Set(di, last)); };
  for (const glm::ivec3 step : steps) {
    if (z + step.z < 0 || z + step.z >= size.z) continue;
    const auto nx = hn::Add(x, hn::Set(di, step.x)), ny = hn::Add(y, hn::Set(di, step.y));
    const auto from = hn::Add(hn::Mul(clamped(ny, size.y - 1), hn::Set(di, size.x)), clamped(nx, size.x - 1));
    const std::ptrdiff_t first = (z + step.z) * strideZ;
    const glm::vec3 move = glm::vec3(step) * unit;
    offer(Vec3{hn::Add(hn::GatherIndex(d, field.component[0].data() + first, from), hn::Set(d, move.x)),
               hn::Add(hn::GatherIndex(d, field.component[1].data() + first, from), hn::Set(d, move.y)),
               hn::Add(hn::GatherIndex(d, field.component[2].data() + first, from), hn::Set(d, move.z))},
          hn::RebindMask(d, hn::And(within(nx, size.x - 1), within(ny, size.y - 1))));
  }
}

HWY_INLINE void storeState(hn::Mask<FloatTag> chosen, PointState state, PointBatch& batch, std::size_t i) {
  const IntTag di;
  const hn::Rebind<std::uint8_t, FloatTag> bytes;
  const auto states = hn::IfThenElseZero(hn::RebindMask(di, chosen), hn::Set(di, static_cast<std::int32_t>(state)));
  hn::StoreU(hn::DemoteTo(bytes, states), bytes, reinterpret_cast<std::uint8_t*>(batch.state.data()) + i);
}

void takeBatch(const OffsetField& field, glm::vec3 unit, int z, NeighbourSteps steps, float share, PointBatch& batch) {
  const FloatTag d;
  const IntTag di;
  for (std::size_t i = 0; i < batch.padded(); i += hn::Lanes(d)) {
    const auto x = hn::LoadU(di, batch.x.data() + i), y = hn::LoadU(di, batch.y.data() + i);
    Vec3 best = ownPoints(field, z, x, y);
    auto nearest = hn::Mul(dot(best, best), hn::Set(d, share));
    auto taken = hn::Lt(nearest, nearest);
    forNeighbours(field, unit, z, steps, x, y, [&](const Vec3& candidate, auto exists) {
      const auto length = dot(candidate, candidate);
      const auto nearer = hn::And(hn::Lt(length, nearest), exists);
      best = {hn::IfThenElse(nearer, candidate.x, best.x), hn::IfThenElse(nearer, candidate.y, best.y),
              hn::IfThenElse(nearer, candidate.z, best.z)};
      nearest = hn::IfThenElse(nearer, length, nearest);
      taken = hn::Or(taken, nearer);
    });
    storePoints(best, batch, i);
    storeState(taken, PointState::settled, batch, i);
  }
}

void doubtBatch(const OffsetField& field, glm::vec3 unit, int z, PointBatch& batch) {
  const FloatTag d;
  const IntTag di;
  const auto slope = hn::Set(d, static_cast<float>(kSameSheet * kSameSheet));
  const auto unset = hn::Set(d, kUnsetOffset / 2);
  for (std::size_t i = 0; i < batch.padded(); i += hn::Lanes(d)) {
    const auto x = hn::LoadU(di, batch.x.data() + i), y = hn::LoadU(di, batch.y.data() + i);
    const Vec3 o = ownPoints(field, z, x, y);
    storePoints(o, batch, i);
    const auto length = dot(o, o);
    auto other = hn::Lt(length, length);
    forNeighbours(field, unit, z, faceSteps(), x, y, [&](const Vec3& c, auto exists) {
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

namespace {

struct Steps {
  std::array<glm::ivec3, 26> all{};
  std::array<std::size_t, 4> end{};  // of those along 1, 2 and 3 axes
};

constexpr Steps makeSteps() {
  Steps steps;
  std::size_t count = 0;
  for (int axes = 1; axes <= 3; ++axes) {
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
          if (x * x + y * y + z * z == axes) steps.all[count++] = glm::ivec3(x, y, z);
    steps.end[static_cast<std::size_t>(axes)] = count;
  }
  return steps;
}
constexpr Steps kSteps = makeSteps();

NeighbourSteps stepsAlong(std::size_t axes) {
  return {kSteps.all.data() + kSteps.end[axes - 1], kSteps.end[axes] - kSteps.end[axes - 1]};
}

}  // namespace

NeighbourSteps faceSteps() { return stepsAlong(1); }
NeighbourSteps edgeSteps() { return stepsAlong(2); }
NeighbourSteps cornerSteps() { return stepsAlong(3); }

void takeFromNeighbours(const OffsetField& field, glm::vec3 unit, int z, NeighbourSteps steps, float share,
                        PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(takeBatch)(field, unit, z, steps, share, batch);
}
void doubtNeighbours(const OffsetField& field, glm::vec3 unit, int z, PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(doubtBatch)(field, unit, z, batch);
}

}  // namespace isolume
#endif
