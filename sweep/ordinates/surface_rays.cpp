#include "surface_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <stdexcept>
#include <utility>

#include "foot_sums.h"

namespace isolume {
namespace {

// How many feet may be kept: to make them each time that an order reads them is a fifth of a sweep of 128 ordinates.
// They may take what is left of two bytes per voxel, or of 16 MiB where that is more: 5/8 byte per voxel goes to the
// marks and the lattice, 3/8 to the state of rays and other small things, and 40 per foot to an order and its sums.
std::size_t mostKept(std::size_t voxels, std::size_t feet) {
  constexpr std::size_t kFew = std::size_t{16} << 20;
  const std::size_t room = std::max(2 * voxels, kFew), taken = voxels + 40 * feet;
  return room > taken ? (room - taken) / sizeof(SurfaceFoot) : 0;
}

double largestTotal(const std::vector<Ordinate>& ordinates, int channels) {
  double largest = 0;
  for (int c = 0; c < channels; ++c) {
    double total = 0;
    for (const Ordinate& each : ordinates) total += std::abs(each.value[static_cast<std::size_t>(c)]);
    largest = std::max(largest, total);
  }
  return largest;
}

}  // namespace

std::vector<RayGroup> rayGroups(int axis, const std::vector<Ordinate>& ordinates, glm::dvec3 cell, int most) {
  const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
  std::vector<RayGroup> groups;
  for (const int towards : {1, -1}) {
    std::vector<RayDirection> all;
    for (const Ordinate& ordinate : ordinates) {
      const glm::dvec3 direction = ordinate.direction, steps = direction / cell, size = glm::abs(steps);
      const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      if (longest != axis || (steps[axis] > 0) != (towards > 0)) continue;
      all.push_back({static_cast<float>(direction[axes.bit]), static_cast<float>(direction[axes.row]),
                     static_cast<float>(direction[axes.layer]), steps[axes.bit] / steps[axes.layer],
                     steps[axes.row] / steps[axes.layer], static_cast<float>(1 / size[axis]), ordinate.value});
    }
    // Of equal size, so that no thread waits for a last full one while another sweeps a rest.
    const std::size_t count = (all.size() + static_cast<std::size_t>(most) - 1) / static_cast<std::size_t>(most);
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = [&](std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k * all.size() / count); };
      groups.push_back({towards, {at(i), at(i + 1)}});
    }
  }
  return groups;
}

SurfaceRays::SurfaceRays(GridView<const float> level, GridView<const float> distance, int refinement, Orders orders)
    : spacing_(level.spacing),
      surface_(level, distance),
      lattice_(makeSolidLattice(level, surface_.solid(), refinement, &distance)) {
  for (int axis = 0; axis < 3; ++axis) {
    const LatticeLayers layers = layersOf(lattice_, spacing_, axis);
    if (voxelCount({layers.words * kWordBits, layers.rows + kMostBeyond, 1}) >= kMostLayerBits)
      throw std::length_error("openness: expected layers of fewer than 2^24 lattice points: take refinement 1");
  }
  keepFeet(orders == Orders::kept ? count() : mostKept(level.count(), count()));
  if (orders == Orders::remade) return;
  for (int axis = 0; axis < 3; ++axis) kept_.emplace_back(count()).sort(chunks(), lattice_, spacing_, axis);
  keepFeet(0);
}

// Of the first chunks, `most` at most.
void SurfaceRays::keepFeet(std::size_t most) {
  const FootChunks all = surface_.chunks();
  keptChunks_ = 0;
  while (keptChunks_ < all.chunks() && all.begin[keptChunks_ + 1] <= most) ++keptChunks_;
  feet_ = keptChunks_ == 0 ? nullptr : makeLargeArray<SurfaceFoot>(all.begin[keptChunks_]);
  all.copyFirst(keptChunks_, feet_.get());
}

// As they are kept, or made each time.
FootChunks SurfaceRays::chunks() const {
  FootChunks chunks = surface_.chunks();
  chunks.feet = [this, begin = chunks.begin, make = std::move(chunks.feet)](std::size_t chunk,
                                                                            std::vector<SurfaceFoot>& room) {
    return chunk < keptChunks_ ? feet_.get() + begin[chunk] : make(chunk, room);
  };
  return chunks;
}

SurfaceFeet SurfaceRays::takeSurface() && {
  lattice_ = {};
  kept_.clear();
  keepFeet(0);
  return std::move(surface_);
}

// The order for an axis: a kept one, or one that is made in `room`.
const RayPoints& SurfaceRays::ordered(int axis, RayPoints& room) const {
  if (!kept_.empty()) return kept_[static_cast<std::size_t>(axis)];
  room.sort(chunks(), lattice_, spacing_, axis);
  return room;
}

std::vector<std::int32_t> SurfaceRays::sumGroups(const std::vector<Ordinate>& ordinates, int channels, int most,
                                                 const GroupSweep& sweep) const {
  const std::size_t feet = count(), stride = feet + kRayPadding, all = static_cast<std::size_t>(channels);
  std::vector<std::int32_t> whole(feet * all, 0);
  RayPoints room(kept_.empty() ? feet : 0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<RayGroup> groups = rayGroups(axis, ordinates, cell(), most);
    const LatticeLayers layers = layersOf(lattice_, spacing_, axis);
    const RayPoints& points = ordered(axis, room);
    FootSums shared(stride * all);
    parallelFor(groups.size(), [&](std::size_t i) {
      std::vector<std::int32_t> own = shared.take();
      sweep(axis, layers, points, groups[i], static_cast<std::ptrdiff_t>(stride), own.data());
      shared.giveBack(std::move(own));
    });
    const std::uint32_t* foot = points.foot();
    forEachFoot(feet, [&](std::size_t i) {
      for (std::size_t c = 0; c < all; ++c) whole[c * feet + foot[i]] += shared.takeTotal(c * stride + i);
    });
  }
  return whole;
}

std::vector<float> SurfaceRays::sum(const std::vector<Ordinate>& ordinates, int channels, Count count) const {
  const double total = largestTotal(ordinates, channels);
  if (surface_.count() == 0 || total == 0)
    return std::vector<float>(surface_.count() * static_cast<std::size_t>(channels), 0);
  const auto scale = static_cast<float>(kLargestSum / total);
  int most = kRayGroup;
  for (int axis = 0; axis < 3; ++axis) most = std::min(most, raysAtATime(layersOf(lattice_, spacing_, axis)));
  const std::vector<std::int32_t> whole = sumGroups(
      ordinates, channels, most,
      [&](int, const LatticeLayers& layers, const RayPoints& points, const RayGroup& group, std::ptrdiff_t stride,
          std::int32_t* own) {
        sweepRays(
            layers, group.towards, group.directions, points,
            {.channels = channels, .visible = count == Count::visible, .scale = scale, .stride = stride, .sums = own});
      });
  std::vector<float> sums(whole.size());
  forEachFoot(sums.size(), [&](std::size_t i) { sums[i] = static_cast<float>(whole[i] / static_cast<double>(scale)); });
  return sums;
}

}  // namespace isolume
