#include "src/cli/reference_options.h"

#include <limits>

#include "src/cli/option_builder.h"
#include "src/cli/parse_value.h"
#include "src/cli/picture_options.h"
#include "src/cli/surface_options.h"

namespace isolume {
namespace {

/// 2^24 rays per pixel bring the error of any openness below .0002; indices of samples stay far below 2^32.
constexpr int kMostRays = 1 << 24;
/// No integrand with values in [0, 1] has a larger error from kReplicates samples.
constexpr double kLargestTarget = 0.5;
/// A hemisphere of light.
constexpr double kLargestLight = 90;
/// With an albedo of .99 a path of that length still carries 4 % of its light.
constexpr int kMostBounces = 1024;

void addIntegrandOptions(CLI::App& app, ReferenceJob& job) {
  OptionGroup group(app, "Integrand");
  Choices<Integrand> integrands;
  for (const Integrand each : {Integrand::ambient, Integrand::shadow, Integrand::light, Integrand::environment,
                               Integrand::bounce, Integrand::bent, Integrand::translucent})
    integrands.emplace_back(integrandName(each), each);
  group.value(
      "--integrand", "NAME",
      [&job, integrands](const std::string& option, const std::string& text) {
        job.integrand = parseChoice(option, text, integrands);
      },
      "ambient, shadow, light, environment, bounce, bent or\ntranslucent (default: ambient)");
  group.value(
      "--radius", "LENGTH",
      [&job](const std::string& option, const std::string& text) { job.radius = parsePositive(option, text); },
      "ambient: how far occluders count, world units\n(default: any distance)");
  Choices<Membership> memberships;
  for (const Membership each : {Membership::exponential, Membership::classical, Membership::squareRoot,
                                Membership::linear, Membership::volumetric, Membership::quartic})
    memberships.emplace_back(membershipName(each), each);
  group.value(
      "--membership", "NAME",
      [&job, memberships](const std::string& option, const std::string& text) {
        job.membership = parseChoice(option, text, memberships);
      },
      "with --radius: how openness grows with distance:\nexponential, classical, sqrt, linear, volumetric or\n"
      "quartic (default: classical)");
  group.value(
      "--light-direction", "X,Y,Z",
      [&job](const std::string& option, const std::string& text) { job.lightDirection = parseVector(option, text); },
      "shadow, light: towards the light, world");
  group.value(
      "--light-radius", "DEG",
      [&job](const std::string& option, const std::string& text) {
        job.lightRadius = parseWithin(option, text, 0, kLargestLight);
        if (*job.lightRadius == 0) parsePositive(option, text);
      },
      "light: angular radius of its disc, up to 90");
  group.value(
      "--environment", "FILE", [&job](const std::string&, const std::string& text) { job.environment = text; },
      "environment, bounce: equirectangular EXR or PNG; top +z,\ncentre +y, to the right +x");
  group.value(
      "--bounces", "N",
      [&job](const std::string& option, const std::string& text) {
        job.bounces = parseCount(option, text, 0, kMostBounces);
      },
      fmt::format("bounce: reflections by the surface (default: {})", kDefaultBounces));
  group.value(
      "--opacity", "A",
      [&job](const std::string& option, const std::string& text) { job.opacity = parseWithin(option, text, 0, 1); },
      "translucent: one voxel of solid lets 1 - A through, 0 to 1");
}

void addSamplingOptions(CLI::App& app, ReferenceJob& job) {
  OptionGroup group(app, "Sampling");
  const SamplingSettings defaults;
  group.value(
      "--rays", "N",
      [&job](const std::string& option, const std::string& text) {
        job.rays = parseCount(option, text, kReplicates, kMostRays);
      },
      fmt::format("samples per pixel, a multiple of {} (default: {})", kReplicates, defaults.rays));
  group.value(
      "--stderr", "E",
      [&job](const std::string& option, const std::string& text) {
        job.targetError = parsePositive(option, text);
        parseWithin(option, text, 0, kLargestTarget);
      },
      "instead: until every pixel's standard error is at most E");
  group.value(
      "--max-rays", "N",
      [&job](const std::string& option, const std::string& text) {
        job.maxRays = parseCount(option, text, kReplicates, kMostRays);
      },
      fmt::format("with --stderr: samples per pixel at the most (default: {})", defaults.maxRays));
  group.value(
      "--seed", "N",
      [&job](const std::string& option, const std::string& text) {
        job.seed = static_cast<std::uint64_t>(parseCount(option, text, 0, std::numeric_limits<int>::max()));
      },
      "another number gives other noise (default: 0)");
}

}  // namespace

void addReferenceOptions(CLI::App& app, ReferenceJob& job) {
  addOutputOption(app, job.output, "FILE",
                  "picture to write: .exr (linear float) with all layers and\ntheir standard errors");
  addSizeOption(app, job.size);
  addCameraOptions(app, job.camera);
  addIntegrandOptions(app, job);
  addSamplingOptions(app, job);
  OptionGroup(app, "Shading")
      .value(
          "--normals", "SOURCE",
          [&job](const std::string& option, const std::string& text) {
            job.normals = parseChoice<ReferenceNormals>(
                option, text, {{"data", ReferenceNormals::data}, {"exact", ReferenceNormals::exact}});
          },
          "smoothed gradient of the data, as render shows it, or\nexact gradient in the cell (default: data)");
  addAlbedoOption(app, job.albedo);
  addBackgroundOption(app, job.background, job.transparent);
}

}  // namespace isolume
