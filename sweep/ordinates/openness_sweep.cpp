#include "openness_sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "foot_sums.h"
#include "sky_ordinates.h"

namespace isolume {

std::vector<float> blockedShares(const SurfaceRays& rays, int ordinates) {
  assert(ordinates >= kLeastOrdinates && ordinates <= kMostOrdinates);
  return rays.sum(uniformSky(ordinates), 1, SurfaceRays::Count::blocked);
}

std::vector<std::uint16_t> opennessOf(const std::vector<float>& blockedShares) {
  constexpr float kLargestOpenness = 65535;
  std::vector<std::uint16_t> openness(blockedShares.size());
  forEachFoot(openness.size(), [&](std::size_t i) {
    openness[i] =
        static_cast<std::uint16_t>(std::lround(std::clamp(1 - blockedShares[i], 0.0F, 1.0F) * kLargestOpenness));
  });
  return openness;
}

SurfaceField sweepOpenness(GridView<const float> level, GridView<const float> distance,
                           const OrdinateOptions& options) {
  assert(options.refinement >= 1 && options.refinement <= kMostRefinement);
  SurfaceRays rays(level, distance, options.refinement, SurfaceRays::Orders::remade);
  const std::vector<std::uint16_t> openness = opennessOf(blockedShares(rays, options.ordinates));
  return std::move(rays).takeSurface().spread(openness);
}

}  // namespace isolume
