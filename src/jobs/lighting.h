// The lights of a picture, swept.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "raymarch/camera.h"
#include "raymarch/light_field.h"
#include "src/jobs/light_request.h"
#include "src/jobs/surface.h"
#include "sweep/ordinates/light_sweeps.h"
#include "sweep/ordinates/openness_sweep.h"
#include "sweep/transport/openness_transport.h"

namespace isolume {

struct EnvironmentMap;

/// What the renderer takes, exposure applied. Fields as of surface_field.h: 2 bytes per number.
struct SweptLighting {
  std::vector<SweptLight> fields;
  std::vector<LightField> uses;   ///< of each field
  std::vector<glm::vec3> colors;  ///< of each field
  std::vector<HardSun> suns;
  glm::vec3 head{0};  ///< colour of the head light
  std::optional<SweptLight> thickness;
  std::optional<std::array<SurfaceField, 3>> bent;
  std::size_t bytes() const;
};

/// Everything by ordinates. The scene has its level and distances. `map` if the request names one.
SweptLighting sweepLighting(const LightingRequest& request, const OrdinateOptions& ordinates, const EnvironmentMap* map,
                            const SweptScene& scene, const Camera& camera, glm::vec3 albedo);

/// The same for an even white sky, and nothing else, by ordinates that are swept as light.
SweptLighting sweepEvenSky(const TransportOptions& transport, double exposure, const SweptScene& scene);

}  // namespace isolume
