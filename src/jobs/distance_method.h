// How a job computes its distances: what was asked for, what it comes to, and how outputs tell it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "sweep/occlusion_sweep.h"

namespace isolume {

struct DistanceRequest {
  std::optional<DistanceSolver> solver;  ///< default: godunov, which is faster; pictures look the same
  std::optional<DistanceStart> start;    ///< of godunov alone; default: better
  std::optional<DistanceExtent> extent;  ///< default: the job's
};

/// UsageError for a choice that the solver does not have.
SweepOptions distanceMethod(const DistanceRequest& request, VisibilityStorage storage, DistanceExtent defaultExtent);

/// The same as options of the command line: {"solver": "godunov", "start": "better", "extent": "full"}.
nlohmann::ordered_json distanceSettings(const SweepOptions& options);

/// The first option that was given, or nullptr.
const char* givenOption(const DistanceRequest& request);

}  // namespace isolume
