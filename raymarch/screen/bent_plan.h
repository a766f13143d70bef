// What klehm11 is given: its program, its samples, and what of the sky it looks up. Pure.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "raymarch/screen/screen_plan.h"

namespace isolume {

/// Under an even sky light is openness whatever the bent normal, and that is drawn alone, by the program without one;
/// only the geometric term changes it.
ScreenPlan planBent(const ScreenOcclusion& settings);

/// Directions evenly over the hemisphere about z, as unit vectors, and distances in (0, 1) that with them fill the half
/// ball evenly (shaders/screen/bent_points.glsl).
std::vector<glm::vec4> bentSamples(int samples);

}  // namespace isolume
