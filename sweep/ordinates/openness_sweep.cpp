#include "openness_sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "foot_sums.h"
#include "ordinate_set.h"

namespace isolume {

Grid<std::uint16_t> sweepOpenness(const SurfaceRays& rays, int ordinates) {
  assert(ordinates >= kLeastOrdinates && ordinates <= kMostOrdinates);
  constexpr double kLargestOpenness = 65535;
  std::vector<Ordinate> sky;
  for (const glm::dvec3& direction : ordinateDirections(ordinates)) sky.push_back({direction});
  const std::vector<float> blocked = rays.sum(sky, 1, SurfaceRays::Count::blocked);
  // The sum of clamped cosines over all directions is K / 4 for any normal, to a fraction of one direction.
  const double open = ordinates / 4.0;
  std::vector<std::uint16_t> openness(rays.count());
  forEachFoot(rays.count(), [&](std::size_t i) {
    openness[i] =
        static_cast<std::uint16_t>(std::lround(std::clamp(1 - blocked[i] / open, 0.0, 1.0) * kLargestOpenness));
  });
  return rays.surface().spread(openness);
}

Grid<std::uint16_t> sweepOpenness(GridView<const float> level, GridView<const float> distance,
                                  const OrdinateOptions& options) {
  assert(options.refinement >= 1 && options.refinement <= kMostRefinement);
  return sweepOpenness(SurfaceRays(level, distance, options.refinement), options.ordinates);
}

}  // namespace isolume
