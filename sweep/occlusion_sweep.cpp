#include "occlusion_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "closest/closest_distance.h"
#include "parallel.h"
#include "surface_start.h"
#include "wavefront.h"

namespace isolume {
namespace {

float smallestOf(glm::dvec3 spacing) { return static_cast<float>(std::min({spacing.x, spacing.y, spacing.z})); }

// From the sweep's units and tags to world units; what was never reached is infinitely far.
void finishDistance(GridView<float> distance) {
  const float smallestSpacing = smallestOf(distance.spacing);
  const std::size_t perPlane = voxelCount({distance.size.x, distance.size.y, 1});
  parallelFor(static_cast<std::size_t>(distance.size.z), [&](std::size_t z) {
    float* plane = distance.data + z * perPlane;
    for (std::size_t i = 0; i < perPlane; ++i) {
      const float value = withFixedBit(plane[i], false);
      const float world = value * smallestSpacing;
      plane[i] =
          std::abs(value) < kUnsetDistance ? world : std::copysign(std::numeric_limits<float>::infinity(), value);
    }
  });
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

// The other way: every distance fixed, but for those that are infinite.
Grid<float> fixedDistance(GridView<const float> distance) {
  Grid<float> fixed(distance.size, distance.spacing, distance.origin);
  const float perSmallest = 1 / smallestOf(distance.spacing);
  const std::size_t perPlane = voxelCount({distance.size.x, distance.size.y, 1});
  parallelFor(static_cast<std::size_t>(distance.size.z), [&](std::size_t z) {
    for (std::size_t i = z * perPlane; i < (z + 1) * perPlane; ++i) {
      const float value = distance.data[i];
      const bool known = std::isfinite(value);
      const float magnitude = known ? std::max(std::abs(value) * perSmallest, kSmallestDistance) : kUnsetDistance;
      fixed.data()[i] = std::copysign(withFixedBit(magnitude, known), value);
    }
  });
  return fixed;
}

// Eight sweeps in place, and what of their light is to be kept.
OctantVisibility sweepRound(WavefrontSweeper& sweeper, GridView<float> distance, VisibilityStorage storage) {
  OctantVisibility visibility;
  std::array<Grid<std::uint8_t>, 4> channels;
  for (std::size_t s = 0; s < kOctants.size(); ++s) {
    VisibilityTarget target;
    if (storage == VisibilityStorage::rgba8) {
      channels[s % 4] = Grid<std::uint8_t>(distance.size);
      target.as8 = channels[s % 4].data();
    } else if (storage == VisibilityStorage::float32) {
      visibility.octants[s] = Grid<float>(distance.size, distance.spacing, distance.origin);
      target.asFloat = visibility.octants[s].data();
    }
    sweeper.sweep(kOctants[s], distance.data, target);
    if (storage == VisibilityStorage::rgba8 && s % 4 == 3) visibility.packed[s / 4] = interleave(channels, distance);
  }
  return visibility;
}

}  // namespace

OctantVisibility sweepVisibility(GridView<const float> distance, VisibilityStorage storage) {
  Grid<float> fixed = fixedDistance(distance);
  WavefrontSweeper sweeper(distance.size, makeSweepMetric(distance.spacing));
  return sweepRound(sweeper, fixed.view(), storage);
}

SweptFields sweepOcclusion(GridView<const float> level, const SweepOptions& options) {
  SweptFields fields;
  if (options.solver == DistanceSolver::closest) {
    fields.distance = closestDistance(level);
    if (options.visibility != VisibilityStorage::none)
      fields.visibility = sweepVisibility(fields.distance.view(), options.visibility);
    return fields;
  }
  fields.distance = Grid<float>(level.size, level.spacing, level.origin);
  startDistance(level, fields.distance.view(), options.start);
  WavefrontSweeper sweeper(level.size, makeSweepMetric(level.spacing));
  fields.visibility = sweepRound(sweeper, fields.distance.view(), options.visibility);
  for (int round = 1; round < options.rounds; ++round)
    sweepRound(sweeper, fields.distance.view(), VisibilityStorage::none);
  finishDistance(fields.distance.view());
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
