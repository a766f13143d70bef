#include "tile_io.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/godunov/tile_io.cpp"
#include <hwy/cache_control.h>
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

// Vectors of lanes voxels of one row in canonical order, `x` the first of them; only voxels of [0, count) exist.
struct RowPart {
  int x, count;
  bool whole(int lanes) const { return x >= 0 && x + lanes <= count; }
  bool empty(int lanes) const { return x + lanes <= 0 || x >= count; }
  // The voxels that exist, in memory order.
  HWY_INLINE hn::Mask<FloatTag> inMemory(std::ptrdiff_t strideX) const {
    const FloatTag d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const int first = std::max(0, -x), last = std::min(lanes, count - x);
    const auto begin = static_cast<std::size_t>(strideX > 0 ? first : lanes - last);
    const auto end = static_cast<std::size_t>(strideX > 0 ? last : lanes - first);
    return hn::AndNot(hn::FirstN(d, begin), hn::FirstN(d, end));
  }
};

// Where the row's vector starts in memory: at its last voxel if the walk runs against it.
template <class T>
HWY_INLINE T* memoryStart(T* row, std::ptrdiff_t strideX, int x, int lanes) {
  return strideX > 0 ? row + x : row - x - (lanes - 1);
}

// Parts of a row in memory order, which is against the canonical one if the walk runs against it. Hence transposed
// vectors are taken from the last to the first; no vector is reversed.
HWY_INLINE FloatVec loadPart(const float* row, std::ptrdiff_t strideX, RowPart part) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  if (part.whole(lanes)) return hn::LoadU(d, memoryStart(row, strideX, part.x, lanes));
  if (part.empty(lanes)) return hn::Set(d, kOutsideDistance);
#if HWY_TARGET <= HWY_AVX2
  // Masked loads touch no memory outside of the mask.
  const auto mask = part.inMemory(strideX);
  const auto values = hn::MaskedLoad(mask, d, memoryStart(row, strideX, part.x, lanes));
  return hn::IfThenElse(mask, values, hn::Set(d, kOutsideDistance));
#else
  alignas(64) float values[kMaxLanes];
  for (int i = 0; i < lanes; ++i) {
    const int x = part.x + i;
    values[strideX > 0 ? i : lanes - 1 - i] = x >= 0 && x < part.count ? row[x * strideX] : kOutsideDistance;
  }
  return hn::Load(d, values);
#endif
}

HWY_INLINE void storePart(FloatVec values, float* row, std::ptrdiff_t strideX, RowPart part) {
  const FloatTag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  if (part.whole(lanes)) return hn::StoreU(values, d, memoryStart(row, strideX, part.x, lanes));
#if HWY_TARGET <= HWY_AVX2
  hn::BlendedStore(values, part.inMemory(strideX), d, memoryStart(row, strideX, part.x, lanes));
#else
  alignas(64) float inMemory[kMaxLanes];
  hn::Store(values, d, inMemory);
  for (int i = std::max(0, -part.x); i < std::min(lanes, part.count - part.x); ++i)
    row[(part.x + i) * strideX] = inMemory[strideX > 0 ? i : lanes - 1 - i];
#endif
}

// Calls visit(t, whole) for blocks of lanes steps that cover all that a sweep of the span looks at; whole: in all of
// them every lane lies within the span.
template <class Visit>
HWY_INLINE void visitSteps(TileSpan span, int lanes, const Visit& visit) {
  for (int t = 0; t < span.count + lanes - 1 + kTilePlanes; t += lanes)
    visit(t, t >= lanes - 1 && t + lanes <= span.count);
}

// One plane of a tile, canonical z, to [step][lane].
HWY_INLINE void loadPlane(const OctantWalk& walk, int y, int z, TileSpan span, const float* grid, float* steps) {
  const FloatTag d;
  constexpr int lanes = kMaxLanes;
  const bool planeExists = z >= 0 && z < walk.size.z;
  const bool allRows = planeExists && y >= 0 && y + lanes <= walk.size.y;
  const bool nextExists = z + 1 >= 0 && z + 1 < walk.size.z;
  const bool forward = walk.strideX > 0;
  const float* start = grid + walk.start + z * walk.strideZ + span.first * walk.strideX;
  visitSteps(span, lanes, [&](int t, bool) {
    FloatVec rows[lanes];
    // What lies beside the span may come along: no mask is cheaper than one.
    const bool inGrid = span.first + t >= lanes - 1 && span.first + t + lanes <= walk.size.x;
    if (inGrid && allRows) {
      // Lane by lane one row further and one voxel back.
      const float* first = memoryStart(start + y * walk.strideY, walk.strideX, t, lanes);
      const std::ptrdiff_t step = walk.strideY - walk.strideX;
      for (int lane = 0; lane < lanes; ++lane) rows[lane] = hn::LoadU(d, first + lane * step);
      if (nextExists)
        for (int lane = 0; lane < lanes; ++lane) hwy::Prefetch(first + walk.strideZ + lane * step);
    } else {
      for (int lane = 0; lane < lanes; ++lane) {
        const bool exists = planeExists && y + lane >= 0 && y + lane < walk.size.y;
        rows[lane] = exists ? loadPart(start + (y + lane) * walk.strideY, walk.strideX, {t - lane, span.count})
                            : hn::Set(d, kOutsideDistance);
      }
    }
    transpose(rows);
    for (int i = 0; i < lanes; ++i)
      hn::Store(rows[forward ? i : lanes - 1 - i], d, steps + static_cast<std::ptrdiff_t>(t + i) * lanes);
  });
}

