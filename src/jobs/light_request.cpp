#include "src/jobs/light_request.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "src/errors.h"
#include "src/jobs/color.h"

namespace isolume {
namespace {

bool has(const LightingRequest& request, LightKind kind) {
  return std::any_of(request.lights.begin(), request.lights.end(),
                     [kind](const LightRequest& light) { return light.kind == kind; });
}

float exposureOf(const LightingRequest& request) { return static_cast<float>(std::exp2(request.exposure)); }

/// One number per sample stands for all octants, whose light is known before the grid is.
void checkCombinedLights(const LightingRequest& request) {
  for (const LightRequest& light : request.lights) {
    if (light.kind == LightKind::sun || !isGrey(light.color))
      throw UsageError(
          fmt::format("--light: expected grey octants or skies with --occlusion combined, found '{}'", light.text));
  }
  const OctantIntensities intensities = combinedIntensities(request);
  if (std::all_of(intensities.begin(), intensities.end(), [](float each) { return each == 0; }))
    throw UsageError("--light: expected light from one octant at least with --occlusion combined, found none");
}

/// What eight octants alone can do.
void checkOctantLights(const LightingRequest& request, OcclusionMethod method) {
  const auto refuse = [method](bool given, const char* option) {
    if (given)
      throw UsageError(fmt::format("{}: expected --occlusion ordinates beside it, or none, found {}", option,
                                   occlusionName(method)));
  };
  refuse(!request.environment.empty(), "--environment");
  refuse(request.freePathShare && !request.opacity, "--preset translucent without --opacity");
  refuse(request.bounces.value_or(0) != 0, "--bounces");
  refuse(has(request, LightKind::gradient), "--light gradient");
  refuse(has(request, LightKind::head), "--light head");
  for (const LightRequest& light : request.lights) {
    refuse(light.kind == LightKind::sun && light.shadow != SunShadow::soft, "--light sun with hard or turned shadow");
    refuse(light.radiusDegrees.has_value(), "--light sun with a radius");
  }
  if (method == OcclusionMethod::combined) checkCombinedLights(request);
}

}  // namespace

bool isTranslucent(const LightingRequest& request) {
  return request.opacity ? *request.opacity < 1 : request.freePathShare.has_value();
}

bool isPlain(const LightingRequest& request) {
  return request.lights.empty() && request.environment.empty() && request.exposure == 0 &&
         request.bounces.value_or(0) == 0 && !isTranslucent(request);
}

const char* givenOption(const LightingRequest& request) {
  return !request.lights.empty()        ? "--light"
         : !request.environment.empty() ? "--environment"
         : request.rotationDegrees      ? "--environment-rotation"
         : request.exposure != 0        ? "--exposure"
         : request.bounces              ? "--bounces"
         : request.opacity              ? "--opacity"
                                        : nullptr;
}

const char* beyondEvenSky(const LightingRequest& request) {
  LightingRequest even = request;
  even.exposure = 0;
  return request.freePathShare && !request.opacity ? "--preset translucent without --opacity" : givenOption(even);
}

void checkLighting(const LightingRequest& request, OcclusionMethod method) {
  if (request.rotationDegrees && request.environment.empty())
    throw UsageError("--environment-rotation: expected --environment beside it");
  const char* option = givenOption(request);
  if (!option) return;
  if (method == OcclusionMethod::none)
    throw UsageError(fmt::format("{}: expected a method of occlusion beside it, found none", option));
  if (byOctants(method)) {
    checkOctantLights(request, method);
    return;
  }
  if (!isTranslucent(request)) return;
  if (request.bounces.value_or(0) != 0)
    throw UsageError("--bounces: expected an opaque solid, found --opacity below 1");
  if (has(request, LightKind::sun))
    throw UsageError("--opacity: expected skies and maps as lights, found a sun, whose shadows are those of a solid");
}

glm::dvec3 sunDirection(const LightRequest& sun, const CameraAxes& camera) {
  if (sun.direction) return glm::normalize(*sun.direction);
  const CameraAxes world{.right = {1, 0, 0}, .up = {0, 0, 1}, .forward = {0, 1, 0}};
  const CameraAxes& axes = sun.fromCamera ? camera : world;
  const double azimuth = glm::radians(sun.azimuthDegrees), elevation = glm::radians(sun.elevationDegrees);
  return std::cos(elevation) * (std::sin(azimuth) * axes.right - std::cos(azimuth) * axes.forward) +
         std::sin(elevation) * axes.up;
}

std::array<glm::vec3, kOctantCount> octantLights(const LightingRequest& request, glm::dmat3 worldFromAxes,
                                                 const CameraAxes& camera) {
  std::array<glm::vec3, kOctantCount> sum{};
  const float exposure = exposureOf(request);
  if (request.lights.empty()) sum.fill(glm::vec3(exposure));
  for (const LightRequest& light : request.lights) {
    const glm::dvec3 towards = glm::transpose(worldFromAxes) * sunDirection(light, camera);
    for (std::size_t s = 0; s < sum.size(); ++s) {
      const glm::dvec3 octant(kOctants[s].towardsLight());
      const bool lit = light.kind != LightKind::sun || glm::all(glm::equal(glm::lessThan(towards, glm::dvec3(0)),
                                                                           glm::lessThan(octant, glm::dvec3(0))));
      if (lit) sum[s] += exposure * light.octants[s] * light.color;
    }
  }
  return sum;
}

OctantIntensities combinedIntensities(const LightingRequest& request) {
  OctantIntensities intensities = request.lights.empty() ? kEvenOctants : OctantIntensities{};
  for (const LightRequest& light : request.lights)
    for (std::size_t s = 0; s < intensities.size(); ++s) intensities[s] += light.octants[s] * light.color.g;
  for (float& each : intensities) each *= exposureOf(request);
  return intensities;
}

nlohmann::ordered_json lightingSettings(const LightingRequest& request) {
  nlohmann::ordered_json settings = nlohmann::ordered_json::object();
  for (const LightRequest& light : request.lights) settings["light"].push_back(light.text);
  if (!request.environment.empty()) {
    settings["environment"] = request.environment;
    settings["environment-rotation"] = request.rotationDegrees.value_or(0);
  }
  if (request.exposure != 0) settings["exposure"] = request.exposure;
  if (request.bounces) {
    if (*request.bounces == kAllBounces)
      settings["bounces"] = "all";
    else
      settings["bounces"] = *request.bounces;
  }
  if (request.opacity) settings["opacity"] = *request.opacity;
  return settings;
}

}  // namespace isolume
