#include "screen/estimate.h"

#include <numbers>

#include "screen/screen_shaders.h"

namespace isolume::test {
namespace {

float estimateOnce(ScreenEstimator estimator, const glsl::Shaded& shaded) {
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
constexpr glm::ivec2 kFineMarch{16, 512};

}  // namespace

double estimateBy(const ScreenOcclusion& settings, const std::vector<glm::vec4>& samples, const Blocks& blocks,
                  glm::dvec3 view, int turns, double roll) {
  const glm::dmat3 frame = frameAlong(view, roll);
  glsl::asked = {
      samples,
      kFineMarch,
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

double estimate(const ScreenOcclusion& settings, const Blocks& blocks, glm::dvec3 view, int turns, double roll) {
  return estimateBy(settings, planScreen(settings).samples, blocks, view, turns, roll);
}

}  // namespace isolume::test
