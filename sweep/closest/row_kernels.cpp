#include "row_kernels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/closest/row_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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

void planeStep(const PaddedPlane& before, float dz, glm::vec3 step, int nx, int y, PaddedPlane& plane,
               PaddedPlane& copy) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto stepX = hn::Set(d, step.x);
  const auto stepZ = hn::Set(d, dz);
  const float* rows[3][3];
  for (int dy = -1; dy <= 1; ++dy)
    for (int axis = 0; axis < 3; ++axis) rows[dy + 1][axis] = before.row(axis, y + dy);
  for (int x = 0; x < nx; x += lanes) {
    Offsets best = load(plane, y, x);
    takeThree(rows[0][0] + x, rows[0][1] + x, rows[0][2] + x, stepX, hn::Set(d, -step.y), stepZ, best);
    takeThree(rows[1][0] + x, rows[1][1] + x, rows[1][2] + x, stepX, hn::Zero(d), stepZ, best);
    takeThree(rows[2][0] + x, rows[2][1] + x, rows[2][2] + x, stepX, hn::Set(d, step.y), stepZ, best);
    store(best, y, x, plane);
    store(best, y, x, copy);
  }
  plane.clearTail(y);
  copy.clearTail(y);
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

// Four rows of kRowGroup floats each, `apart` floats apart, to one run of 4 kRowGroup floats, value by value; and back.
HWY_INLINE void interleave4(const float* rows, std::ptrdiff_t apart, float* run) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < kRowGroup; i += lanes)
    hn::StoreInterleaved4(hn::LoadU(d, rows + i), hn::LoadU(d, rows + apart + i), hn::LoadU(d, rows + 2 * apart + i),
                          hn::LoadU(d, rows + 3 * apart + i), d, run + 4 * i);
}
HWY_INLINE void separate4(const float* run, float* rows, std::ptrdiff_t apart) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < kRowGroup; i += lanes) {
    FloatVec a, b, c, e;
    hn::LoadInterleaved4(d, run + 4 * i, a, b, c, e);
    hn::StoreU(a, d, rows + i);
    hn::StoreU(b, d, rows + apart + i);
    hn::StoreU(c, d, rows + 2 * apart + i);
    hn::StoreU(e, d, rows + 3 * apart + i);
  }
}

constexpr int kBlock = kRowGroup * kRowGroup;

// Transposes 16 x 16 floats, rows `stride` floats apart, as two rounds of interleaving by four: rows (r, r + 4, r + 8,
// r + 12) first, then the four runs.
HWY_INLINE void toColumns(const float* rows, std::ptrdiff_t stride, float* columns) {
  HWY_ALIGN float runs[kBlock];
  for (int r = 0; r < 4; ++r) interleave4(rows + r * stride, 4 * stride, runs + r * kBlock / 4);
  for (int part = 0; part < 4; ++part) interleave4(runs + part * kRowGroup, kBlock / 4, columns + part * kBlock / 4);
}
HWY_INLINE void toRows(const float* columns, float* rows, std::ptrdiff_t stride) {
  HWY_ALIGN float runs[kBlock];
  for (int part = 0; part < 4; ++part) separate4(columns + part * kBlock / 4, runs + part * kRowGroup, kBlock / 4);
  for (int r = 0; r < 4; ++r) separate4(runs + r * kBlock / 4, rows + r * stride, 4 * stride);
}

// Step 3 for kGroups groups of rows as columns, `apart` floats apart: each step along x waits for the one before, so two
// groups take turns.
template <int kGroups>
HWY_INLINE void scanColumns(float* const (&columns)[3], std::size_t apart, float step, int first, int dx, int count) {
  const FloatTag d;
  const auto stepX = hn::Set(d, step);
  for (int lane = 0; lane < kRowGroup; lane += static_cast<int>(hn::Lanes(d))) {
    const auto at = [&](int group, int x, int axis) {
      return columns[axis] + static_cast<std::size_t>(group) * apart + x * kRowGroup + lane;
    };
    FloatVec from[kGroups][3];
    for (int g = 0; g < kGroups; ++g)
      for (int axis = 0; axis < 3; ++axis) from[g][axis] = hn::Load(d, at(g, first, axis));
    for (int i = 1, x = first + dx; i < count; ++i, x += dx)
      for (int g = 0; g < kGroups; ++g) {
        Offsets best = withSquare(hn::Load(d, at(g, x, 0)), hn::Load(d, at(g, x, 1)), hn::Load(d, at(g, x, 2)));
        keepNearer(withSquare(hn::Add(from[g][0], stepX), from[g][1], from[g][2]), best);
        hn::Store(best.x, d, at(g, x, 0));
        hn::Store(best.y, d, at(g, x, 1));
        hn::Store(best.z, d, at(g, x, 2));
        from[g][0] = best.x;
        from[g][1] = best.y;
        from[g][2] = best.z;
      }
  }
}

