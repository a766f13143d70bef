#include "occlusion_sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "closest/closest_distance.h"
#include "godunov/band_spans.h"
#include "godunov/distance_sweeper.h"
#include "godunov/surface_start.h"
#include "near_sets.h"
#include "octants/fixed_light_sweeper.h"
#include "octants/light_sweeper.h"
#include "parallel.h"

namespace isolume {
namespace {

// From the sweep's units and tags to world units; what was never reached is infinitely far.
void finishRow(float* row, int count, float smallestSpacing) {
  for (int x = 0; x < count; ++x) {
    const float value = withFixedBit(row[x], false);
    const float world = value * smallestSpacing;
    row[x] = std::abs(value) < kUnsetDistance ? world : std::copysign(std::numeric_limits<float>::infinity(), value);
  }
}

// I_s / sum I.
OctantIntensities sharesOf(const OctantIntensities& intensities) {
  double sum = 0;
  for (const float intensity : intensities) {
    assert(intensity >= 0 && std::isfinite(intensity));
    sum += intensity;
  }
  assert(sum > 0);
  OctantIntensities shares;
  for (std::size_t s = 0; s < shares.size(); ++s) shares[s] = static_cast<float>(intensities[s] / sum);
  return shares;
}

constexpr int kOctantPairs = kOctantCount / 2;

// Start values are made as the first sweep comes to a tile, and world units as the last leaves it.
Grid<float> sweepWholeDomain(GridView<const float> level, const SweepOptions& options) {
  Grid<float> grid(level.size, level.spacing, level.origin);
  const GridView<float> distance = grid.view();
  const auto smallest = static_cast<float>(smallestSpacing(level.spacing));
  const auto rowOf = [&](int y, int z) { return distance.data + z * distance.strideZ() + y * distance.strideY(); };
  const RowHook start = [&](int y, int z) { startRow(level, options.start, kUnsetDistance, y, z, rowOf(y, z)); };
  const RowHook finish = [&](int y, int z) { finishRow(rowOf(y, z), level.size.x, smallest); };
  const bool once = options.rounds == 1;

  DistanceSweeper sweeper(distance, makeSweepMetric(level.spacing));
  for (int pair = 0; pair < kOctantPairs; ++pair) {
    const bool last = pair == kOctantPairs - 1;
    sweeper.sweepPair(pair, pair == 0 ? start : RowHook(), last && once ? finish : RowHook());
  }
  if (once) return grid;
  for (int round = 1; round < options.rounds; ++round)
    if (!sweeper.sweepRound()) break;
  parallelFor(static_cast<std::size_t>(level.size.z), [&](std::size_t z) {
    for (int y = 0; y < level.size.y; ++y) finish(y, static_cast<int>(z));
  });
  return grid;
}

// In smallest spacings; the fixed bit is clear.
float bandBound(glm::dvec3 spacing, int voxels) {
  const double largest = std::max({spacing.x, spacing.y, spacing.z}) / smallestSpacing(spacing);
  const auto bound = static_cast<float>(std::max(voxels + 1.0, largest));
  return isFixed(bound) ? std::nextafter(bound, kUnsetDistance) : bound;
}

// Values start at the bound in place of unset: what they come to below it is the same (upwind_update-inl.h).
Grid<float> sweepBand(GridView<const float> level, const SweepOptions& options) {
  Grid<float> grid(level.size, level.spacing, level.origin);
  const GridView<float> distance = grid.view();
  const auto smallest = static_cast<float>(smallestSpacing(level.spacing));
  const float bound = bandBound(level.spacing, options.bandVoxels);
  const auto rowOf = [&](int y, int z) { return distance.data + z * distance.strideZ() + y * distance.strideY(); };

  BitGrid fixed(level.size);
  parallelFor(static_cast<std::size_t>(level.size.z), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    for (int y = 0; y < level.size.y; ++y)
      if (startRow(level, options.start, bound, y, z, rowOf(y, z)))
        fixedBits(rowOf(y, z), level.size.x, fixed.row(y, z));
  });
  const int chain = longestChain(level.size, level.spacing / static_cast<double>(smallest), bound);

