// Light for the screen-space estimators: the sky that was asked for, and bent normals by sweeps.
#pragma once

#include <glm/mat3x3.hpp>
#include <memory>

#include "raymarch/screen/sky_cube.h"
#include "src/jobs/lighting.h"

namespace isolume {

/// Skies, gradients and the map, with colours and exposure; none where light is an even white sky. `map` if the request
/// names one.
std::shared_ptr<const SkyCube> screenSky(const LightingRequest& request, const EnvironmentMap* map,
                                         glm::dmat3 worldFromAxes);

/// What klehm11 reads of the volume (raymarch/screen/screen_occlusion.h): openness, and the components of the mean open
/// direction along the grid's axes. Two sums over the ordinates; 8 bytes per voxel.
SweptLighting sweepForScreen(const OrdinateOptions& ordinates, const SweptScene& scene);

}  // namespace isolume
