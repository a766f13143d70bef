#include "better_start.h"

#include <algorithm>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/godunov/better_start.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "surface_start.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using FloatVec = hn::Vec<FloatTag>;
using FloatMask = hn::Mask<FloatTag>;

// Vec3 and dot() are other functions in other files of this namespace.
namespace {

constexpr int kMaxLanes = static_cast<int>(hn::MaxLanes(FloatTag()));
constexpr int kNewtonSteps = 2;  // the first from the sample itself; a third gains nothing (.0017 voxels either way)
// How far a foot may lie outside its cell, in spacings: there f is only the extension of the cell's polynomial.
constexpr float kReach = 0.5F;

HWY_INLINE FloatVec set(float value) { return hn::Set(FloatTag(), value); }

struct Vec3 {
  FloatVec x, y, z;
};

// Sum and product that do not depend on the order of the three.
HWY_INLINE Vec3 sorted(FloatVec x, FloatVec y, FloatVec z) {
  const auto low = hn::Min(x, y);
  const auto high = hn::Max(x, y);
  const auto middle = hn::Max(low, z);
  return {hn::Min(low, z), hn::Min(high, middle), hn::Max(high, middle)};
}
HWY_INLINE FloatVec sum(FloatVec x, FloatVec y, FloatVec z) {
  const Vec3 v = sorted(x, y, z);
  return hn::Add(hn::Add(v.x, v.y), v.z);
}
HWY_INLINE FloatVec product(const Vec3& t) {
  const Vec3 v = sorted(t.x, t.y, t.z);
  return hn::Mul(hn::Mul(v.x, v.y), v.z);
}
HWY_INLINE FloatVec dot(const Vec3& a, const Vec3& b) {
  return sum(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z));
}

// A vector of samples: levels in the order of the axes, and where the cell towards the surface lies.
struct Batch {
  alignas(64) float here[kMaxLanes];
  alignas(64) float before[3][kMaxLanes];
  alignas(64) float after[3][kMaxLanes];
  alignas(64) float side[3][kMaxLanes];  // -1, 0, 1
  alignas(64) float corner[8][kMaxLanes];
};

// The cell's polynomial f = c + c_x x + ... + c_xyz x y z, corner i at the far end of axis k if bit k of i is set.
struct Cell {
  FloatVec constant, xyz;
  Vec3 linear, mixed;  // mixed: yz, xz, xy
};
HWY_INLINE Cell cellOf(const FloatVec* c) {
  Cell cell;
  cell.constant = c[0];
  cell.linear = {hn::Sub(c[1], c[0]), hn::Sub(c[2], c[0]), hn::Sub(c[4], c[0])};
  cell.mixed = {hn::Sub(hn::Add(c[6], c[0]), hn::Add(c[2], c[4])), hn::Sub(hn::Add(c[5], c[0]), hn::Add(c[1], c[4])),
                hn::Sub(hn::Add(c[3], c[0]), hn::Add(c[1], c[2]))};
  cell.xyz = hn::Sub(hn::Sub(c[7], c[0]), hn::Sub(sum(c[3], c[5], c[6]), sum(c[1], c[2], c[4])));
  return cell;
}
HWY_INLINE FloatVec valueAt(const Cell& cell, const Vec3& t) {
  const Vec3 pairs{hn::Mul(t.y, t.z), hn::Mul(t.x, t.z), hn::Mul(t.x, t.y)};
  const auto higher = hn::Add(dot(cell.mixed, pairs), hn::Mul(cell.xyz, product(t)));
  return hn::Add(cell.constant, hn::Add(dot(cell.linear, t), higher));
}
HWY_INLINE FloatVec slope(FloatVec linear, FloatVec mixedA, FloatVec a, FloatVec mixedB, FloatVec b, FloatVec xyz) {
  const auto mixed = hn::Add(hn::Mul(mixedA, b), hn::Mul(mixedB, a));
  return hn::Add(linear, hn::Add(mixed, hn::Mul(xyz, hn::Mul(a, b))));
}
HWY_INLINE Vec3 gradientAt(const Cell& cell, const Vec3& t, const Vec3& spacing) {
  const Vec3& m = cell.mixed;
  return {hn::Div(slope(cell.linear.x, m.y, t.y, m.z, t.z, cell.xyz), spacing.x),
          hn::Div(slope(cell.linear.y, m.x, t.x, m.z, t.z, cell.xyz), spacing.y),
          hn::Div(slope(cell.linear.z, m.x, t.x, m.y, t.y, cell.xyz), spacing.z)};
}

