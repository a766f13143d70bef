// What makes no sense together on the command line of `isolume reference`.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <initializer_list>

#include "src/errors.h"
#include "src/jobs/reference_job.h"

namespace isolume {
namespace {

/// An option that was given has an integrand to read it.
void needReader(bool given, const char* option, Integrand integrand, std::initializer_list<Integrand> readers) {
  if (!given || std::find(readers.begin(), readers.end(), integrand) != readers.end()) return;
  std::string names;
  for (const Integrand reader : readers) names += std::string(names.empty() ? "" : " or ") + integrandName(reader);
  throw UsageError(fmt::format("{}: expected --integrand {}, found {}", option, names, integrandName(integrand)));
}

void needOption(bool given, const char* option, Integrand integrand) {
  if (!given)
    throw UsageError(fmt::format("{}: expected with --integrand {}, found none", option, integrandName(integrand)));
}

void checkSampling(const ReferenceJob& job) {
  const auto refuse = [&job](bool given, const char* option) {
    if (given && isExact(job.integrand))
      throw UsageError(
          fmt::format("{}: expected an integrand with something to sample, found {}, which one ray decides", option,
                      integrandName(job.integrand)));
  };
  refuse(job.rays.has_value(), "--rays");
  refuse(job.targetError.has_value(), "--stderr");
  refuse(job.maxRays.has_value(), "--max-rays");
  refuse(job.seed.has_value(), "--seed");
  if (job.rays && job.targetError) throw UsageError("--rays: expected either a number of rays or --stderr, found both");
  if (job.maxRays && !job.targetError) throw UsageError("--max-rays: expected with --stderr, found it alone");
  const auto needMultiple = [](const std::optional<int>& rays, const char* option) {
    if (rays && *rays % kReplicates != 0)
      throw UsageError(fmt::format("{}: expected a multiple of {} (independent replicates tell the error), found {}",
                                   option, kReplicates, *rays));
  };
  needMultiple(job.rays, "--rays");
  needMultiple(job.maxRays, "--max-rays");
}

}  // namespace

void checkReference(const ReferenceJob& job) {
  checkCamera(job.camera);
  if (std::filesystem::path(job.output).extension() != ".exr")
    throw UsageError(fmt::format("--output: expected a name that ends in .exr, found '{}'", job.output));
  const Integrand integrand = job.integrand;
  needReader(job.radius.has_value(), "--radius", integrand, {Integrand::ambient});
  needReader(job.membership.has_value(), "--membership", integrand, {Integrand::ambient});
  if (job.membership && !job.radius) throw UsageError("--membership: expected with --radius, found it alone");
  needReader(job.lightDirection.has_value(), "--light-direction", integrand, {Integrand::shadow, Integrand::light});
  needReader(job.lightRadius.has_value(), "--light-radius", integrand, {Integrand::light});
  needReader(!job.environment.empty(), "--environment", integrand, {Integrand::environment, Integrand::bounce});
  needReader(job.bounces.has_value(), "--bounces", integrand, {Integrand::bounce});
  needReader(job.opacity.has_value(), "--opacity", integrand, {Integrand::translucent});
  if (integrand == Integrand::shadow || integrand == Integrand::light)
    needOption(job.lightDirection.has_value(), "--light-direction", integrand);
  if (integrand == Integrand::light) needOption(job.lightRadius.has_value(), "--light-radius", integrand);
  if (integrand == Integrand::translucent) needOption(job.opacity.has_value(), "--opacity", integrand);
  if (integrand == Integrand::environment) needOption(!job.environment.empty(), "--environment", integrand);
  if (job.lightDirection && !(glm::length(*job.lightDirection) > 0))
    throw UsageError("--light-direction: expected a direction, found 0,0,0");
  checkSampling(job);
}

const char* integrandName(Integrand integrand) {
  switch (integrand) {
    case Integrand::ambient:
      return "ambient";
    case Integrand::shadow:
      return "shadow";
    case Integrand::light:
      return "light";
    case Integrand::environment:
      return "environment";
    case Integrand::bounce:
      return "bounce";
    case Integrand::bent:
      return "bent";
    case Integrand::translucent:
      return "translucent";
  }
  return "";
}

const char* membershipName(Membership membership) {
  switch (membership) {
    case Membership::exponential:
      return "exponential";
    case Membership::classical:
      return "classical";
    case Membership::squareRoot:
      return "sqrt";
    case Membership::linear:
      return "linear";
    case Membership::volumetric:
      return "volumetric";
    case Membership::quartic:
      return "quartic";
  }
  return "";
}

}  // namespace isolume