void alongStep(const PaddedPlane& other, float stepX, int nx, int y, int groups, PaddedPlane& plane) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int row = y; row < y + groups * kRowGroup; ++row)
    for (int x = 0; x < nx; x += lanes) {
      Offsets best = load(plane, row, x);
      keepNearer(load(other, row, x), best);
      store(best, row, x, plane);
    }

  const std::ptrdiff_t stride = plane.row(0, 1) - plane.row(0, 0);
  const std::size_t width = static_cast<std::size_t>(PaddedPlane::roundUp(nx)) * kRowGroup;
  const std::size_t apart = 3 * width;
  static thread_local LargeArray<float> scratch;
  static thread_local std::size_t room = 0;
  if (room < kAlongGroups * apart) {
    room = kAlongGroups * apart;
    scratch = makeLargeArray<float>(room);
  }
  float* const columns[3] = {scratch.get(), scratch.get() + width, scratch.get() + 2 * width};
  const auto forBlocks = [&](const auto& visit) {
    for (int g = 0; g < groups; ++g)
      for (int axis = 0; axis < 3; ++axis)
        for (int x = 0; x < nx; x += kRowGroup)
          visit(plane.row(axis, y + g * kRowGroup) + x,
                columns[axis] + static_cast<std::size_t>(g) * apart + x * kRowGroup);
  };
  forBlocks([&](float* rows, float* block) { toColumns(rows, stride, block); });
  for (const int dx : {1, -1}) {
    const int first = dx > 0 ? 0 : nx - 1;
    const float step = -static_cast<float>(dx) * stepX;
    if (groups == kAlongGroups) {
      scanColumns<kAlongGroups>(columns, apart, step, first, dx, nx);
    } else {
      scanColumns<1>(columns, apart, step, first, dx, nx);
    }
  }
  forBlocks([&](float* rows, float* block) { toRows(block, rows, stride); });
}

void distanceStep(const float* x, const float* y, const float* z, const float* level, float unit, std::size_t count,
                  float* out) {
  const FloatTag d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto squared = squaredOf(hn::LoadU(d, x + i), hn::LoadU(d, y + i), hn::LoadU(d, z + i));
    const auto distance = hn::Mul(hn::Sqrt(squared), hn::Set(d, unit));
    const auto inside = hn::Gt(hn::LoadU(d, level + i), hn::Zero(d));
    hn::StoreU(hn::IfThenElse(inside, hn::Neg(distance), distance), d, out + i);
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
HWY_EXPORT(alongStep);
HWY_EXPORT(distanceStep);

void takeFromPlane(const PaddedPlane& before, float dz, glm::vec3 step, int nx, int y, PaddedPlane& plane,
                   PaddedPlane& copy) {
  HWY_DYNAMIC_DISPATCH(planeStep)(before, dz, step, nx, y, plane, copy);
}
void takeFromRows(PaddedPlane& plane, glm::vec3 step, int nx, int first, int dy, int count) {
  HWY_DYNAMIC_DISPATCH(rowsStep)(plane, step, nx, first, dy, count);
}
void takeAlongRows(const PaddedPlane& other, float stepX, int nx, int y, int groups, PaddedPlane& plane) {
  HWY_DYNAMIC_DISPATCH(alongStep)(other, stepX, nx, y, groups, plane);
}
void offsetsToDistance(const float* x, const float* y, const float* z, const float* level, float unit,
                       std::size_t count, float* out) {
  HWY_DYNAMIC_DISPATCH(distanceStep)(x, y, z, level, unit, count, out);
}

}  // namespace isolume
#endif