// What is known from the six neighbours.
struct AxisStart {
  FloatVec three;    // 1 / sqrt(sum 1 / d_i^2)
  FloatMask usable;  // no axis is crossed equally far on both sides
};

// Decides on the cell of each sample. `here` and all other levels are relative: f >= 0 at the sample.
AxisStart viewAxes(Batch& batch, FloatMask solid, glm::vec3 spacing) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  const auto here = hn::Load(d, batch.here);
  FloatVec inverse[3];
  auto tie = hn::FirstN(d, 0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto before = hn::Load(d, batch.before[axis]);
    const auto after = hn::Load(d, batch.after[axis]);
    // The lower neighbour has the nearer crossing or, where there is none, is the way down. Level 0 is outside.
    const auto there = hn::Min(before, after);
    const auto crossed = hn::Or(hn::And(solid, hn::Le(there, zero)), hn::AndNot(solid, hn::Lt(there, zero)));
    const auto fall = hn::Sub(here, there);
    const auto distance = hn::Mul(set(spacing[axis]), hn::Div(here, fall));
    const auto perDistance = hn::Div(set(1.0F), hn::IfThenElse(crossed, distance, set(kUnsetDistance)));
    inverse[axis] = hn::Mul(perDistance, perDistance);
    const auto equal = hn::Eq(before, after);
    tie = hn::Or(tie, hn::And(crossed, equal));
    // Lower on both sides without a crossing: a ridge, with no slope.
    const auto ridge = hn::AndNot(crossed, hn::Lt(hn::Max(before, after), here));
    const auto flat = hn::Or(hn::Or(equal, ridge), hn::Le(fall, zero));
    const auto side = hn::IfThenElse(hn::Lt(after, before), set(1.0F), set(-1.0F));
    hn::Store(hn::IfThenZeroElse(flat, side), d, batch.side[axis]);
  }
  return {hn::Div(set(1.0F), hn::Sqrt(sum(inverse[0], inverse[1], inverse[2]))), hn::Not(tie)};
}

// The distance to the surface of the cell, and where that is to be believed.
FloatVec newtonDistance(const Batch& batch, glm::vec3 h, const AxisStart& start) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  const Vec3 spacing{set(h.x), set(h.y), set(h.z)};
  FloatVec corners[8];
  auto largest = zero;
  for (int i = 0; i < 8; ++i) {
    corners[i] = hn::Load(d, batch.corner[i]);
    largest = hn::Max(largest, hn::Abs(corners[i]));
  }
  for (FloatVec& corner : corners) corner = hn::Div(corner, largest);
  const Cell cell = cellOf(corners);

  Vec3 t{zero, zero, zero};
  auto believed = start.usable;
  auto distance = zero;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const Vec3 gradient = gradientAt(cell, t, spacing);
    const auto steepness = dot(gradient, gradient);
    const Vec3 p{hn::Mul(t.x, spacing.x), hn::Mul(t.y, spacing.y), hn::Mul(t.z, spacing.z)};
    // The tangent plane is { q : gradient . q = plane }, seen from the sample.
    const auto plane = hn::Sub(dot(gradient, p), valueAt(cell, t));
    const auto along = hn::Div(plane, steepness);
    distance = hn::Div(hn::Abs(plane), hn::Sqrt(steepness));
    const Vec3 foot{hn::Div(hn::Mul(gradient.x, along), spacing.x), hn::Div(hn::Mul(gradient.y, along), spacing.y),
                    hn::Div(hn::Mul(gradient.z, along), spacing.z)};
    const auto lowest = hn::Min(hn::Min(foot.x, foot.y), foot.z);
    const auto highest = hn::Max(hn::Max(foot.x, foot.y), foot.z);
    // Neither 0 / 0 nor infinite: comparisons with NaN are false, but a minimum may drop it.
    const auto numbers = hn::And(hn::And(hn::Eq(foot.x, foot.x), hn::Eq(foot.y, foot.y)), hn::Eq(foot.z, foot.z));
    believed = hn::And(hn::And(believed, numbers), hn::Gt(steepness, zero));
    if (step + 1 == kNewtonSteps)
      believed = hn::And(believed, hn::And(hn::Ge(lowest, set(-kReach)), hn::Le(highest, set(1 + kReach))));
    t = {hn::Min(hn::Max(foot.x, zero), set(1.0F)), hn::Min(hn::Max(foot.y, zero), set(1.0F)),
         hn::Min(hn::Max(foot.z, zero), set(1.0F))};
  }
  return hn::IfThenElse(believed, distance, start.three);
}

}  // namespace