void loadTileOnTarget(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* grid, float* buffer) {
  const int lanes = static_cast<int>(hn::Lanes(FloatTag()));
  for (int plane = 0; plane < kTilePlanes; ++plane) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(plane) * paddedSteps(walk.size.x, lanes) + frontPad();
    loadPlane(walk, origin.y, origin.z + plane, span, grid, buffer + at * lanes);
  }
}

void loadCarriedOnTarget(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* grid, float* carried) {
  const int lanes = static_cast<int>(hn::Lanes(FloatTag()));
  float* steps = carried + static_cast<std::ptrdiff_t>(frontPad() + span.first) * lanes;
  loadPlane(walk, origin.y, origin.z - 1, span, grid, steps);
}

void storeTileOnTarget(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* buffer, float* grid) {
  const FloatTag d;
  constexpr int lanes = kMaxLanes;
  const bool forward = walk.strideX > 0;
  const bool allRows = origin.y >= 0 && origin.y + lanes <= walk.size.y;
  for (int plane = 0; plane < kTilePlanes; ++plane) {
    const int z = origin.z + plane;
    if (z < 0 || z >= walk.size.z) continue;
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(plane) * paddedSteps(walk.size.x, lanes) + frontPad();
    const float* steps = buffer + at * lanes;
    float* start = grid + walk.start + z * walk.strideZ + span.first * walk.strideX;
    visitSteps(span, lanes, [&](int t, bool whole) {
      FloatVec rows[lanes];
      for (int i = 0; i < lanes; ++i)
        rows[i] = hn::Load(d, steps + static_cast<std::ptrdiff_t>(t + (forward ? i : lanes - 1 - i)) * lanes);
      transpose(rows);
      if (whole && allRows) {
        float* first = memoryStart(start + origin.y * walk.strideY, walk.strideX, t, lanes);
        const std::ptrdiff_t step = walk.strideY - walk.strideX;
        for (int lane = 0; lane < lanes; ++lane) hn::StoreU(rows[lane], d, first + lane * step);
        return;
      }
      for (int lane = std::max(0, -origin.y); lane < std::min(lanes, walk.size.y - origin.y); ++lane) {
        const RowPart part{t - lane, span.count};
        if (!part.empty(lanes)) storePart(rows[lane], start + (origin.y + lane) * walk.strideY, walk.strideX, part);
      }
    });
  }
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(loadTileOnTarget);
HWY_EXPORT(loadCarriedOnTarget);
HWY_EXPORT(storeTileOnTarget);

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

void loadTile(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* grid, float* buffer) {
  HWY_DYNAMIC_DISPATCH(loadTileOnTarget)(walk, origin, span, grid, buffer);
}
void loadCarried(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* grid, float* carried) {
  HWY_DYNAMIC_DISPATCH(loadCarriedOnTarget)(walk, origin, span, grid, carried);
}
void storeTile(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* buffer, float* grid) {
  HWY_DYNAMIC_DISPATCH(storeTileOnTarget)(walk, origin, span, buffer, grid);
}

void loadRowBelow(const OctantWalk& walk, TileOrigin origin, TileSpan span, const float* grid, float* rows) {
  const int lanes = tileLanes();
  for (int plane = 0; plane < kTilePlanes; ++plane) {
    const int y = origin.y - 1, z = origin.z + plane;
    const bool exists = y >= 0 && y < walk.size.y && z >= 0 && z < walk.size.z;
    float* out = rows + static_cast<std::ptrdiff_t>(plane) * paddedRow(walk.size.x, lanes) + rowFrontPad(lanes);
    const float* row = exists ? grid + walk.row(y, z) : nullptr;
    // From before the span, where the first planes start, to behind it, where the last lanes end.
    for (int x = span.first - kTilePlanes; x < span.first + span.count + lanes + kTilePlanes - 1; ++x) {
      const bool within = exists && x >= span.first && x < span.first + span.count;
      out[x] = within ? row[x * walk.strideX] : kOutsideDistance;
    }
  }
}

}  // namespace isolume
#endif
