#include "carried_sums.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "foot_sums.h"

namespace isolume {
namespace {

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
  const std::size_t feet = rays.count();
  const int channels = length ? 2 : 1;
  double total = 0;
  for (const Ordinate& each : ordinates) total += std::abs(each.value[0]);
  std::vector<float> sums(feet * static_cast<std::size_t>(channels), 0);
  if (feet == 0 || total == 0) return sums;
  const double longest = glm::length(glm::dvec3(rays.lattice().size) * rays.spacing());
  const CarriedTally tally{.kind = kind,
                           .scale = static_cast<float>(kLargestSum / (total * (length ? 1 : kLargestCarried))),
                           .lengthScale = static_cast<float>(kLargestSum / (total * longest)),
                           .meanFreePath = static_cast<float>(meanFreePath)};
  const std::vector<std::int32_t> whole =
      rays.sumGroups(ordinates, channels, kCarriedGroup,
                     [&](int axis, const LatticeLayers& lattice, const RayPoints& points, const RayGroup& group,
                         std::ptrdiff_t stride, std::int32_t* own) {
                       CarriedTally to = tally;
                       to.stride = stride;
                       to.sums = own;
                       sweepCarriedRays(lattice, group.towards, group.directions, points,
                                        layers[static_cast<std::size_t>(axis)], values, to);
                     });
  forEachFoot(sums.size(), [&](std::size_t i) {
    sums[i] = static_cast<float>(whole[i] / static_cast<double>(i < feet ? tally.scale : tally.lengthScale));
  });
  return sums;
}

}  // namespace isolume
