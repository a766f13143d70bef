#include "tests/bench/report/distance_solver.h"

namespace isolume::bench {

SolverOrGap itkMaurerSolver(GridView<const float>, int) {
  return {"ITK signed Maurer", std::nullopt, "ITK was not found by the build"};
}

}  // namespace isolume::bench
