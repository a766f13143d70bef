#include <algorithm>
#include <memory>

#include "src/version.h"
#include "sweep/occlusion_sweep.h"
#include "tests/bench/report/distance_solver.h"

namespace isolume::bench {
namespace {

DistanceSolver makeSolver(const std::string& name, const std::string& call, const SweepOptions& options,
                          GridView<const float> level) {
  const auto fields = std::make_shared<SweptFields>();
  const double unit = smallestSpacing(level.spacing);
  const auto solve = [level, fields, options] {
    *fields = {};
    *fields = sweepOcclusion(level, options);
  };
  const auto distanceAt = [fields, unit](int x, int y, int z) { return fields->distance.view()(x, y, z) / unit; };
  DistanceSolver solver{name, std::string(kVersion), call, solve, distanceAt};
  if (options.extent == DistanceExtent::band) solver.reach = options.bandVoxels;
  return solver;
}

}  // namespace

std::vector<DistanceSolver> isolumeSolvers(GridView<const float> level) {
  constexpr VisibilityStorage kNone = VisibilityStorage::none;
  return {
      makeSolver("Isolume closest", "`--solver closest --extent full`: points carried by vector passes",
                 {.visibility = kNone, .solver = isolume::DistanceSolver::closest}, level),
      makeSolver("Isolume closest, band", "`fields --solver closest --extent band`: 3 voxels about the surface",
                 {.visibility = kNone, .solver = isolume::DistanceSolver::closest, .extent = DistanceExtent::band},
                 level),
      makeSolver("Isolume closest, picture", "`render --solver closest`: 1 voxel about the surface",
                 {.visibility = kNone,
                  .solver = isolume::DistanceSolver::closest,
                  .extent = DistanceExtent::band,
                  .bandVoxels = kSurfaceBandVoxels},
                 level),
      makeSolver("Isolume sweep", "`--solver godunov --extent full`: one round of eight sweeps, better start",
                 {.visibility = kNone, .solver = isolume::DistanceSolver::godunov}, level),
      makeSolver("Isolume sweep, band", "`fields --solver godunov --extent band`: 3 voxels about the surface",
                 {.visibility = kNone, .solver = isolume::DistanceSolver::godunov, .extent = DistanceExtent::band},
                 level),
      makeSolver("Isolume sweep, picture", "`render --solver godunov`: 1 voxel about the surface",
                 {.visibility = kNone,
                  .solver = isolume::DistanceSolver::godunov,
                  .extent = DistanceExtent::band,
                  .bandVoxels = kSurfaceBandVoxels},
                 level),
      makeSolver("Isolume sweep, paper's start", "`--solver godunov --start paper --extent full`: as published",
                 {.visibility = kNone, .solver = isolume::DistanceSolver::godunov, .start = DistanceStart::paper},
                 level),
  };
}

}  // namespace isolume::bench
