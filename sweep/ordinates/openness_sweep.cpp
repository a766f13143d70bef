#include "openness_sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "ordinate_set.h"
#include "ray_points.h"
#include "sheared_rays.h"
#include "solid_lattice.h"
#include "surface_feet.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr double kLargestOpenness = 65535;
constexpr std::size_t kChunk = 1 << 15;

template <class Visit>
void forEachParallel(std::size_t count, const Visit& visit) {
  parallelFor((count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    for (std::size_t i = chunk * kChunk; i < std::min((chunk + 1) * kChunk, count); ++i) visit(i);
  });
}

// Directions of one axis and sense that are swept together.
struct RayGroup {
  int towards = 1;
  std::vector<RayDirection> directions;
};

// Directions whose rays cross most layers of `axis`, in groups.
std::vector<RayGroup> groupsOf(int axis, const std::vector<glm::dvec3>& directions, glm::dvec3 cell) {
  const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
  std::vector<RayGroup> groups;
  for (const int towards : {1, -1}) {
    std::vector<RayDirection> all;
    for (const glm::dvec3& direction : directions) {
      const glm::dvec3 steps = direction / cell, size = glm::abs(steps);
      const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      if (longest != axis || (steps[axis] > 0) != (towards > 0)) continue;
      all.push_back({static_cast<float>(direction[axes.bit]), static_cast<float>(direction[axes.row]),
                     static_cast<float>(direction[axes.layer]), steps[axes.bit] / steps[axes.layer],
                     steps[axes.row] / steps[axes.layer], static_cast<float>(1 / size[axis])});
    }
    // Of equal size, so that no thread waits for a last full one while another sweeps a rest.
    const std::size_t count = (all.size() + kRayGroup - 1) / kRayGroup;
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = [&](std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k * all.size() / count); };
      groups.push_back({towards, {at(i), at(i + 1)}});
    }
  }
  return groups;
}

// Sums over points that groups add to, one array per group at work. Integers: the order of additions does not matter.
class SharedSums {
 public:
  explicit SharedSums(std::size_t count) : count_(count) {}

  std::vector<std::int32_t> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::vector<std::int32_t>(count_, 0);
    std::vector<std::int32_t> sums = std::move(idle_.back());
    idle_.pop_back();
    return sums;
  }
  void giveBack(std::vector<std::int32_t> sums) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(sums));
  }
  /// Of point i over all arrays, which start anew.
  std::int32_t takeTotal(std::size_t i) {
    std::int32_t total = 0;
    for (std::vector<std::int32_t>& sums : idle_) {
      total += sums[i];
      sums[i] = 0;
    }
    return total;
  }

 private:
  std::size_t count_;
  std::mutex mutex_;
  std::vector<std::vector<std::int32_t>> idle_;
};

}  // namespace

Grid<std::uint16_t> sweepOpenness(GridView<const float> level, GridView<const float> distance,
                                  const OrdinateOptions& options) {
  assert(options.ordinates >= kLeastOrdinates && options.ordinates <= kMostOrdinates);
  assert(options.refinement >= 1 && options.refinement <= kMostRefinement);
  Grid<std::uint16_t> result(level.size, level.spacing, level.origin);
  const SurfaceFeet surface(level, distance);
  const std::vector<SurfaceFoot>& feet = surface.feet();
  std::vector<std::int32_t> blocked(feet.size(), 0);
  // The sum of clamped cosines over all directions is K / 4 for any normal, to a fraction of one direction.
  const double open = options.ordinates / 4.0;
  const auto scale = static_cast<float>((1 << 30) / (open + 1));
  if (!feet.empty()) {
    const SolidLattice lattice = makeSolidLattice(level, surface.solid(), options.refinement);
    const std::vector<glm::dvec3> directions = ordinateDirections(options.ordinates);
    RayPoints points(feet.size());
    SharedSums shared(feet.size() + kRayPadding);
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<RayGroup> groups =
          groupsOf(axis, directions, level.spacing / static_cast<double>(lattice.refinement));
      points.sort(feet, lattice, level.spacing, axis);
      const LatticeLayers layers = layersOf(lattice, level.spacing, axis);
      if (voxelCount({layers.words * kWordBits, layers.rows + 1, 1}) >= kMostLayerBits)
        throw std::length_error("openness: expected layers of fewer than 2^24 lattice points: take refinement 1");
      parallelFor(groups.size(), [&](std::size_t i) {
        std::vector<std::int32_t> sums = shared.take();
        sweepRays(layers, groups[i].towards, groups[i].directions, points, scale, sums.data());
        shared.giveBack(std::move(sums));
      });
      forEachParallel(feet.size(), [&](std::size_t i) { blocked[points.foot()[i]] += shared.takeTotal(i); });
    }
  }
  std::vector<std::uint16_t> openness(feet.size());
  forEachParallel(feet.size(), [&](std::size_t i) {
    const double share = blocked[i] / (static_cast<double>(scale) * open);
    openness[i] = static_cast<std::uint16_t>(std::lround(std::clamp(1 - share, 0.0, 1.0) * kLargestOpenness));
  });
  surface.spread(openness, result.view());
  return result;
}

}  // namespace isolume
