#include "check_settings.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "gpu_error.h"
#include "light_uniforms.h"

namespace isolume {

void checkSettings(const RenderSettings& settings, const SceneTextures& scene) {
  if (!scene.level) throw GpuError("render: expected an uploaded scene, found none");
  if (settings.size.x < 1 || settings.size.y < 1) {
    throw GpuError(
        fmt::format("image: expected a size of at least 1x1, found {}x{}", settings.size.x, settings.size.y));
  }
  if (settings.samples < 1)
    throw GpuError(fmt::format("image: expected at least 1 sample, found {}", settings.samples));
  if (!(settings.gamma > 0)) throw GpuError(fmt::format("image: expected a gamma above 0, found {}", settings.gamma));
  if (!(settings.occlusionOffsetVoxels >= 0)) {
    throw GpuError(fmt::format("image: expected octants read at least 0 voxels above the surface, found {}",
                               settings.occlusionOffsetVoxels));
  }
  if (settings.normals == NormalSource::distance && scene.distance.name() == 0) {
    throw GpuError("render: expected a distance texture for normals from the distance, found a scene without it");
  }
  if (settings.openPlaneTerms && settings.geometryTerm != GeometryTerm::front)
    throw GpuError(
        "octants: expected the front's geometry terms to divide by an open plane's, found those of both sides");
  if (settings.screen) return;
  if (settings.shading == Shading::octants && !scene.hasOctants()) {
    throw GpuError("render: expected octants for shading by them, found a scene without them");
  }
  for (std::size_t s = 0; s < settings.octantLight.size(); ++s)
    for (int color = 0; color < 3; ++color) {
      const float light = settings.octantLight[s][color];
      if (!(light >= 0 && std::isfinite(light)))
        throw GpuError(
            fmt::format("octant {}: expected a finite light of at least 0, found {}", kOctants[s].name, light));
    }
  if (settings.shading == Shading::lights) {
    if (settings.suns.size() > shader::kMostSuns)
      throw GpuError(
          fmt::format("render: expected at most {} suns, found {}", shader::kMostSuns, settings.suns.size()));
    for (const HardSun& sun : settings.suns)
      if (!(glm::length(sun.direction) > 0))
        throw GpuError("render: expected a direction towards each sun, found 0,0,0");
    if (!settings.lightColors.empty() && settings.lightColors.size() != scene.lights.size())
      throw GpuError(fmt::format("render: expected a colour for each of {} light fields, found {}", scene.lights.size(),
                                 settings.lightColors.size()));
  }
}

}  // namespace isolume
