#include "surface_start.h"

#include <algorithm>
#include <glm/vec3.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/godunov/surface_start.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "better_start.h"
#include "surface_row.h"
#include "sweep/parallel.h"

#ifndef ISOLUME_SURFACE_START_ROW
#define ISOLUME_SURFACE_START_ROW
namespace isolume {
// How far a row was done in vectors.
struct InnerRow {
  int end;       // the first x that is left to do
  bool crossed;  // may any value be fixed?
};
}  // namespace isolume
#endif

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using FloatVec = hn::Vec<FloatTag>;

// One step of startValueAt() for a vector of voxels: the same operations in the same order.
HWY_INLINE FloatVec nearer(FloatVec best, FloatVec here, FloatVec there, float spacing) {
  const FloatTag d;
  const auto half = hn::Set(d, 0.5F);
  const auto halfHere = hn::Mul(half, here);
  const auto along = hn::Mul(hn::Set(d, spacing), hn::Div(halfHere, hn::Sub(halfHere, hn::Mul(half, there))));
  const auto zero = hn::Zero(d);
  const auto crossed = hn::Xor(hn::VecFromMask(d, hn::Gt(here, zero)), hn::VecFromMask(d, hn::Gt(there, zero)));
  return hn::IfThenElse(hn::MaskFromVec(crossed), hn::Min(best, along), best);
}

// All voxels but the row's ends in vectors, the last of which may overlap the one before; none in a row that is
// shorter than a vector.
InnerRow startInnerRow(const RowNeighbours& rows, glm::vec3 spacing, float bound, int count, float* out) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> du;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto zero = hn::Zero(d);
  int x = 1;
  bool crossed = false;
  for (; x + 1 < count && count > lanes + 1; x += lanes) {
    x = std::min(x, count - 1 - lanes);
    const auto here = hn::LoadU(d, rows.here + x);
    const FloatVec there[6] = {hn::LoadU(d, rows.here + x - 1), hn::LoadU(d, rows.here + x + 1),
                               hn::LoadU(d, rows.yBefore + x),  hn::LoadU(d, rows.yAfter + x),
                               hn::LoadU(d, rows.zBefore + x),  hn::LoadU(d, rows.zAfter + x)};
    auto highest = here;
    auto lowest = here;
    for (const auto& value : there) {
      highest = hn::Max(highest, value);
      lowest = hn::Min(lowest, value);
    }
    const auto unset = hn::Set(d, kUnsetDistance);
    const auto outer = hn::Set(d, bound);
    const auto insideSign = hn::IfThenElse(hn::Gt(here, zero), hn::Neg(outer), outer);
    // Most vectors have no crossing at all.
    if (hn::AllTrue(d, hn::Le(highest, zero)) || hn::AllTrue(d, hn::Gt(lowest, zero))) {
      hn::StoreU(insideSign, d, out + x);
      continue;
    }
    crossed = true;
    auto best = unset;
    best = nearer(best, here, there[0], spacing.x);
    best = nearer(best, here, there[1], spacing.x);
    best = nearer(best, here, there[2], spacing.y);
    best = nearer(best, here, there[3], spacing.y);
    best = nearer(best, here, there[4], spacing.z);
    best = nearer(best, here, there[5], spacing.z);
    const auto found = hn::Lt(best, unset);
    const auto magnitude = hn::BitCast(du, hn::Min(hn::Max(best, hn::Set(d, kSmallestDistance)), outer));
    const auto tag = hn::IfThenElseZero(hn::RebindMask(du, found), hn::Set(du, kFixedBit));
    const auto tagged = hn::Or(hn::AndNot(hn::Set(du, kFixedBit), magnitude), tag);
    hn::StoreU(hn::CopySignToAbs(hn::BitCast(d, tagged), insideSign), d, out + x);
  }
  return {x, crossed};
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(startInnerRow);

bool startRow(GridView<const float> level, DistanceStart start, float unset, int y, int z, float* row) {
  const glm::ivec3 size = level.size;
  const glm::vec3 spacing(level.spacing / smallestSpacing(level.spacing));
  const std::ptrdiff_t strideY = level.strideY();
  const std::ptrdiff_t strideZ = level.strideZ();
  const float* here = level.data + z * strideZ + y * strideY;
  const bool onBorder = y == 0 || z == 0 || y + 1 == size.y || z + 1 == size.z;
  const RowNeighbours rows{here, y > 0 ? here - strideY : here, y + 1 < size.y ? here + strideY : here,
                           z > 0 ? here - strideZ : here, z + 1 < size.z ? here + strideZ : here};
  bool crossed = false;
  const auto startOne = [&](int x) {
    row[x] = startValueAt(rows, spacing, unset, size.x, x, onBorder);
    crossed |= isFixed(row[x]);
  };
  // The cap is rare on the border, and left to the plain form.
  int inside = 0;
  if (onBorder)
    for (int x = 0; x < size.x; ++x) inside += here[x] > 0 ? 1 : 0;
  int done = 0;
  if (inside == 0) {
    startOne(0);
    const InnerRow inner = HWY_DYNAMIC_DISPATCH(startInnerRow)(rows, spacing, unset, size.x, row);
    done = inner.end;
    crossed |= inner.crossed;
  }
  for (int x = done; x < size.x; ++x) startOne(x);
  if (crossed && start == DistanceStart::better) betterStartRow(level, spacing, y, z, row);
  return crossed;
}

void startDistance(GridView<const float> level, GridView<float> distance, DistanceStart start) {
  parallelFor(static_cast<std::size_t>(level.size.z), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    for (int y = 0; y < level.size.y; ++y)
      startRow(level, start, kUnsetDistance, y, z, distance.data + z * level.strideZ() + y * level.strideY());
  });
}

}  // namespace isolume
#endif
