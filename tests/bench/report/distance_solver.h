// Distance solvers of other libraries and ours, behind one interface, so that one program times and judges them all.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sweep/grid.h"

namespace isolume::bench {

struct DistanceSolver {
  std::string name, version;
  std::string call;  ///< how it is used
  /// Runs once; what is timed. The input was handed over before, in the library's own form.
  std::function<void()> solve;
  /// The result at a sample, < 0 inside, in units of the smallest spacing. Only after solve().
  std::function<double(int x, int y, int z)> distanceAt;
  /// How far from the surface the result is a distance, in voxels; beyond, a bound, so that errors do not count.
  double reach = std::numeric_limits<double>::infinity();
};

/// `level` > 0 inside, borrowed as long as the solver lives. A solver without a value cannot work on such a grid, or is
/// not in this build: `gap` then says why.
struct SolverOrGap {
  std::string name;
  std::optional<DistanceSolver> solver;
  std::string gap;
};

/// Ours, each a choice of solver, start and extent.
std::vector<DistanceSolver> isolumeSolvers(GridView<const float> level);
SolverOrGap openVdbSolver(GridView<const float> level);
SolverOrGap itkMaurerSolver(GridView<const float> level, int threads);

}  // namespace isolume::bench
