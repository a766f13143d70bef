// An estimator of shaders/screen in C++ on a scene of half-spaces, averaged over turns of its samples.
#pragma once

#include <numbers>

#include "screen/half_spaces.h"
#include "screen/screen_shaders.h"

namespace isolume::test {

inline float estimateOnce(ScreenEstimator estimator, const glsl::Shaded& shaded) {
  switch (estimator) {
    case ScreenEstimator::hbao:
      return glsl::hbaoOpenness(shaded);
    case ScreenEstimator::gtao:
      return glsl::gtaoOpenness(shaded);
    case ScreenEstimator::bitmask:
      return glsl::bitmaskOpenness(shaded);
    case ScreenEstimator::szirmayVolumetric:
      return glsl::volumetricOpenness(shaded);
    case ScreenEstimator::gpuDisk:
      return glsl::diskOpenness(shaded);
    case ScreenEstimator::loosArea:
      return glsl::areaOpenness(shaded, 1);
    case ScreenEstimator::loosLine:
      return glsl::lineOpenness(shaded, 1);
    default:
      return glsl::pointsOpenness(shaded, 1);
  }
}

/// Directions and steps that find every horizon: with few, its highest point falls between two steps.
inline constexpr glm::ivec2 kFineMarch{16, 512};

/// `view` leads away from the eye, in the scene's axes. Lengths are in radii: the radius of the settings is 1.
inline double estimate(const ScreenOcclusion& settings, const Blocks& blocks, glm::dvec3 view, int turns = 32,
                       double roll = 0) {
  const glm::dmat3 frame = frameAlong(view, roll);
  const ScreenPlan plan = planScreen(settings);
  glsl::asked = {
      plan.samples,
      plan.samples.empty() ? kFineMarch : plan.march,
      settings.normalisedBySamples,
      settings.clampedToTangent,
      static_cast<float>(settings.thicknessWorld.value_or(1e9)),
      [&](float x, float y) { return static_cast<float>(entry(blocks, frame * glm::dvec3(x, y, 0), frame[2])); }};
  const glm::vec3 normal(glm::transpose(frame) * glm::dvec3(0, 0, 1));
  double sum = 0;
  for (int i = 0; i < turns; ++i) {
    const double angle = 2 * std::numbers::pi * i / turns;
    // Jitters in another order than the angles: i times an odd number, modulo a power of two.
    constexpr int kOrder = 13;
    sum += estimateOnce(settings.estimator, {normal, glm::vec2(std::cos(angle), std::sin(angle)),
                                             static_cast<float>(i * kOrder % turns) / static_cast<float>(turns)});
  }
  return sum / turns;
}

}  // namespace isolume::test
