#include "src/jobs/light_request.h"

#include <fmt/core.h>

#include <algorithm>

#include "src/errors.h"

namespace isolume {
namespace {

bool has(const LightingRequest& request, LightKind kind) {
  return std::any_of(request.lights.begin(), request.lights.end(),
                     [kind](const LightRequest& light) { return light.kind == kind; });
}

}  // namespace

bool isPlain(const LightingRequest& request) {
  return request.lights.empty() && request.environment.empty() && request.exposure == 0 &&
         request.bounces.value_or(0) == 0 && request.opacity.value_or(1) == 1;
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

void checkLighting(const LightingRequest& request, OcclusionMethod method) {
  if (request.rotationDegrees && request.environment.empty())
    throw UsageError("--environment-rotation: expected --environment beside it");
  if (const char* option = givenOption(request); option && method != OcclusionMethod::ordinates)
    throw UsageError(
        fmt::format("{}: expected --occlusion ordinates beside it, or none, found {}", option, occlusionName(method)));
  if (request.opacity.value_or(1) == 1) return;
  if (request.bounces.value_or(0) != 0)
    throw UsageError("--bounces: expected an opaque solid, found --opacity below 1");
  if (has(request, LightKind::sun))
    throw UsageError("--opacity: expected skies and maps as lights, found a sun, whose shadows are those of a solid");
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
