#include "src/jobs/screen_request.h"

#include <fmt/core.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "src/errors.h"
#include "src/jobs/reference_job.h"

namespace isolume {
namespace {

struct Given {
  const char* option;
  bool given;
};

std::vector<Given> givenOptions(const ScreenRequest& r) {
  return {{"--ao-radius", r.radius.has_value()},
          {"--ao-samples", r.samples.has_value()},
          {"--membership", r.membership.has_value()},
          {"--surface", r.surface.has_value()},
          {"--interleave", r.interleaving.has_value()},
          {"--ao-filter", r.filter.has_value()},
          {"--ao-normalisation", r.normalisedBySamples.has_value()},
          {"--ao-clamp", r.clampedToTangent.has_value()},
          {"--indirect", r.indirect.has_value()},
          {"--ao-thickness", r.thickness.has_value()},
          {"--ao-second-radius", r.secondRadius.has_value()},
          {"--bent-from", r.bentFrom.has_value()},
          {"--bent", r.bent.has_value()},
          {"--bent-term", r.geometricTerm.has_value()},
          {"--ao-steps", r.steps.has_value()}};
}

/// Everything but the radius.
ScreenOcclusion settingsOf(const ScreenRequest& request) {
  ScreenOcclusion screen;
  screen.estimator = request.estimator.value();
  screen.samples = request.samples.value_or(screen.samples);
  const std::vector<Membership> taken = takenMemberships(screen.estimator);
  if (!taken.empty()) screen.membership = request.membership.value_or(screen.membership);
  screen.surface = request.surface.value_or(screen.surface);
  screen.interleaving = request.interleaving.value_or(screen.interleaving);
  screen.filter = request.filter.value_or(screen.filter);
  screen.normalisedBySamples = request.normalisedBySamples.value_or(screen.normalisedBySamples);
  screen.clampedToTangent = request.clampedToTangent.value_or(screen.clampedToTangent);
  screen.indirect = request.indirect.value_or(screen.indirect);
  screen.thicknessWorld = request.thickness;
  screen.secondRadius = request.secondRadius;
  screen.bentFrom = request.bentFrom.value_or(screen.bentFrom);
  screen.bent = request.bent.value_or(screen.bent);
  screen.geometricTerm = request.geometricTerm.value_or(screen.geometricTerm);
  screen.steps = request.steps.value_or(screen.steps);
  return screen;
}

std::string membershipList(const std::vector<Membership>& memberships) {
  std::string list;
  for (const Membership each : memberships) list.append(list.empty() ? "" : ", ").append(membershipName(each));
  return list;
}

void checkMembership(const ScreenRequest& request) {
  if (!request.membership) return;
  const std::vector<Membership> taken = takenMemberships(*request.estimator);
  const char* name = screenEstimatorName(*request.estimator);
  if (taken.empty())
    throw UsageError(fmt::format("--membership: expected none, since {} has its own, found '{}'", name,
                                 membershipName(*request.membership)));
  if (std::find(taken.begin(), taken.end(), *request.membership) == taken.end())
    throw UsageError(fmt::format("--membership: expected one of {} with {}, found '{}'", membershipList(taken), name,
                                 membershipName(*request.membership)));
}

/// `readers` in words.
void needReader(bool given, bool read, const char* option, const char* readers, ScreenEstimator found) {
  if (given && !read)
    throw UsageError(fmt::format("{}: expected {}, found --occlusion {}", option, readers, screenEstimatorName(found)));
}

/// klehm11 by sweeps reads one place of the volume.
void checkSwept(const ScreenRequest& request) {
  const std::vector<Given> around{{"--ao-radius", request.radius.has_value()},
                                  {"--ao-samples", request.samples.has_value()},
                                  {"--interleave", request.interleaving.has_value()},
                                  {"--ao-filter", request.filter.has_value()},
                                  {"--indirect", request.indirect == true}};
  for (const Given& each : around)
    if (each.given)
      throw UsageError(fmt::format("{}: expected --bent-from crytek-2d, crytek-3d or hbao, found sweep", each.option));
}

void checkBent(const ScreenRequest& request, const ScreenOcclusion& screen) {
  const ScreenEstimator found = screen.estimator;
  const bool bent = found == ScreenEstimator::klehm11;
  needReader(request.bentFrom.has_value(), bent, "--bent-from", "klehm11", found);
  needReader(request.bent.has_value(), bent, "--bent", "klehm11", found);
  needReader(request.geometricTerm.has_value(), bent && hasCone(screen.bent), "--bent-term",
             "klehm11 with --bent cone or cap", found);
  needReader(request.steps.has_value(), readsSteps(screen), "--ao-steps",
             "env-importance, or klehm11 with --bent-from crytek-3d", found);
  if (!readsNeighbourhood(screen)) checkSwept(request);
}

}  // namespace

bool sweepsBent(const ScreenRequest& request) {
  return request.estimator == ScreenEstimator::klehm11 && request.bentFrom == BentSource::sweep;
}

void checkScreenLight(const ScreenRequest& request, const LightingRequest& light) {
  const char* option = givenOption(light);
  if (!request.estimator || !option) return;
  const char* name = screenEstimatorName(*request.estimator);
  if (!readsSky(*request.estimator))
    throw UsageError(fmt::format(
        "{}: expected with openness by sweeps, klehm11, ssdo or env-importance, found --occlusion {}", option, name));
  const auto refuse = [name](bool given, const char* what) {
    if (given)
      throw UsageError(
          fmt::format("{}: expected skies, gradients and a map as lights beside --occlusion {}, found it", what, name));
  };
  for (const LightRequest& each : light.lights) {
    refuse(each.kind == LightKind::sun, "--light sun");
    refuse(each.kind == LightKind::head, "--light head");
    refuse(each.kind == LightKind::octants, "--light octants");
  }
  refuse(light.bounces.value_or(0) != 0, "--bounces");
  refuse(isTranslucent(light), light.opacity ? "--opacity" : "--preset translucent");
}

void checkScreenRequest(const ScreenRequest& request, const char* swept) {
  if (!request.estimator) {
    for (const Given& each : givenOptions(request))
      if (each.given)
        throw UsageError(fmt::format(
            "{}: expected a screen-space --occlusion beside it (szirmay10-volumetric, say), found none", each.option));
    return;
  }
  if (swept && !sweepsBent(request))
    throw UsageError(fmt::format("{}: expected with openness by sweeps, found --occlusion {}", swept,
                                 screenEstimatorName(*request.estimator)));
  checkMembership(request);
  const ScreenOcclusion screen = settingsOf(request);
  const ScreenEstimator found = screen.estimator;
  needReader(request.surface.has_value(), readsCharacteristic(screen), "--surface",
             "an estimator of points or lines beside it", found);
  needReader(request.thickness.has_value(), readsThickness(screen), "--ao-thickness",
             "an estimator of points or lines with --surface zbuffer, loos10-area or bitmask", found);
  needReader(request.clampedToTangent.has_value(), isLoos10(found), "--ao-clamp",
             "loos10-point, loos10-line or loos10-area", found);
  needReader(request.secondRadius.has_value(), isLoos10(found), "--ao-second-radius",
             "loos10-point, loos10-line or loos10-area", found);
  needReader(request.normalisedBySamples.has_value(), readsNormalisation(found), "--ao-normalisation",
             "an estimator whose sum is divided by anything but the number of samples", found);
  checkBent(request, screen);
  if (request.filter == true && screen.interleaving == 1)
    throw UsageError("--ao-filter: expected off with --interleave off, found on: there is nothing to average");
}

std::optional<ScreenOcclusion> chooseScreen(const ScreenRequest& request, const std::array<glm::dvec3, 8>& corners) {
  if (!request.estimator) return std::nullopt;
  ScreenOcclusion screen = settingsOf(request);
  double longest = 0;
  for (const std::size_t axis : {1, 2, 4}) longest = std::max(longest, glm::distance(corners[0], corners[axis]));
  screen.radiusWorld = request.radius.value_or(kScreenRadiusShare * longest);
  return screen;
}

const char* characteristicName(Characteristic surface) {
  switch (surface) {
    case Characteristic::zBuffer:
      return "zbuffer";
    case Characteristic::heightField:
      return "heightfield";
    case Characteristic::implicit:
      return "implicit";
  }
  return nullptr;
}

nlohmann::ordered_json screenSettings(const ScreenOcclusion& screen) {
  nlohmann::ordered_json settings;
  settings["occlusion"] = screenEstimatorName(screen.estimator);
  if (screen.estimator == ScreenEstimator::klehm11) {
    settings["bent-from"] = bentSourceName(screen.bentFrom);
    settings["bent"] = bentLightName(screen.bent);
    if (hasCone(screen.bent)) settings["bent-term"] = screen.geometricTerm ? "on" : "off";
  }
  if (readsSteps(screen)) settings["ao-steps"] = screen.steps;
  if (!readsNeighbourhood(screen)) return settings;
  settings["ao-radius"] = screen.radiusWorld;
  settings["ao-samples"] = screen.samples;
  if (!takenMemberships(screen.estimator).empty()) settings["membership"] = membershipName(screen.membership);
  if (readsCharacteristic(screen)) settings["surface"] = characteristicName(screen.surface);
  if (screen.interleaving > 1) {
    settings["interleave"] = screen.interleaving;
    settings["ao-filter"] = screen.filter ? "on" : "off";
  } else {
    settings["interleave"] = "off";
  }
  if (readsNormalisation(screen.estimator))
    settings["ao-normalisation"] = screen.normalisedBySamples ? "sampled" : "exact";
  if (isLoos10(screen.estimator)) settings["ao-clamp"] = screen.clampedToTangent ? "on" : "off";
  if (screen.indirect) settings["indirect"] = "on";
  if (screen.thicknessWorld) settings["ao-thickness"] = *screen.thicknessWorld;
  if (screen.secondRadius) settings["ao-second-radius"] = *screen.secondRadius;
  return settings;
}

}  // namespace isolume
