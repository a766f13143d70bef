#include "row_kernels.h"

#include <algorithm>
#include <cmath>

#include "sweep/bit_grid.h"
#include "sweep/closest/offset_field.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/closest/row_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "bit_mask-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
// Never wider than a group of rows.
using FloatTag = hn::CappedTag<float, kRowGroup>;
using FloatVec = hn::Vec<FloatTag>;

struct Offsets {
  FloatVec x, y, z, squared;
};

HWY_INLINE FloatVec squaredOf(FloatVec x, FloatVec y, FloatVec z) {
  return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
}

HWY_INLINE Offsets withSquare(FloatVec x, FloatVec y, FloatVec z) { return {x, y, z, squaredOf(x, y, z)}; }

HWY_INLINE Offsets load(const PaddedPlane& plane, int y, int x) {
  const FloatTag d;
  return withSquare(hn::LoadU(d, plane.row(0, y) + x), hn::LoadU(d, plane.row(1, y) + x),
                    hn::LoadU(d, plane.row(2, y) + x));
}

HWY_INLINE void store(const Offsets& offsets, int y, int x, PaddedPlane& plane) {
  const FloatTag d;
  hn::StoreU(offsets.x, d, plane.row(0, y) + x);
  hn::StoreU(offsets.y, d, plane.row(1, y) + x);
  hn::StoreU(offsets.z, d, plane.row(2, y) + x);
}

HWY_INLINE void keepNearer(const Offsets& candidate, Offsets& best) {
  const auto nearer = hn::Lt(candidate.squared, best.squared);
  best.x = hn::IfThenElse(nearer, candidate.x, best.x);
  best.y = hn::IfThenElse(nearer, candidate.y, best.y);
  best.z = hn::IfThenElse(nearer, candidate.z, best.z);
  best.squared = hn::Min(candidate.squared, best.squared);
}

// Three candidates of one row of neighbours at step (., dy, dz).
HWY_INLINE void takeThree(const float* fromX, const float* fromY, const float* fromZ, FloatVec dx, FloatVec dy,
                          FloatVec dz, Offsets& best) {
  const FloatTag d;
  const auto candidate = [&](int shift, auto stepX) {
    return withSquare(hn::Add(hn::LoadU(d, fromX + shift), stepX), hn::Add(hn::LoadU(d, fromY + shift), dy),
                      hn::Add(hn::LoadU(d, fromZ + shift), dz));
  };
  keepNearer(candidate(-1, hn::Neg(dx)), best);
  keepNearer(candidate(0, hn::Zero(d)), best);
  keepNearer(candidate(1, dx), best);
}

// Of a row of `count` floats, those from x on: a whole vector, or what is left and zeros.
HWY_INLINE FloatVec loadPart(const float* row, int x, int count) {
  const FloatTag d;
  if (x + static_cast<int>(hn::Lanes(d)) <= count) return hn::LoadU(d, row + x);
  HWY_ALIGN float part[kRowGroup] = {};
  std::copy(row + x, row + count, part);
  return hn::Load(d, part);
}
HWY_INLINE void storePart(FloatVec values, int x, int count, float* row) {
  const FloatTag d;
  if (x + static_cast<int>(hn::Lanes(d)) <= count) {
    hn::StoreU(values, d, row + x);
    return;
  }
  HWY_ALIGN float part[kRowGroup];
  hn::Store(values, d, part);
  std::copy_n(part, count - x, row + x);
}

// Of the samples from x on, which are fixed, and their offsets; `others` elsewhere.
struct FixedPart {
  std::uint64_t bits;
  hn::Mask<FloatTag> mask;
  FixedPart(const FixedRow& row, int x)
      : bits(row.bits[x / kWordBits] >> (x % kWordBits) & ((std::uint64_t{1} << hn::Lanes(FloatTag())) - 1)),
        mask(maskOf(FloatTag(), bits)) {}
};
HWY_INLINE Offsets withFixed(const FixedPart& part, const FixedRow& row, int x, int nx, const Offsets& others) {
  return withSquare(hn::IfThenElse(part.mask, loadPart(row.component[0], x, nx), others.x),
                    hn::IfThenElse(part.mask, loadPart(row.component[1], x, nx), others.y),
                    hn::IfThenElse(part.mask, loadPart(row.component[2], x, nx), others.z));
}

