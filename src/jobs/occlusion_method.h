// How a job computes openness: what was asked for, what it comes to by the calibration, and how outputs tell it.
//
// The calibration (occlusion_calibration.json beside this file) is what `scripts/report` measured last: for each
// setting its seconds and its RMSE on reference scenes against exact rays. The error of a setting is the largest of
// them.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sweep/ordinates/openness_sweep.h"
#include "sweep/transport/openness_transport.h"

namespace isolume {

enum class OcclusionMethod {
  singh10,    ///< eight octants, read at the hit, as published
  octants,    ///< the same sweeps, read above the surface
  combined,   ///< their mean as one number, the geometry term dropped ([Singh10] Fig. 6), read at the hit
  ordinates,  ///< many directions, summed at the surface
  none,       ///< a head light
};

/// Bounds on the calibrated error: draft .05, good .02; best is the least that there is, or within a twentieth of it.
enum class OcclusionQuality { draft, good, best };

/// How ordinates go through the grid.
enum class OcclusionTransport {
  rays,            ///< parallel rays of one bit (sweep/ordinates)
  step,            ///< light from voxel to voxel (sweep/transport), TransportScheme::step
  characteristic,  ///< TransportScheme::characteristic
};

struct OcclusionRequest {
  std::optional<OcclusionMethod> method = {};    ///< default: what the others lead to, at last ordinates
  std::optional<int> ordinates = {};             ///< at most one of these three
  std::optional<OcclusionQuality> quality = {};  ///< default: good
  std::optional<double> error = {};              ///< the cheapest setting whose calibrated error is at most that; > 0
  std::optional<int> refinement = {};            ///< lattice points per voxel; with `ordinates`
  std::optional<double> offset = {};             ///< voxels above the surface; singh10 and octants
  std::optional<bool> openPlane = {};            ///< divided by what an open plane gives; singh10 and octants
  std::optional<OcclusionTransport> transport = {};  ///< of ordinates; default: rays
  std::optional<Transmittance> transmittance = {};   ///< default: inside with step, centred with characteristic
};

struct OcclusionSetting {
  OcclusionMethod method = OcclusionMethod::ordinates;
  OrdinateOptions ordinates;
  double offset = 0;                          ///< of octants, voxels
  bool openPlane = false;                     ///< of octants, sweep/octants/open_plane.h
  std::optional<TransportOptions> transport;  ///< with ordinates: in place of rays, and as many
  std::optional<double> error;                ///< calibrated, if the setting was
};

struct CalibratedSetting {
  OcclusionSetting setting;  ///< with its error
  double seconds = 0;
};

/// Throws std::runtime_error for a text that is no calibration.
std::vector<CalibratedSetting> parseCalibration(const std::string& json);
/// That of the program.
const std::vector<CalibratedSetting>& occlusionCalibration();

/// UsageError for options that contradict each other, and for an error below the least that is calibrated.
OcclusionSetting chooseOcclusion(const OcclusionRequest& request,
                                 const std::vector<CalibratedSetting>& calibration = occlusionCalibration());

/// UsageError for what only rays serve, `option`, beside another transport.
void needRays(const OcclusionSetting& setting, const std::string& option);

/// As options of the command line, and the calibrated error: {"occlusion": "ordinates", "ordinates": 512, ...}.
nlohmann::ordered_json occlusionSettings(const OcclusionSetting& setting);

std::string occlusionName(OcclusionMethod method);
std::string transportName(OcclusionTransport transport);
std::string transmittanceName(Transmittance transmittance);

/// Whether eight octants are swept.
bool byOctants(OcclusionMethod method);

/// The first option that was given, or nullptr.
const char* givenOption(const OcclusionRequest& request);

}  // namespace isolume
