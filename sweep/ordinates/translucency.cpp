#include "translucency.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "carried_sums.h"
#include "foot_sums.h"
#include "sky_ordinates.h"

namespace isolume {

double meanFreePath(double opacity, double smallestSpacing) {
  assert(opacity > 0 && opacity < 1);
  return -smallestSpacing / std::log1p(-opacity);
}

Translucency sweepTranslucency(const SurfaceRays& rays, GridView<const float> distance,
                               const std::vector<Ordinate>& sky, double meanFreePath) {
  std::vector<NearSample> samples = rays.surface().nearSamples(true);
  const std::vector<NearSample> outside = rays.surface().nearSamples(false);
  samples.insert(samples.end(), outside.begin(), outside.end());
  const double voxel = smallestSpacing(distance.spacing);
  std::vector<std::uint8_t> shares(samples.size());
  // Where the surface cuts a voxel, as [Singh10] Eq. 7.
  forEachFoot(samples.size(), [&](std::size_t i) {
    const double depth = -distance(samples[i].at.x, samples[i].at.y, samples[i].at.z) / voxel;
    shares[i] = static_cast<std::uint8_t>(std::lround(std::clamp(depth + 0.5, 0.0, 1.0) * kSolidShare));
  });
  const std::vector<float> sums =
      sumCarried(rays, sky, orderSamples(samples, distance.size), shares, CarriedTally::Kind::length, meanFreePath);
  double mean = 0;
  for (const Ordinate& each : sky) mean += each.value[0] / 4;
  std::vector<float> thickness(sums.begin() + static_cast<std::ptrdiff_t>(rays.count()), sums.end());
  for (float& each : thickness) each = static_cast<float>(each / mean);
  return {lightOfFeet(rays.surface(), sums.data()), lightOfFeet(rays.surface(), thickness.data())};
}

SweptLight sweepThickness(const SurfaceRays& rays, GridView<const float> distance, int ordinates) {
  // Any free path will do: only lengths are wanted.
  return sweepTranslucency(rays, distance, uniformSky(ordinates), smallestSpacing(distance.spacing)).thickness;
}

}  // namespace isolume
