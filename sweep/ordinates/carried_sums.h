// Carried rays (carried_rays.h) over a whole set of ordinates.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "carried_rays.h"
#include "sample_layers.h"
#include "surface_rays.h"

namespace isolume {

/// layersOfSamples() for each axis.
std::array<SampleLayers, 3> orderSamples(const std::vector<NearSample>& samples, glm::ivec3 size);

/// By foot, what CarriedTally says with both scales 1, to 2^-30 of the largest possible sum; for `length` light and
/// then length. `rays` of refinement 1; `values` of the samples that `layers` orders. Threaded.
std::vector<float> sumCarried(const SurfaceRays& rays, const std::vector<Ordinate>& ordinates,
                              const std::array<SampleLayers, 3>& layers, const std::vector<std::uint8_t>& values,
                              CarriedTally::Kind kind, double meanFreePath);

}  // namespace isolume
