#include "src/jobs/screen_light.h"

#include <cmath>
#include <utility>

#include "src/jobs/environment_map.h"

namespace isolume {

std::shared_ptr<const SkyCube> screenSky(const LightingRequest& request, const EnvironmentMap* map,
                                         glm::dmat3 worldFromAxes) {
  if (isPlain(request)) return nullptr;
  const auto exposure = static_cast<float>(std::exp2(request.exposure));
  auto sky = std::make_shared<SkyCube>();
  if (request.lights.empty() && !map) addEvenSky(*sky, glm::vec3(exposure));
  for (const LightRequest& light : request.lights) {
    const glm::vec3 color = exposure * light.color;
    if (light.kind == LightKind::sky) addEvenSky(*sky, color);
    if (light.kind == LightKind::gradient)
      addBandedSky(*sky, light.bands[0] * color, light.bands[1] * color, light.bands[2] * color, worldFromAxes);
  }
  if (map) addMappedSky(*sky, map->size, map->radiance, request.rotationDegrees.value_or(0), exposure, worldFromAxes);
  return sky;
}

SweptLighting sweepForScreen(const OrdinateOptions& ordinates, const SweptScene& scene) {
  const SurfaceRays rays(scene.surface.level.view(), scene.swept.distance.view(), ordinates.refinement);
  SweptLighting swept;
  swept.fields.push_back({rays.surface().spread(opennessOf(blockedShares(rays, ordinates.ordinates))), 1});
  for (SurfaceField& component : sweepBentNormals(rays, ordinates.ordinates, glm::dmat3(1)))
    swept.fields.push_back({std::move(component), 1});
  swept.uses.resize(swept.fields.size());
  return swept;
}

}  // namespace isolume
