// From settings to what a pass is given: its program, its samples and its counts. Pure.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "raymarch/screen/screen_occlusion.h"

namespace isolume {

/// What is looked up of the sky.
struct SkyNeeds {
  int cones = 0;  ///< of the convolved skies of sky_convolution.h so many, the widest: 0, 1 or kConeAngles
  bool radiance = false;
  bool draws = false;  ///< the table of sky_draws.h
  bool operator==(const SkyNeeds&) const = default;
};

struct ScreenPlan {
  std::string program;             ///< of program_variants.h
  std::vector<glm::vec4> samples;  ///< as the program's estimator reads them; none for those that march
  glm::ivec2 march{0};             ///< directions, and steps along each; 0 where there are samples
  bool moments = false;            ///< whether it reads the moments of the depths (depth_moments.h)
  bool bentLight = false;          ///< whether screen_bent_light looks its result up in the sky (bent_plan.h)
  SkyNeeds sky = {};
};

ScreenPlan planScreen(const ScreenOcclusion& settings);

/// Directions around the point and steps along each that make about `samples`: hbao takes as many of each; a slice of
/// gtao and bitmask has two sides.
glm::ivec2 marchCounts(ScreenEstimator estimator, int samples);

/// Points with weights in the axes of the tangent plane (z along the normal): x, y, z, weight
/// (shaders/screen/points.glsl).
std::vector<glm::vec4> pointSamples(const ScreenOcclusion& settings);
/// Points of the unit disk: x, y, half chord, weight (volumetric.glsl, disk.glsl, line.glsl).
std::vector<glm::vec4> diskSamples(const ScreenOcclusion& settings);

/// Points of the disk in which light from the neighbourhood is looked for: x, y.
std::vector<glm::vec4> indirectSamples(const ScreenOcclusion& settings);

/// d mu / dr at r in (0, 1), and the r at which mu is `share`. Not for exponential, the first not for classical.
double membershipSlope(Membership membership, double r);
double membershipInverse(Membership membership, double share);

}  // namespace isolume
