#include "occlusion_sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "band_cells.h"
#include "closest/closest_distance.h"
#include "distance_sweeper.h"
#include "light_sweeper.h"
#include "parallel.h"
#include "surface_start.h"

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

// Interleaves four byte planes to one RGBA8 grid and frees them.
Grid<glm::u8vec4> interleave(std::array<Grid<std::uint8_t>, 4>& channels, GridView<const float> like) {
  Grid<glm::u8vec4> packed(like.size, like.spacing, like.origin);
  const std::size_t perPlane = voxelCount({like.size.x, like.size.y, 1});
  parallelFor(static_cast<std::size_t>(like.size.z), [&](std::size_t z) {
    const std::uint8_t* r = channels[0].data() + z * perPlane;
    const std::uint8_t* g = channels[1].data() + z * perPlane;
    const std::uint8_t* b = channels[2].data() + z * perPlane;
    const std::uint8_t* a = channels[3].data() + z * perPlane;
    glm::u8vec4* out = packed.data() + z * perPlane;
    for (std::size_t i = 0; i < perPlane; ++i) out[i] = glm::u8vec4(r[i], g[i], b[i], a[i]);
  });
  for (Grid<std::uint8_t>& channel : channels) channel = {};
  return packed;
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

// The octants of a storage while they are swept, two at a time.
class OctantWriter {
 public:
  OctantWriter(GridView<const float> like, VisibilityStorage storage, const OctantIntensities& intensities)
      : like_(like), storage_(storage), shares_(sharesOf(intensities)) {
    if (storage != VisibilityStorage::combined) return;
    for (Grid<float>* grid : {&pair_[0], &pair_[1], &sum_}) *grid = Grid<float>(like.size);
  }

  std::array<VisibilityTarget, 2> targets(int pair) {
    std::array<VisibilityTarget, 2> targets;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t s = 2 * static_cast<std::size_t>(pair) + k;
      if (storage_ == VisibilityStorage::rgba8) {
        channels_[s % 4] = Grid<std::uint8_t>(like_.size);
        targets[k].as8 = channels_[s % 4].data();
      } else if (storage_ == VisibilityStorage::float32) {
        visibility_.octants[s] = Grid<float>(like_.size, like_.spacing, like_.origin);
        targets[k].asFloat = visibility_.octants[s].data();
      } else if (storage_ == VisibilityStorage::combined) {
        targets[k].asFloat = pair_[k].data();
      }
    }
    return targets;
  }
  /// After the pair has been swept.
  void finish(int pair) {
    const bool gridIsComplete = pair % 2 == 1;
    if (storage_ == VisibilityStorage::rgba8 && gridIsComplete)
      visibility_.packed[static_cast<std::size_t>(pair) / 2] = interleave(channels_, like_);
    if (storage_ == VisibilityStorage::combined) addPair(pair);
  }
  OctantVisibility take() { return std::move(visibility_); }

 private:
  // After the last pair the sum is rounded and all that it took is freed.
  void addPair(int pair) {
    const bool first = pair == 0, last = pair == kOctantPairs - 1;
    if (last) visibility_.combined = Grid<std::uint16_t>(like_.size, like_.spacing, like_.origin);
    const float share0 = shares_[static_cast<std::size_t>(2 * pair)];
    const float share1 = shares_[static_cast<std::size_t>(2 * pair + 1)];
    const std::size_t perPlane = voxelCount({like_.size.x, like_.size.y, 1});
    parallelFor(static_cast<std::size_t>(like_.size.z), [&](std::size_t z) {
      for (std::size_t i = z * perPlane; i < (z + 1) * perPlane; ++i) {
        const float both = share0 * pair_[0].data()[i] + share1 * pair_[1].data()[i];
        const float sum = first ? both : sum_.data()[i] + both;
        if (last)
          visibility_.combined.data()[i] = static_cast<std::uint16_t>(std::nearbyint(65535 * std::min(sum, 1.0F)));
        else
          sum_.data()[i] = sum;
      }
    });
    if (last) pair_ = {}, sum_ = {};
  }

  GridView<const float> like_;
  VisibilityStorage storage_;
  OctantIntensities shares_;
  OctantVisibility visibility_;
  std::array<Grid<std::uint8_t>, 4> channels_;
  std::array<Grid<float>, 2> pair_;
  Grid<float> sum_;
};

