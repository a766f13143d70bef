// An estimator of shaders/screen in C++ on a scene of half-spaces, averaged over turns of its samples.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "raymarch/screen/screen_plan.h"
#include "screen/half_spaces.h"

namespace isolume::test {

/// By given samples. `view` leads away from the eye, in the scene's axes. Lengths are in radii: that of the settings
/// is 1. Estimators that march take many directions and steps, whatever the settings say.
double estimateBy(const ScreenOcclusion& settings, const std::vector<glm::vec4>& samples, const Blocks& blocks,
                  glm::dvec3 view, int turns, double roll);

/// By the samples of the settings.
double estimate(const ScreenOcclusion& settings, const Blocks& blocks, glm::dvec3 view, int turns = 32,
                double roll = 0);

/// Of klehm11, what it stores (shaders/screen/bent.glsl), in the scene's axes: the mean over turns.
glm::dvec4 estimateBend(const ScreenOcclusion& settings, const Blocks& blocks, glm::dvec3 view, int turns = 32,
                        double roll = 0);

/// Of ssdo and env-importance: light under the settings' sky, whose axes are the scene's, and openness.
glm::dvec4 estimateLight(const ScreenOcclusion& settings, const Blocks& blocks, glm::dvec3 view, int turns = 32,
                         double roll = 0);

}  // namespace isolume::test
