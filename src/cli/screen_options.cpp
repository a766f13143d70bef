#include "src/cli/screen_options.h"

#include <fmt/core.h>

#include <variant>

#include "src/cli/option_builder.h"
#include "src/cli/parse_value.h"
#include "src/jobs/reference_job.h"

namespace isolume {
namespace {

const Choices<bool> kSwitch{{"on", true}, {"off", false}};

void addNeighbourhoodOptions(OptionGroup& group, ScreenRequest& screen) {
  group.value(
      "--ao-radius", "LENGTH",
      [&screen](const std::string& option, const std::string& text) { screen.radius = parsePositive(option, text); },
      "how far occluders count, world units\n(default: a tenth of the solid's longest side)");
  group.value(
      "--ao-samples", "N",
      [&screen](const std::string& option, const std::string& text) {
        screen.samples = parseCount(option, text, 1, kMostScreenSamples);
      },
      fmt::format("samples per pixel, 1 to {} (default: {})", kMostScreenSamples, ScreenOcclusion().samples));
  Choices<Membership> memberships;
  for (const Membership each : takenMemberships(ScreenEstimator::gpuImportance))
    memberships.emplace_back(membershipName(each), each);
  group.value(
      "--membership", "NAME",
      [&screen, memberships](const std::string& option, const std::string& text) {
        screen.membership = parseChoice(option, text, memberships);
      },
      "gpu-sphere, -hemisphere, -importance, -tangent and\nszirmay10-containment: how openness grows with\ndistance: "
      "classical, sqrt, linear, volumetric or\nquartic (default: volumetric)");
  Choices<Characteristic> surfaces;
  for (const Characteristic each : {Characteristic::zBuffer, Characteristic::heightField, Characteristic::implicit})
    surfaces.emplace_back(characteristicName(each), each);
  group.value(
      "--surface", "NAME",
      [&screen, surfaces](const std::string& option, const std::string& text) {
        screen.surface = parseChoice(option, text, surfaces);
      },
      "what is solid: zbuffer, behind what is seen;\nheightfield, below the highest of the column along z;\n"
      "implicit, by the volume itself (default: zbuffer)");
  group.value(
      "--ao-thickness", "LENGTH",
      [&screen](const std::string& option, const std::string& text) { screen.thickness = parsePositive(option, text); },
      "zbuffer, bitmask: solids end so far behind what is\nseen, world units (default: never)");
}

void addSamplingOptions(OptionGroup& group, ScreenRequest& screen) {
  group.value(
      "--interleave", "N",
      [&screen](const std::string& option, const std::string& text) {
        screen.interleaving = text == "off" ? 1 : parseCount(option, text, 2, kMostInterleaving);
      },
      fmt::format("pixels of an NxN pattern have sets of their own:\n2 to {}, or off (default: {})", kMostInterleaving,
                  ScreenOcclusion().interleaving));
  group.value(
      "--ao-filter", "SWITCH",
      [&screen](const std::string& option, const std::string& text) {
        screen.filter = parseChoice(option, text, kSwitch);
      },
      "on or off: mean over the pattern, within a surface\n(default: on)");
  group.value(
      "--ao-normalisation", "NAME",
      [&screen](const std::string& option, const std::string& text) {
        screen.normalisedBySamples = parseChoice<bool>(option, text, {{"sampled", true}, {"exact", false}});
      },
      "sampled or exact: what sums are divided by\n(default: sampled)");
  group.value(
      "--ao-clamp", "SWITCH",
      [&screen](const std::string& option, const std::string& text) {
        screen.clampedToTangent = parseChoice(option, text, kSwitch);
      },
      "loos10: on or off: only what lies above the tangent\nplane (default: on)");
  group.value(
      "--indirect", "SWITCH",
      [&screen](const std::string& option, const std::string& text) {
        screen.indirect = parseChoice(option, text, kSwitch);
      },
      "on or off: what is closed receives the mean light of\nwhat it faces nearby, with its colour (default: off)");
  group.value(
      "--ao-second-radius", "SHARE",
      [&screen](const std::string& option, const std::string& text) {
        screen.secondRadius = parsePositive(option, text);
      },
      "loos10: times the openness within so many radii");
}

void addBentOptions(OptionGroup& group, ScreenRequest& screen) {
  Choices<BentSource> sources;
  for (const BentSource each : {BentSource::crytek2d, BentSource::crytek3d, BentSource::hbao, BentSource::sweep})
    sources.emplace_back(bentSourceName(each), each);
  group.value(
      "--bent-from", "NAME",
      [&screen, sources](const std::string& option, const std::string& text) {
        screen.bentFrom = parseChoice(option, text, sources);
      },
      "klehm11: where openness and bent normals come from:\ncrytek-2d, crytek-3d, hbao, or sweep, from the volume\n"
      "(default: crytek-3d)");
  Choices<BentLight> lights;
  for (const BentLight each : {BentLight::none, BentLight::normal, BentLight::cone, BentLight::cap})
    lights.emplace_back(bentLightName(each), each);
  group.value(
      "--bent", "NAME",
      [&screen, lights](const std::string& option, const std::string& text) {
        screen.bent = parseChoice(option, text, lights);
      },
      "klehm11: what light is looked up by: none, the normal;\nnormal, the bent normal; cone, the bent cone; cap, "
      "one\nwith the exact angle of a cap (default: cone)");
  group.value(
      "--bent-term", "SWITCH",
      [&screen](const std::string& option, const std::string& text) {
        screen.geometricTerm = parseChoice(option, text, kSwitch);
      },
      "cone, cap: on or off: with the cosine between normal and\nbent normal (default: off)");
  group.value(
      "--ao-steps", "N",
      [&screen](const std::string& option, const std::string& text) {
        screen.steps = parseCount(option, text, 0, kMostScreenSteps);
      },
      fmt::format("crytek-3d, env-importance: further points on the way to\neach sample, 0 to {} (default: {})",
                  kMostScreenSteps, ScreenOcclusion().steps));
}

}  // namespace

void parseOcclusion(const std::string& option, const std::string& text, OcclusionRequest& occlusion,
                    ScreenRequest& screen) {
  using Named = std::variant<OcclusionMethod, ScreenEstimator>;
  Choices<Named> choices;
  for (const OcclusionMethod each : {OcclusionMethod::singh10, OcclusionMethod::octants, OcclusionMethod::combined,
                                     OcclusionMethod::ordinates, OcclusionMethod::none})
    choices.emplace_back(occlusionName(each), each);
  for (const ScreenEstimator each : screenEstimators()) choices.emplace_back(screenEstimatorName(each), each);
  const Named named = parseChoice(option, text, choices);
  occlusion.method.reset();
  screen.estimator.reset();
  if (const auto* method = std::get_if<OcclusionMethod>(&named))
    occlusion.method = *method;
  else
    screen.estimator = std::get<ScreenEstimator>(named);
}

void addScreenOptions(CLI::App& app, ScreenRequest& screen) {
  OptionGroup group(app, "Screen-space occlusion");
  addNeighbourhoodOptions(group, screen);
  addSamplingOptions(group, screen);
  addBentOptions(group, screen);
}

}  // namespace isolume
