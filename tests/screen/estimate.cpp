#include "screen/estimate.h"

#include <numbers>

#include "raymarch/screen/sky_convolution.h"
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
    case ScreenEstimator::envImportance:
      return glsl::importanceLight(shaded).w;
    case ScreenEstimator::loosLine:
      return glsl::lineOpenness(shaded, 1);
    default:
      return glsl::pointsOpenness(shaded, 1);
  }
}

/// Directions and steps that find every horizon: with few, its highest point falls between two steps.
constexpr glm::ivec2 kFineMarch{16, 512};

/// Of the sky of radiance 1 where the settings have none.
std::vector<glm::vec4> drawsOf(const ScreenOcclusion& settings) {
  if (settings.estimator != ScreenEstimator::envImportance) return {};
  SkyCube white;
  addEvenSky(white, glm::vec3(1));
  return skyDraws(settings.sky ? *settings.sky : white);
}

/// L_p of the settings' sky, and its radiance, by the nearest texel.
std::function<glm::vec3(glm::vec3)> openLightOf(const ScreenOcclusion& settings) {
  if (!settings.sky) return [](glm::vec3) { return glm::vec3(1); };
  return [light = convolvedSky(*settings.sky, kConeAngles - 1)[0]](glm::vec3 direction) {
    return light[cubeTexel(kConeSide, direction)];
  };
}
std::function<glm::vec3(glm::vec3)> radianceOf(const ScreenOcclusion& settings) {
  return [sky = settings.sky](glm::vec3 direction) {
    return sky ? sky->radiance[cubeTexel(sky->side, direction)] : glm::vec3(1);
  };
}

/// Calls `visit` with each turn of the samples.
template <class Visit>
void forEachTurn(const ScreenOcclusion& settings, const std::vector<glm::vec4>& samples, const Blocks& blocks,
                 glm::dvec3 view, int turns, double roll, Visit visit) {
  const glm::dmat3 frame = frameAlong(view, roll);
  glsl::asked = {
      samples,
      settings.estimator == ScreenEstimator::envImportance ? glm::ivec2(settings.samples, 0) : kFineMarch,
      settings.normalisedBySamples,
      settings.clampedToTangent,
      static_cast<float>(settings.thicknessWorld.value_or(1e9)),
      settings.steps,
      glm::mat3(frame),
      drawsOf(settings),
      radianceOf(settings),
      openLightOf(settings),
      [&](float x, float y) { return static_cast<float>(entry(blocks, frame * glm::dvec3(x, y, 0), frame[2])); }};
  const glm::vec3 normal(glm::transpose(frame) * glm::dvec3(0, 0, 1));
  for (int i = 0; i < turns; ++i) {
    const double angle = 2 * std::numbers::pi * i / turns;
    // Jitters in another order than the angles: i times an odd number, modulo a power of two.
    constexpr int kOrder = 13;
    visit(glsl::Shaded{normal, glm::vec2(std::cos(angle), std::sin(angle)),
                       static_cast<float>(i * kOrder % turns) / static_cast<float>(turns)});
  }
}

glsl::Bent bentOnce(const ScreenOcclusion& settings, const glsl::Shaded& shaded) {
  if (settings.bentFrom == BentSource::hbao) return glsl::hbaoBent(shaded);
  return settings.bentFrom == BentSource::crytek2d ? glsl::diskBent(shaded) : glsl::ballBent(shaded);
}

}  // namespace

double estimateBy(const ScreenOcclusion& settings, const std::vector<glm::vec4>& samples, const Blocks& blocks,
                  glm::dvec3 view, int turns, double roll) {
  double sum = 0;
  forEachTurn(settings, samples, blocks, view, turns, roll, [&](const glsl::Shaded& shaded) {
    sum += settings.estimator == ScreenEstimator::klehm11 ? bentOnce(settings, shaded).share
                                                          : estimateOnce(settings.estimator, shaded);
  });
  return sum / turns;
}

glm::dvec4 estimateBend(const ScreenOcclusion& settings, const Blocks& blocks, glm::dvec3 view, int turns,
                        double roll) {
  glm::dvec4 sum(0);
  forEachTurn(settings, planScreen(settings).samples, blocks, view, turns, roll,
              [&](const glsl::Shaded& shaded) { sum += glm::dvec4(glsl::storedBend(bentOnce(settings, shaded))); });
  return sum / static_cast<double>(turns);
}

glm::dvec4 estimateLight(const ScreenOcclusion& settings, const Blocks& blocks, glm::dvec3 view, int turns,
                         double roll) {
  glm::dvec4 sum(0);
  const bool drawn = settings.estimator == ScreenEstimator::envImportance;
  forEachTurn(settings, planScreen(settings).samples, blocks, view, turns, roll, [&](const glsl::Shaded& shaded) {
    sum += glm::dvec4(drawn ? glsl::importanceLight(shaded) : glsl::ssdoLight(shaded));
  });
  return sum / static_cast<double>(turns);
}

double estimate(const ScreenOcclusion& settings, const Blocks& blocks, glm::dvec3 view, int turns, double roll) {
  return estimateBy(settings, planScreen(settings).samples, blocks, view, turns, roll);
}

}  // namespace isolume::test
