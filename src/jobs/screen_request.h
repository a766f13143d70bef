// Screen-space occlusion as a job asks for it: what was given, what it comes to, and how outputs tell it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "raymarch/screen/screen_occlusion.h"
#include "src/jobs/light_request.h"
#include "src/jobs/surface.h"

namespace isolume {

/// Where nothing is said, the defaults of ScreenOcclusion hold.
struct ScreenRequest {
  std::optional<ScreenEstimator> estimator = {};
  std::optional<double> radius = {};  ///< world units; default: kScreenRadiusShare of the solid's longest side
  std::optional<int> samples = {};
  std::optional<Membership> membership = {};
  std::optional<Characteristic> surface = {};
  std::optional<int> interleaving = {};  ///< 1: off
  std::optional<bool> filter = {};
  std::optional<bool> normalisedBySamples = {};
  std::optional<bool> clampedToTangent = {};
  std::optional<bool> indirect = {};
  std::optional<double> thickness = {};     ///< world units
  std::optional<double> secondRadius = {};  ///< share of the radius
  std::optional<BentSource> bentFrom = {};
  std::optional<BentLight> bent = {};
  std::optional<bool> geometricTerm = {};
  std::optional<int> steps = {};
};

/// Occlusion within a tenth of a solid tells its parts from each other and costs no estimator its assumption that rays
/// meet the solid once.
inline constexpr double kScreenRadiusShare = 0.1;

/// UsageError, one line, for options that the estimator does not read, or that are there without one. `swept`: an
/// option of openness by sweeps that was given, or nullptr.
void checkScreenRequest(const ScreenRequest& request, const char* swept);

/// UsageError for lights that the estimator does not read; nothing without an estimator.
void checkScreenLight(const ScreenRequest& request, const LightingRequest& light);

/// Whether bent normals come from the volume's sweeps.
bool sweepsBent(const ScreenRequest& request);

/// `corners` as of solidCorners(); they are world points, so the sides of the box are lengths. Nothing without
/// estimator.
std::optional<ScreenOcclusion> chooseScreen(const ScreenRequest& request, const std::array<glm::dvec3, 8>& corners);

/// As options of the command line: {"occlusion": "gtao", "ao-radius": 2.5, ...}.
nlohmann::ordered_json screenSettings(const ScreenOcclusion& screen);

const char* characteristicName(Characteristic surface);

}  // namespace isolume