// Start values are made as the first sweep comes to a tile, and world units as the last leaves it.
SweptFields sweepWholeDomain(GridView<const float> level, const SweepOptions& options) {
  SweptFields fields;
  fields.distance = Grid<float>(level.size, level.spacing, level.origin);
  const GridView<float> distance = fields.distance.view();
  const auto smallest = static_cast<float>(smallestSpacing(level.spacing));
  const auto rowOf = [&](int y, int z) { return distance.data + z * distance.strideZ() + y * distance.strideY(); };
  const RowHook start = [&](int y, int z) { startRow(level, options.start, kUnsetDistance, y, z, rowOf(y, z)); };
  const RowHook finish = [&](int y, int z) { finishRow(rowOf(y, z), level.size.x, smallest); };
  const bool once = options.rounds == 1;

  DistanceSweeper sweeper(distance, makeSweepMetric(level.spacing, options.opacity));
  OctantWriter octants(distance, options.visibility, options.intensities);
  for (int pair = 0; pair < kOctantPairs; ++pair) {
    const bool last = pair == kOctantPairs - 1;
    sweeper.sweepPair(pair, octants.targets(pair), pair == 0 ? start : RowHook(), last && once ? finish : RowHook());
    octants.finish(pair);
  }
  fields.visibility = octants.take();
  if (once) return fields;
  for (int round = 1; round < options.rounds; ++round)
    if (!sweeper.sweepRound()) break;
  parallelFor(static_cast<std::size_t>(level.size.z), [&](std::size_t z) {
    for (int y = 0; y < level.size.y; ++y) finish(y, static_cast<int>(z));
  });
  return fields;
}

// Values start at the bound in place of unset: what they come to below it is the same (upwind_update-inl.h).
Grid<float> sweepBand(GridView<const float> level, const SweepOptions& options) {
  Grid<float> grid(level.size, level.spacing, level.origin);
  const GridView<float> distance = grid.view();
  const auto smallest = static_cast<float>(smallestSpacing(level.spacing));
  const auto bound = static_cast<float>(options.bandVoxels + 1);
  const auto rowOf = [&](int y, int z) { return distance.data + z * distance.strideZ() + y * distance.strideY(); };

  BandCells cells(level.size);
  parallelFor(static_cast<std::size_t>(cells.layers()), [&](std::size_t layer) {
    const int first = static_cast<int>(layer) * BandCells::kCell.z;
    for (int z = first; z < std::min(first + BandCells::kCell.z, level.size.z); ++z)
      for (int y = 0; y < level.size.y; ++y)
        if (startRow(level, options.start, bound, y, z, rowOf(y, z))) cells.markRow(y, z, rowOf(y, z));
  });
  cells.grow(level.spacing / static_cast<double>(smallest), bound);

  DistanceSweeper sweeper(distance, makeSweepMetric(level.spacing));
  const TileGrid& tiles = sweeper.tiles();
  std::vector<std::vector<TileSpan>> spans(tiles.count());
  parallelFor(static_cast<std::size_t>(tiles.layers), [&](std::size_t layer) {
    for (int block = 0; block < tiles.blocks; ++block)
      spans[tiles.index(block, static_cast<int>(layer))] = cells.spans(tiles, block, static_cast<int>(layer));
  });
  for (int round = 0; round < options.rounds; ++round)
    if (!sweeper.sweepRound(&spans)) break;

  parallelFor(static_cast<std::size_t>(tiles.layers), [&](std::size_t plane) {
    const int layer = static_cast<int>(plane);
    for (int block = 0; block < tiles.blocks; ++block) {
      if (spans[tiles.index(block, layer)].empty() && smallest == 1) continue;  // the bound needs no change
      tiles.forEachRow(block, layer, [&](int y, int z) { finishRow(rowOf(y, z), level.size.x, smallest); });
    }
  });
  return grid;
}

}  // namespace

OctantVisibility sweepVisibility(GridView<const float> distance, VisibilityStorage storage, float opacity,
                                 const OctantIntensities& intensities) {
  LightSweeper sweeper(distance, opacity);
  OctantWriter octants(distance, storage, intensities);
  for (int pair = 0; pair < kOctantPairs; ++pair) {
    sweeper.sweepPair(pair, octants.targets(pair));
    octants.finish(pair);
  }
  return octants.take();
}

SweptFields sweepOcclusion(GridView<const float> level, const SweepOptions& options) {
  if (sweptTogether(options)) return sweepWholeDomain(level, options);
  SweptFields fields;
  fields.distance = options.solver == DistanceSolver::closest
                        ? closestDistance(level, {.extent = options.extent, .bandVoxels = options.bandVoxels})
                        : sweepBand(level, options);
  if (options.visibility != VisibilityStorage::none)
    fields.visibility =
        sweepVisibility(fields.distance.view(), options.visibility, options.opacity, options.intensities);
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
