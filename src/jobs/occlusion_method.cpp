#include "src/jobs/occlusion_method.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "src/errors.h"
#include "src/jobs/calibration_text.h"

namespace isolume {
namespace {

/// To two digits .05 and .02: the noise of the truth moves the third.
constexpr double kDraftError = 0.0505, kGoodError = 0.0205;
/// Where many more ordinates gain no more than that they are not worth their time.
constexpr double kBestTolerance = 1.05;
/// Voxels above the surface at which self-occlusion by Eq. 7 no longer shows, [Singh10] read at the hit.
constexpr double kOctantOffset = 2;

const std::string kPublishedTerms = "published", kOpenPlaneTerms = "open-plane";

constexpr std::array<std::pair<OcclusionMethod, const char*>, 5> kNames{{{OcclusionMethod::singh10, "singh10"},
                                                                         {OcclusionMethod::octants, "octants"},
                                                                         {OcclusionMethod::combined, "combined"},
                                                                         {OcclusionMethod::ordinates, "ordinates"},
                                                                         {OcclusionMethod::none, "none"}}};

template <class Value, std::size_t kCount>
std::string nameIn(const std::array<std::pair<Value, const char*>, kCount>& names, Value value) {
  return std::find_if(names.begin(), names.end(), [value](const auto& each) { return each.first == value; })->second;
}

constexpr std::array<std::pair<OcclusionTransport, const char*>, 3> kTransportNames{
    {{OcclusionTransport::rays, "rays"},
     {OcclusionTransport::step, "step"},
     {OcclusionTransport::characteristic, "characteristic"}}};

constexpr std::array<std::pair<Transmittance, const char*>, 3> kTransmittanceNames{
    {{Transmittance::centred, "centred"},
     {Transmittance::inside, "inner"},
     {Transmittance::insideByLength, "inner-power"}}};

const char* givenTransport(const OcclusionRequest& request) {
  return request.transport ? "--transport" : request.transmittance ? "--transmittance" : nullptr;
}

void checkTransport(const OcclusionRequest& request) {
  const char* given = givenTransport(request);
  if (given && request.method.value_or(OcclusionMethod::ordinates) != OcclusionMethod::ordinates)
    throw UsageError(fmt::format("{}: expected --occlusion ordinates beside it, or none, found {}", given,
                                 occlusionName(*request.method)));
  const OcclusionTransport transport = request.transport.value_or(OcclusionTransport::rays);
  if (transport == OcclusionTransport::rays) {
    if (request.transmittance)
      throw UsageError(fmt::format("--transmittance: expected --transport step or characteristic beside it, found {}",
                                   request.transport ? "rays" : "none"));
    return;
  }
  const std::string name = transportName(transport);
  if (request.quality || request.error)
    throw UsageError(fmt::format("{}: expected --transport rays beside it, found {}, which has no calibrated error",
                                 request.quality ? "--quality" : "--error", name));
  if (request.refinement.value_or(1) != 1)
    throw UsageError(fmt::format("--refinement: expected 1 beside --transport {}, which sweeps voxels, found {}", name,
                                 *request.refinement));
}

void checkCompatible(const OcclusionRequest& request) {
  const int knobs = (request.ordinates ? 1 : 0) + (request.quality ? 1 : 0) + (request.error ? 1 : 0);
  if (knobs > 1)
    throw UsageError("expected one of --ordinates, --quality and --error: each alone settles how exact openness is");
  if (request.refinement && !request.ordinates)
    throw UsageError("--refinement: expected --ordinates beside it; --quality and --error choose both");
  checkTransport(request);
  const char* ofOctants = request.offset ? "--occlusion-offset" : request.openPlane ? "--octant-terms" : nullptr;
  if (!request.method) {
    if (ofOctants)
      throw UsageError(fmt::format(
          "{}: expected --occlusion singh10 or octants beside it: ordinates are summed at the surface", ofOctants));
    return;
  }
  const bool readAbove = *request.method == OcclusionMethod::singh10 || *request.method == OcclusionMethod::octants;
  if (ofOctants && !readAbove)
    throw UsageError(fmt::format("{}: expected --occlusion singh10 or octants beside it, found {}", ofOctants,
                                 occlusionName(*request.method)));
  const char* knob = request.ordinates ? "--ordinates" : request.quality ? "--quality" : "--error";
  if (knobs > 0 && *request.method != OcclusionMethod::ordinates)
    throw UsageError(fmt::format("{}: expected --occlusion ordinates beside it, or none, found {}", knob,
                                 occlusionName(*request.method)));
}

using Settings = std::vector<const CalibratedSetting*>;

Settings candidates(const OcclusionRequest& request, const std::vector<CalibratedSetting>& calibration) {
  Settings found;
  for (const CalibratedSetting& each : calibration)
    if (each.setting.method == request.method.value_or(each.setting.method)) found.push_back(&each);
  return found;
}

double leastError(const Settings& settings) {
  double least = std::numeric_limits<double>::infinity();
  for (const CalibratedSetting* each : settings) least = std::min(least, each->setting.error.value());
  return least;
}

OcclusionSetting cheapest(const Settings& settings, double error) {
  const CalibratedSetting* best = nullptr;
  for (const CalibratedSetting* each : settings)
    if (each->setting.error.value() <= error && (!best || each->seconds < best->seconds)) best = each;
  if (!best)
    throw UsageError(fmt::format("--error: expected at least {:.4f}, the least calibrated one, found {}",
                                 leastError(settings), error));
  return best->setting;
}

/// Its error is that of the next calibrated setting with fewer ordinates, which is no smaller.
OcclusionSetting withOrdinates(const OcclusionRequest& request, const std::vector<CalibratedSetting>& calibration) {
  OcclusionSetting setting;
  const int ordinates = request.ordinates.value();
  setting.ordinates.ordinates = ordinates;
  setting.ordinates.refinement = request.refinement.value_or(setting.ordinates.refinement);
  int most = 0;
  for (const CalibratedSetting& each : calibration) {
    const OrdinateOptions& other = each.setting.ordinates;
    if (each.setting.method != OcclusionMethod::ordinates || other.refinement != setting.ordinates.refinement) continue;
    if (other.ordinates > ordinates || other.ordinates <= most) continue;
    most = other.ordinates;
    setting.error = each.setting.error;
  }
  return setting;
}

OcclusionSetting withTransport(const OcclusionRequest& request) {
  TransportOptions transport;
  transport.ordinates = request.ordinates.value_or(transport.ordinates);
  const bool step = *request.transport == OcclusionTransport::step;
  transport.scheme = step ? TransportScheme::step : TransportScheme::characteristic;
  transport.transmittance = request.transmittance.value_or(step ? Transmittance::inside : Transmittance::centred);
  OcclusionSetting setting;
  setting.ordinates = {.ordinates = transport.ordinates, .refinement = 1};
  setting.transport = transport;
  return setting;
}

OcclusionTransport transportOf(const OcclusionSetting& setting) {
  if (!setting.transport) return OcclusionTransport::rays;
  return setting.transport->scheme == TransportScheme::step ? OcclusionTransport::step
                                                            : OcclusionTransport::characteristic;
}

OcclusionMethod methodNamed(const std::string& name) {
  for (const auto& [method, known] : kNames)
    if (name == known) return method;
  throw std::runtime_error(fmt::format("calibration: expected a method, found '{}'", name));
}

}  // namespace

std::string occlusionName(OcclusionMethod method) { return nameIn(kNames, method); }

std::string transportName(OcclusionTransport transport) { return nameIn(kTransportNames, transport); }

std::string transmittanceName(Transmittance transmittance) { return nameIn(kTransmittanceNames, transmittance); }

bool byOctants(OcclusionMethod method) {
  return method == OcclusionMethod::singh10 || method == OcclusionMethod::octants ||
         method == OcclusionMethod::combined;
}

std::vector<CalibratedSetting> parseCalibration(const std::string& json) {
  std::vector<CalibratedSetting> calibration;
  const auto root = nlohmann::json::parse(json);
  for (const auto& entry : root.at("settings")) {
    CalibratedSetting each;
    each.setting.method = methodNamed(entry.at("occlusion"));
    if (each.setting.method == OcclusionMethod::ordinates) {
      each.setting.ordinates.ordinates = entry.at("ordinates");
      each.setting.ordinates.refinement = entry.at("refinement");
    } else {
      each.setting.offset = entry.at("occlusion-offset");
      each.setting.openPlane = entry.value("octant-terms", kPublishedTerms) == kOpenPlaneTerms;
    }
    double squares = 0;
    for (const auto& scene : entry.at("scenes")) squares += std::pow(scene.at("rmse").get<double>(), 2);
    each.setting.error = std::sqrt(squares / static_cast<double>(entry.at("scenes").size()));
    each.seconds = entry.at("seconds");
    calibration.push_back(each);
  }
  if (calibration.empty()) throw std::runtime_error("calibration: expected settings, found none");
  return calibration;
}

const std::vector<CalibratedSetting>& occlusionCalibration() {
  static const std::vector<CalibratedSetting> calibration = parseCalibration(kCalibrationText);
  return calibration;
}

OcclusionSetting chooseOcclusion(const OcclusionRequest& request, const std::vector<CalibratedSetting>& calibration) {
  checkCompatible(request);
  const OcclusionMethod method = request.method.value_or(OcclusionMethod::ordinates);
  OcclusionSetting setting;
  setting.method = method;
  if (method == OcclusionMethod::none || method == OcclusionMethod::combined) return setting;
  if (method != OcclusionMethod::ordinates) {
    setting.offset = request.offset.value_or(method == OcclusionMethod::singh10 ? 0 : kOctantOffset);
    setting.openPlane = request.openPlane.value_or(false);
    for (const CalibratedSetting& each : calibration)
      if (each.setting.method == method && each.setting.offset == setting.offset &&
          each.setting.openPlane == setting.openPlane)
        setting.error = each.setting.error;
    return setting;
  }
  if (request.transport.value_or(OcclusionTransport::rays) != OcclusionTransport::rays) return withTransport(request);
  if (request.ordinates) return withOrdinates(request, calibration);
  const Settings settings = candidates(request, calibration);
  if (request.error) return cheapest(settings, *request.error);
  const OcclusionQuality quality = request.quality.value_or(OcclusionQuality::good);
  if (quality == OcclusionQuality::best) return cheapest(settings, kBestTolerance * leastError(settings));
  return cheapest(settings, quality == OcclusionQuality::draft ? kDraftError : kGoodError);
}

void needRays(const OcclusionSetting& setting, const std::string& option) {
  if (setting.transport)
    throw UsageError(
        fmt::format("{}: expected --transport rays beside it, found {}", option, transportName(transportOf(setting))));
}

nlohmann::ordered_json occlusionSettings(const OcclusionSetting& setting) {
  nlohmann::ordered_json settings;
  settings["occlusion"] = occlusionName(setting.method);
  if (setting.method == OcclusionMethod::ordinates) {
    settings["ordinates"] = setting.ordinates.ordinates;
    if (setting.transport) {
      settings["transport"] = transportName(transportOf(setting));
      settings["transmittance"] = transmittanceName(setting.transport->transmittance);
    } else {
      settings["refinement"] = setting.ordinates.refinement;
    }
  } else if (setting.method == OcclusionMethod::singh10 || setting.method == OcclusionMethod::octants) {
    settings["occlusion-offset"] = setting.offset;
    if (setting.openPlane) settings["octant-terms"] = kOpenPlaneTerms;
  }
  return settings;
}

const char* givenOption(const OcclusionRequest& request) {
  return request.method       ? "--occlusion"
         : request.ordinates  ? "--ordinates"
         : request.quality    ? "--quality"
         : request.error      ? "--error"
         : request.refinement ? "--refinement"
         : request.offset     ? "--occlusion-offset"
         : request.openPlane  ? "--octant-terms"
                              : givenTransport(request);
}

}  // namespace isolume
