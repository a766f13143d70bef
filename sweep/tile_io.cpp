#include "tile_io.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/tile_io.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "surface_start.h"
#include "sweep_tile.h"

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using FloatVec = hn::Vec<FloatTag>;

// Lanes of a 128-bit block, the unit within which vectors interleave.
constexpr int kBlockLanes = 4;
constexpr int kMaxLanes = static_cast<int>(hn::MaxLanes(FloatTag()));
constexpr int kGroups = (kMaxLanes + kBlockLanes - 1) / kBlockLanes;

#if HWY_TARGET == HWY_SCALAR
// One lane: nothing to transpose.
HWY_INLINE void transpose(FloatVec*) {}
#else
// Transposes lanes x lanes floats in registers: first every 4 x 4 block, then the blocks.
HWY_INLINE void transpose(FloatVec* rows) {
  const FloatTag d;
  const hn::Repartition<double, FloatTag> dPairs;
  FloatVec columns[kGroups][kBlockLanes];
  for (int g = 0; g < kGroups; ++g) {
    const FloatVec* r = rows + g * kBlockLanes;
    const auto low01 = hn::BitCast(dPairs, hn::InterleaveLower(d, r[0], r[1]));
    const auto low23 = hn::BitCast(dPairs, hn::InterleaveLower(d, r[2], r[3]));
    const auto high01 = hn::BitCast(dPairs, hn::InterleaveUpper(d, r[0], r[1]));
    const auto high23 = hn::BitCast(dPairs, hn::InterleaveUpper(d, r[2], r[3]));
    columns[g][0] = hn::BitCast(d, hn::InterleaveLower(dPairs, low01, low23));
    columns[g][1] = hn::BitCast(d, hn::InterleaveUpper(dPairs, low01, low23));
    columns[g][2] = hn::BitCast(d, hn::InterleaveLower(dPairs, high01, high23));
    columns[g][3] = hn::BitCast(d, hn::InterleaveUpper(dPairs, high01, high23));
  }
  for (int k = 0; k < kBlockLanes; ++k) {
    if constexpr (kGroups == 1) {
      rows[k] = columns[0][k];
    } else if constexpr (kGroups == 2) {
      rows[k] = hn::ConcatLowerLower(d, columns[1][k], columns[0][k]);
      rows[kBlockLanes + k] = hn::ConcatUpperUpper(d, columns[1][k], columns[0][k]);
    } else {
      const auto even01 = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(columns[1][k]), columns[0][k]);
      const auto odd01 = hn::OddEvenBlocks(columns[1][k], hn::SwapAdjacentBlocks(columns[0][k]));
      const auto even23 = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(columns[3][k]), columns[2][k]);
      const auto odd23 = hn::OddEvenBlocks(columns[3][k], hn::SwapAdjacentBlocks(columns[2][k]));
      rows[k] = hn::ConcatLowerLower(d, even23, even01);
      rows[kBlockLanes + k] = hn::ConcatLowerLower(d, odd23, odd01);
      rows[2 * kBlockLanes + k] = hn::ConcatUpperUpper(d, even23, even01);
      rows[3 * kBlockLanes + k] = hn::ConcatUpperUpper(d, odd23, odd01);
    }
  }
}
#endif

// Steps [first, last) in which all lanes of a whole vector of steps lie within the row.
struct FullSteps {
  int first, last;
};
HWY_INLINE FullSteps fullSteps(int nx, int lanes) {
  const int first = lanes - 1;
  const int vectors = std::max(0, nx - lanes + 1) / lanes;
  return {first, first + vectors * lanes};
}

// Calls visit(x, lane) for the voxels that fullSteps() leaves out.
template <class Visit>
HWY_INLINE void visitRest(int nx, int lane, FullSteps full, const Visit& visit) {
  for (int x = 0; x < std::min(nx, full.first - lane); ++x) visit(x);
  for (int x = std::max(0, full.last - lane); x < nx; ++x) visit(x);
}

// Reads or writes `lanes` voxels of a row from canonical x on, in canonical order.
HWY_INLINE FloatVec loadRow(const float* row, std::ptrdiff_t strideX, int x) {
  const FloatTag d;
  if (strideX > 0) return hn::LoadU(d, row + x);
  return hn::Reverse(d, hn::LoadU(d, row - x - (static_cast<int>(hn::Lanes(d)) - 1)));
}
HWY_INLINE void storeRow(FloatVec values, float* row, std::ptrdiff_t strideX, int x) {
  const FloatTag d;
  if (strideX > 0) return hn::StoreU(values, d, row + x);
  hn::StoreU(hn::Reverse(d, values), d, row - x - (static_cast<int>(hn::Lanes(d)) - 1));
}
HWY_INLINE void storeRow(FloatVec values, std::uint8_t* row, std::ptrdiff_t strideX, int x) {
  const FloatTag d;
  const hn::Rebind<std::uint8_t, FloatTag> d8;
  const auto ordered = strideX > 0 ? values : hn::Reverse(d, values);
  const auto bytes = hn::DemoteTo(d8, hn::NearestInt(hn::Mul(ordered, hn::Set(d, 255.0F))));
  hn::StoreU(bytes, d8, strideX > 0 ? row + x : row - x - (static_cast<int>(hn::Lanes(d)) - 1));
}
HWY_INLINE void storeOne(float value, float* voxel) { *voxel = value; }
HWY_INLINE void storeOne(float value, std::uint8_t* voxel) {
  *voxel = static_cast<std::uint8_t>(std::nearbyint(value * 255.0F));
}