void planeStep(const FixedRow& fixed, const PaddedPlane* before, float dz, glm::vec3 step, int nx, int y,
               PaddedPlane& plane) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto stepX = hn::Set(d, step.x);
  const auto stepZ = hn::Set(d, dz);
  const Offsets unset = withSquare(hn::Set(d, kUnsetOffset), hn::Zero(d), hn::Zero(d));
  const float* rows[3][3];
  for (int dy = -1; dy <= 1 && before != nullptr; ++dy)
    for (int axis = 0; axis < 3; ++axis) rows[dy + 1][axis] = before->row(axis, y + dy);
  for (int x = 0; x < nx; x += lanes) {
    const FixedPart part(fixed, x);
    Offsets best = part.bits == 0 ? unset : withFixed(part, fixed, x, nx, unset);
    if (before != nullptr) {
      takeThree(rows[0][0] + x, rows[0][1] + x, rows[0][2] + x, stepX, hn::Set(d, -step.y), stepZ, best);
      takeThree(rows[1][0] + x, rows[1][1] + x, rows[1][2] + x, stepX, hn::Zero(d), stepZ, best);
      takeThree(rows[2][0] + x, rows[2][1] + x, rows[2][2] + x, stepX, hn::Set(d, step.y), stepZ, best);
    }
    store(best, y, x, plane);
  }
  plane.clearTail(y);
}

void rowsStep(PaddedPlane& plane, glm::vec3 step, int nx, int first, int dy, int count) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto stepX = hn::Set(d, step.x);
  const auto stepY = hn::Set(d, -static_cast<float>(dy) * step.y);
  for (int i = 0; i < count; ++i) {
    const int y = first + i * dy;
    const float* fromX = plane.row(0, y - dy);
    const float* fromY = plane.row(1, y - dy);
    const float* fromZ = plane.row(2, y - dy);
    for (int x = 0; x < nx; x += lanes) {
      Offsets best = load(plane, y, x);
      takeThree(fromX + x, fromY + x, fromZ + x, stepX, stepY, hn::Zero(d), best);
      store(best, y, x, plane);
    }
    plane.clearTail(y);
  }
}

// Four rows of kRowGroup floats each, `apart` floats apart, to one run of 4 kRowGroup floats, value by value.
HWY_INLINE void interleave4(const float* rows, std::ptrdiff_t apart, float* run) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < kRowGroup; i += lanes)
    hn::StoreInterleaved4(hn::LoadU(d, rows + i), hn::LoadU(d, rows + apart + i), hn::LoadU(d, rows + 2 * apart + i),
                          hn::LoadU(d, rows + 3 * apart + i), d, run + 4 * i);
}

constexpr int kBlock = kRowGroup * kRowGroup;

// Transposes 16 x 16 floats, rows `stride` floats apart, as two rounds of interleaving by four: rows (r, r + 4, r + 8,
// r + 12) first, then the four runs.
HWY_INLINE void toColumns(const float* rows, std::ptrdiff_t stride, float* columns) {
  HWY_ALIGN float runs[kBlock];
  for (int r = 0; r < 4; ++r) interleave4(rows + r * stride, 4 * stride, runs + r * kBlock / 4);
  for (int part = 0; part < 4; ++part) interleave4(runs + part * kRowGroup, kBlock / 4, columns + part * kBlock / 4);
}

