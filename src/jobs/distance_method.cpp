#include "src/jobs/distance_method.h"

#include "src/errors.h"

namespace isolume {

SweepOptions distanceMethod(const DistanceRequest& request, VisibilityStorage storage, DistanceExtent defaultExtent) {
  SweepOptions options;
  options.visibility = storage;
  options.solver = request.solver.value_or(options.solver);
  options.extent = request.extent.value_or(defaultExtent);
  if (options.solver == DistanceSolver::godunov) {
    options.start = request.start.value_or(options.start);
  } else if (request.start) {
    throw UsageError("--start: expected --solver godunov beside it, found closest, which has no start values");
  }
  return options;
}

nlohmann::ordered_json distanceSettings(const SweepOptions& options) {
  nlohmann::ordered_json settings;
  const bool sweeps = options.solver == DistanceSolver::godunov;
  settings["solver"] = sweeps ? "godunov" : "closest";
  if (sweeps) settings["start"] = options.start == DistanceStart::paper ? "paper" : "better";
  settings["extent"] = options.extent == DistanceExtent::band ? "band" : "full";
  return settings;
}

const char* givenOption(const DistanceRequest& request) {
  return request.solver ? "--solver" : request.start ? "--start" : request.extent ? "--extent" : nullptr;
}

}  // namespace isolume
