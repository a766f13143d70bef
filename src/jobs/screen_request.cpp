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
          {"--ao-second-radius", r.secondRadius.has_value()}};
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

}  // namespace

void checkScreenRequest(const ScreenRequest& request, const char* other) {
  if (!request.estimator) {
    for (const Given& each : givenOptions(request))
      if (each.given)
        throw UsageError(fmt::format(
            "{}: expected a screen-space --occlusion beside it (szirmay10-volumetric, say), found none", each.option));
    return;
  }
  if (other)
    throw UsageError(fmt::format("{}: expected with openness by sweeps, found --occlusion {}", other,
                                 screenEstimatorName(*request.estimator)));
  checkMembership(request);
  const ScreenOcclusion screen = settingsOf(request);
  const ScreenEstimator found = screen.estimator;
  needReader(request.surface.has_value(), readsCharacteristic(found), "--surface",
             "an estimator of points or lines beside it", found);
  needReader(request.thickness.has_value(), readsThickness(screen), "--ao-thickness",
             "an estimator of points or lines with --surface zbuffer, loos10-area or bitmask", found);
  needReader(request.clampedToTangent.has_value(), isLoos10(found), "--ao-clamp",
             "loos10-point, loos10-line or loos10-area", found);
  needReader(request.secondRadius.has_value(), isLoos10(found), "--ao-second-radius",
             "loos10-point, loos10-line or loos10-area", found);
  needReader(request.normalisedBySamples.has_value(), readsNormalisation(found), "--ao-normalisation",
             "an estimator whose sum is divided by anything but the number of samples", found);
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
  settings["ao-radius"] = screen.radiusWorld;
  settings["ao-samples"] = screen.samples;
  if (!takenMemberships(screen.estimator).empty()) settings["membership"] = membershipName(screen.membership);
  if (readsCharacteristic(screen.estimator)) settings["surface"] = characteristicName(screen.surface);
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