void transposeStep(const PaddedPlane& from, int nx, int y, PaddedPlane& to) {
  const std::ptrdiff_t stride = from.row(0, 1) - from.row(0, 0);
  const FloatTag d;
  HWY_ALIGN float columns[kBlock];
  for (int axis = 0; axis < 3; ++axis) {
    const int fromAxis = axis == 2 ? 2 : 1 - axis;
    for (int x = 0; x < nx; x += kRowGroup) {
      toColumns(from.row(fromAxis, x) + y, stride, columns);
      for (int i = 0; i < kRowGroup; ++i)
        for (int lane = 0; lane < kRowGroup; lane += static_cast<int>(hn::Lanes(d)))
          hn::Store(hn::Load(d, columns + i * kRowGroup + lane), d, to.row(axis, y + i) + x + lane);
    }
  }
}

// The distance by its square; negative where level > 0.
HWY_INLINE FloatVec signedDistance(FloatVec squared, FloatVec level, float unit) {
  const FloatTag d;
  const auto distance = hn::Mul(hn::Sqrt(squared), hn::Set(d, unit));
  return hn::IfThenElse(hn::Gt(level, hn::Zero(d)), hn::Neg(distance), distance);
}

void finishStep(const FixedRow& fixed, Result result, const float* level, float unit, int nx, int y,
                PaddedPlane& plane) {
  const FloatTag d;
  float* out = fixed.component[0];
  for (int x = 0; x < nx; x += static_cast<int>(hn::Lanes(d))) {
    const FixedPart part(fixed, x);
    Offsets own = load(plane, y, x);
    if (part.bits != 0) {
      own = withFixed(part, fixed, x, nx, own);
      store(own, y, x, plane);
    }
    if (result == Result::kept) {
      storePart(hn::IfThenElse(part.mask, own.x, own.squared), x, nx, out);
      continue;
    }
    FloatVec squared = own.squared;
    if (result == Result::compared)
      squared = hn::IfThenElse(part.mask, squared, hn::Min(squared, loadPart(out, x, nx)));
    storePart(signedDistance(squared, loadPart(level, x, nx), unit), x, nx, out);
  }
}

void distanceStep(const float* x, const float* y, const float* z, const float* level, float unit, std::size_t count,
                  float* out) {
  const FloatTag d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto squared = squaredOf(hn::LoadU(d, x + i), hn::LoadU(d, y + i), hn::LoadU(d, z + i));
    hn::StoreU(signedDistance(squared, hn::LoadU(d, level + i), unit), d, out + i);
  }
  for (; i < count; ++i) {
    const float distance = std::sqrt(squaredLength({x[i], y[i], z[i]})) * unit;
    out[i] = level[i] > 0 ? -distance : distance;
  }
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(planeStep);
HWY_EXPORT(rowsStep);
HWY_EXPORT(transposeStep);
HWY_EXPORT(finishStep);
HWY_EXPORT(distanceStep);

void takeFromPlane(const FixedRow& fixed, const PaddedPlane* before, float dz, glm::vec3 step, int nx, int y,
                   PaddedPlane& plane) {
  HWY_DYNAMIC_DISPATCH(planeStep)(fixed, before, dz, step, nx, y, plane);
}
void takeFromRows(PaddedPlane& plane, glm::vec3 step, int nx, int first, int dy, int count) {
  HWY_DYNAMIC_DISPATCH(rowsStep)(plane, step, nx, first, dy, count);
}
void transposeRows(const PaddedPlane& from, int nx, int y, PaddedPlane& to) {
  HWY_DYNAMIC_DISPATCH(transposeStep)(from, nx, y, to);
}
void finishRow(const FixedRow& fixed, Result result, const float* level, float unit, int nx, int y,
               PaddedPlane& plane) {
  HWY_DYNAMIC_DISPATCH(finishStep)(fixed, result, level, unit, nx, y, plane);
}
void offsetsToDistance(const float* x, const float* y, const float* z, const float* level, float unit,
                       std::size_t count, float* out) {
  HWY_DYNAMIC_DISPATCH(distanceStep)(x, y, z, level, unit, count, out);
}

}  // namespace isolume
#endif
