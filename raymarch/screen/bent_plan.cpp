#include "raymarch/screen/bent_plan.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "raymarch/screen/point_sets.h"
#include "raymarch/screen/sky_convolution.h"

namespace isolume {

std::vector<glm::vec4> bentSamples(int samples) {
  const std::vector<glm::dvec2> disk = poissonDisk(samples);
  const std::vector<double> strata = shuffledStrata(samples);
  std::vector<glm::vec4> directions;
  for (std::size_t i = 0; i < disk.size(); ++i) {
    // Lambert's map: equal areas of the disk and of the hemisphere.
    const double height = 1 - glm::dot(disk[i], disk[i]);
    directions.emplace_back(glm::dvec4(disk[i] * std::sqrt(1 + height), height, std::cbrt(strata[i])));
  }
  return directions;
}

ScreenPlan planBent(const ScreenOcclusion& settings) {
  ScreenPlan plan;
  const bool cone = hasCone(settings.bent);
  plan.bentLight = settings.sky || (cone && settings.geometricTerm);
  const bool bent = plan.bentLight && settings.bent != BentLight::none;
  if (plan.bentLight) plan.sky.cones = cone ? kConeAngles : 1;
  switch (settings.bentFrom) {
    case BentSource::crytek2d:
      plan.program = bent ? "screen_bent_disk" : "screen_closed_disk";
      plan.samples = bentSamples(settings.samples);
      break;
    case BentSource::crytek3d:
      plan.program = bent ? "screen_bent_ball" : "screen_closed_ball";
      plan.samples = bentSamples(settings.samples);
      break;
    case BentSource::hbao:
      plan.program = bent ? "screen_bent_hbao" : "screen_hbao";
      plan.march = marchCounts(ScreenEstimator::hbao, settings.samples);
      break;
    case BentSource::sweep:
      plan.program = bent ? "screen_swept" : "screen_closed_swept";
      break;
  }
  return plan;
}

}  // namespace isolume