  DistanceSweeper sweeper(distance, makeSweepMetric(level.spacing));
  const TileGrid& tiles = sweeper.tiles();
  std::vector<std::vector<TileSpan>> spans(tiles.count());
  parallelFor(static_cast<std::size_t>(tiles.layers), [&](std::size_t layer) {
    for (int block = 0; block < tiles.blocks; ++block)
      spans[tiles.index(block, static_cast<int>(layer))] =
          bandSpans(fixed, chain, tiles, block, static_cast<int>(layer));
  });
  for (int round = 0; round < options.rounds; ++round)
    if (!sweeper.sweepRound(&spans)) break;

  // Beyond the spans is the bound, which needs no change where the unit is 1.
  const std::vector<TileSpan> whole{{0, level.size.x}};
  parallelFor(static_cast<std::size_t>(tiles.layers), [&](std::size_t plane) {
    const int layer = static_cast<int>(plane);
    for (int block = 0; block < tiles.blocks; ++block) {
      for (const TileSpan& span : smallest == 1 ? spans[tiles.index(block, layer)] : whole)
        tiles.forEachRow(block, layer,
                         [&](int y, int z) { finishRow(rowOf(y, z) + span.first, span.count, smallest); });
    }
  });
  return grid;
}

}  // namespace

OctantVisibility sweepVisibility(GridView<const float> distance, VisibilityStorage storage, float opacity,
                                 const OctantIntensities& intensities) {
  OctantVisibility visibility;
  if (storage == VisibilityStorage::rgba8) {
    for (auto& grid : visibility.packed) grid = Grid<glm::u8vec4>(distance.size, distance.spacing, distance.origin);
    sweepOctantBytes(distance, opacity, {visibility.packed[0].data(), visibility.packed[1].data()});
  } else if (storage == VisibilityStorage::combined) {
    visibility.combined = Grid<std::uint16_t>(distance.size, distance.spacing, distance.origin);
    sweepOctantMean(distance, opacity, sharesOf(intensities), visibility.combined.data());
  } else if (storage == VisibilityStorage::float32) {
    for (auto& grid : visibility.octants) grid = Grid<float>(distance.size, distance.spacing, distance.origin);
    LightSweeper(distance, opacity).sweep(OctantSet().set(), [&](const LitTile& tile) {
      Grid<float>& grid = visibility.octants[static_cast<std::size_t>(tile.octant)];
      storeTile(tile.walk, tile.origin, {0, distance.size.x}, tile.visibility, grid.data());
    });
  }
  return visibility;
}

SweptFields sweepOcclusion(GridView<const float> level, const SweepOptions& options) {
  SweptFields fields;
  const bool whole = options.extent == DistanceExtent::full;
  if (options.solver == DistanceSolver::closest)
    fields.distance =
        closestDistance(level, {.extent = options.extent, .bandVoxels = whole ? kWholeBandVoxels : options.bandVoxels});
  else if (options.extent == DistanceExtent::band)
    fields.distance = sweepBand(level, options);
  else
    fields.distance = sweepWholeDomain(level, options);
  fields.visibility =
      sweepVisibility(std::as_const(fields.distance).view(), options.visibility, options.opacity, options.intensities);
  return fields;
}

std::array<Grid<glm::u8vec4>, 2> packOctants(const std::array<Grid<float>, kOctantCount>& octants) {
  const GridView<const float> like = octants[0].view();
  std::array<Grid<glm::u8vec4>, 2> packed;
  const std::size_t perPlane = voxelCount({like.size.x, like.size.y, 1});
  for (std::size_t texture = 0; texture < packed.size(); ++texture) {
    packed[texture] = Grid<glm::u8vec4>(like.size, like.spacing, like.origin);
    parallelFor(static_cast<std::size_t>(like.size.z), [&](std::size_t z) {
      for (std::size_t i = z * perPlane; i < (z + 1) * perPlane; ++i) {
        for (std::size_t channel = 0; channel < 4; ++channel) {
          const float scaled = 255.0F * octants[texture * 4 + channel].data()[i];
          packed[texture].data()[i][static_cast<int>(channel)] = static_cast<std::uint8_t>(std::nearbyint(scaled));
        }
      }
    });
  }
  return packed;
}

}  // namespace isolume
