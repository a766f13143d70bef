#include "carried_sums.h"

#include <cassert>
#include <glm/geometric.hpp>

#include "foot_sums.h"

namespace isolume {
namespace {

constexpr double kLargestSum = 1 << 30;

/// At work at a time: what a layer holds is unpacked once for all of them (eight for two: .63 of the time).
constexpr int kCarriedGroup = 8;

}  // namespace

std::array<SampleLayers, 3> orderSamples(const std::vector<NearSample>& samples, glm::ivec3 size) {
  std::array<SampleLayers, 3> layers;
  parallelFor(layers.size(),
              [&](std::size_t axis) { layers[axis] = layersOfSamples(samples, size, static_cast<int>(axis)); });
  return layers;
}

std::vector<float> sumCarried(const SurfaceRays& rays, const std::vector<Ordinate>& ordinates,
                              const std::array<SampleLayers, 3>& layers, const std::vector<std::uint8_t>& values,
                              CarriedTally::Kind kind, double meanFreePath) {
  assert(rays.lattice().refinement == 1);
  const bool length = kind == CarriedTally::Kind::length;
  const std::size_t feet = rays.count(), stride = feet + kRayPadding, channels = length ? 2 : 1;
  double total = 0;
  for (const Ordinate& each : ordinates) total += std::abs(each.value[0]);
  std::vector<float> sums(feet * channels, 0);
  if (feet == 0 || total == 0) return sums;
  const double longest = glm::length(glm::dvec3(rays.lattice().size) * rays.spacing());
  CarriedTally tally{.kind = kind,
                     .scale = static_cast<float>(kLargestSum / (total * (length ? 1 : kLargestCarried))),
                     .lengthScale = static_cast<float>(kLargestSum / (total * longest)),
                     .meanFreePath = static_cast<float>(meanFreePath),
                     .stride = static_cast<std::ptrdiff_t>(stride)};
  FootSums shared(stride * channels);
  std::vector<std::int32_t> whole(sums.size(), 0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<RayGroup> groups = rayGroups(axis, ordinates, rays.cell(), kCarriedGroup);
    const LatticeLayers lattice = layersOf(rays.lattice(), rays.spacing(), axis);
    parallelFor(groups.size(), [&](std::size_t i) {
      std::vector<std::int32_t> own = shared.take();
      CarriedTally to = tally;
      to.sums = own.data();
      sweepCarriedRays(lattice, groups[i].towards, groups[i].directions, rays.points(axis),
                       layers[static_cast<std::size_t>(axis)], values, to);
      shared.giveBack(std::move(own));
    });
    const std::uint32_t* foot = rays.points(axis).foot();
    forEachFoot(feet, [&](std::size_t i) {
      for (std::size_t c = 0; c < channels; ++c) whole[c * feet + foot[i]] += shared.takeTotal(c * stride + i);
    });
  }
  forEachFoot(sums.size(), [&](std::size_t i) {
    sums[i] = static_cast<float>(whole[i] / static_cast<double>(i < feet ? tally.scale : tally.lengthScale));
  });
  return sums;
}

}  // namespace isolume
