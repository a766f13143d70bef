#include <algorithm>
#include <memory>

#include "src/version.h"
#include "sweep/occlusion_sweep.h"
#include "tests/bench/report/distance_solver.h"

namespace isolume::bench {

SolverOrGap isolumeSolver(GridView<const float> level) {
  const auto fields = std::make_shared<SweptFields>();
  const double unit = std::min({level.spacing.x, level.spacing.y, level.spacing.z});
  const auto solve = [level, fields] {
    *fields = {};
    *fields = sweepOcclusion(level, {.visibility = VisibilityStorage::none});
  };
  const auto distanceAt = [fields, unit](int x, int y, int z) { return fields->distance.view()(x, y, z) / unit; };
  const std::string name = "Isolume sweep";
  return {name,
          DistanceSolver{name, std::string(kVersion), "sweepOcclusion, no visibility, one round of eight sweeps", solve,
                         distanceAt},
          ""};
}

}  // namespace isolume::bench