void loadTileOnTarget(const OctantWalk& walk, TileOrigin origin, const float* grid, float* buffer) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int nx = walk.size.x;
  const FullSteps full = fullSteps(nx, lanes);
  const int rowCount = std::min(lanes, walk.size.y - origin.y);
  for (int plane = 0; plane < kTilePlanes; ++plane) {
    float* steps = buffer + (static_cast<std::ptrdiff_t>(plane) * paddedSteps(nx, lanes) + frontPad()) * lanes;
    const bool planeExists = origin.z + plane < walk.size.z;
    const auto rowOf = [&](int lane) { return grid + walk.row(origin.y + lane, origin.z + plane); };
    for (int lane = 0; lane < lanes; ++lane) {
      const auto at = [&](int x) -> float& { return steps[static_cast<std::ptrdiff_t>(x + lane) * lanes + lane]; };
      if (planeExists && lane < rowCount) {
        const float* row = rowOf(lane);
        visitRest(nx, lane, full, [&](int x) { at(x) = row[x * walk.strideX]; });
      } else {
        visitRest(nx, lane, full, [&](int x) { at(x) = kOutsideDistance; });
      }
    }
    for (int t = full.first; t < full.last; t += lanes) {
      FloatVec rows[kMaxLanes];
      for (int lane = 0; lane < kMaxLanes; ++lane) {
        const bool exists = planeExists && lane < rowCount;
        rows[lane] = exists ? loadRow(rowOf(lane), walk.strideX, t - lane) : hn::Set(d, kOutsideDistance);
      }
      transpose(rows);
      for (int i = 0; i < kMaxLanes; ++i) hn::Store(rows[i], d, steps + static_cast<std::ptrdiff_t>(t + i) * lanes);
    }
  }
}

template <class T>
void storeTileAs(const OctantWalk& walk, TileOrigin origin, const float* buffer, T* grid) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int nx = walk.size.x;
  const FullSteps full = fullSteps(nx, lanes);
  const int rowCount = std::min(lanes, walk.size.y - origin.y);
  for (int plane = 0; plane < std::min(kTilePlanes, walk.size.z - origin.z); ++plane) {
    const float* steps = buffer + (static_cast<std::ptrdiff_t>(plane) * paddedSteps(nx, lanes) + frontPad()) * lanes;
    const auto rowOf = [&](int lane) { return grid + walk.row(origin.y + lane, origin.z + plane); };
    for (int lane = 0; lane < rowCount; ++lane) {
      T* row = rowOf(lane);
      visitRest(nx, lane, full, [&](int x) {
        storeOne(steps[static_cast<std::ptrdiff_t>(x + lane) * lanes + lane], row + x * walk.strideX);
      });
    }
    for (int t = full.first; t < full.last; t += lanes) {
      FloatVec rows[kMaxLanes];
      for (int i = 0; i < kMaxLanes; ++i) rows[i] = hn::Load(d, steps + static_cast<std::ptrdiff_t>(t + i) * lanes);
      transpose(rows);
      for (int lane = 0; lane < rowCount; ++lane) storeRow(rows[lane], rowOf(lane), walk.strideX, t - lane);
    }
  }
}

void storeFloatsOnTarget(const OctantWalk& walk, TileOrigin origin, const float* buffer, float* grid) {
  storeTileAs(walk, origin, buffer, grid);
}
void storeBytesOnTarget(const OctantWalk& walk, TileOrigin origin, const float* buffer, std::uint8_t* grid) {
  storeTileAs(walk, origin, buffer, grid);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(loadTileOnTarget);
HWY_EXPORT(storeFloatsOnTarget);
HWY_EXPORT(storeBytesOnTarget);

OctantWalk walkOctant(glm::ivec3 size, const Octant& octant) {
  const std::ptrdiff_t strideY = size.x;
  const std::ptrdiff_t strideZ = strideY * size.y;
  OctantWalk walk;
  walk.size = size;
  walk.strideX = octant.sweep.x;
  walk.strideY = octant.sweep.y * strideY;
  walk.strideZ = octant.sweep.z * strideZ;
  walk.start = (octant.sweep.x < 0 ? size.x - 1 : 0) + (octant.sweep.y < 0 ? (size.y - 1) * strideY : 0) +
               (octant.sweep.z < 0 ? (size.z - 1) * strideZ : 0);
  return walk;
}

void loadTile(const OctantWalk& walk, TileOrigin origin, const float* grid, float* buffer) {
  HWY_DYNAMIC_DISPATCH(loadTileOnTarget)(walk, origin, grid, buffer);
}
void storeTile(const OctantWalk& walk, TileOrigin origin, const float* buffer, float* grid) {
  HWY_DYNAMIC_DISPATCH(storeFloatsOnTarget)(walk, origin, buffer, grid);
}
void storeTile(const OctantWalk& walk, TileOrigin origin, const float* buffer, std::uint8_t* grid) {
  HWY_DYNAMIC_DISPATCH(storeBytesOnTarget)(walk, origin, buffer, grid);
}

}  // namespace isolume
#endif