void betterStartRowOnTarget(GridView<const float> level, glm::vec3 spacing, int y, int z, float* row) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const float* levels = level.data + z * level.strideZ() + y * level.strideY();
  const std::ptrdiff_t stride[3] = {1, level.strideY(), level.strideZ()};
  Batch batch;
  alignas(64) float axisMinimum[kMaxLanes], solidFlag[kMaxLanes], better[kMaxLanes];
  int where[kMaxLanes];
  for (int x = 0; x < level.size.x;) {
    int count = 0;
    for (; x < level.size.x && count < lanes; ++x)
      if (isFixed(row[x])) where[count++] = x;
    if (count == 0) break;
    for (int lane = 0; lane < lanes; ++lane) {
      const int at = where[std::min(lane, count - 1)];
      const float* f = levels + at;
      const glm::ivec3 p(at, y, z);
      const float sign = *f > 0 ? 1.0F : -1.0F;
      solidFlag[lane] = sign;
      axisMinimum[lane] = std::abs(row[at]);
      batch.here[lane] = sign * *f;
      for (int axis = 0; axis < 3; ++axis) {
        batch.before[axis][lane] = sign * (p[axis] > 0 ? f[-stride[axis]] : *f);
        batch.after[axis][lane] = sign * (p[axis] + 1 < level.size[axis] ? f[stride[axis]] : *f);
      }
    }
    const AxisStart start = viewAxes(batch, hn::Gt(hn::Load(d, solidFlag), hn::Zero(d)), spacing);
    for (int lane = 0; lane < lanes; ++lane) {
      const float* f = levels + where[std::min(lane, count - 1)];
      std::ptrdiff_t step[3];
      for (int axis = 0; axis < 3; ++axis)
        step[axis] = static_cast<std::ptrdiff_t>(batch.side[axis][lane]) * stride[axis];
      for (int i = 0; i < 8; ++i)
        batch.corner[i][lane] =
            solidFlag[lane] *
            f[((i & 1) != 0 ? step[0] : 0) + ((i & 2) != 0 ? step[1] : 0) + ((i & 4) != 0 ? step[2] : 0)];
    }
    const auto found = hn::Min(newtonDistance(batch, spacing, start), hn::Load(d, axisMinimum));
    hn::Store(hn::Max(found, set(kSmallestDistance)), d, better);
    for (int lane = 0; lane < count; ++lane) row[where[lane]] = withFixedBit(-solidFlag[lane] * better[lane], true);
  }
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(betterStartRowOnTarget);

void betterStartRow(GridView<const float> level, glm::vec3 spacing, int y, int z, float* row) {
  HWY_DYNAMIC_DISPATCH(betterStartRowOnTarget)(level, spacing, y, z, row);
}

}  // namespace isolume
#endif
