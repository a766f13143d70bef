// report_distance: seconds and error of every distance solver on one shape or volume, as JSON.
//
// Held fixed: the levels, the number of threads, the voxels that are judged and their true distances
// (closest_distance.h). Each solver runs once to warm up, then all take turns, --runs times, so that a busy minute of
// the machine falls on all of them. Handing the levels over in the library's own form is not timed.
#include <cmath>

#include "src/cli/surface_options.h"
#include "src/jobs/run_options.h"
#include "src/jobs/stage_log.h"
#include "src/jobs/surface.h"
#include "sweep/parallel.h"
#include "tests/bench/report/report_program.h"
#include "tests/bench/report/shapes.h"
#include "tests/bench/report/timing.h"
#include "tests/bench/report/voxel_sample.h"

namespace isolume::bench {
namespace {

struct Options {
  SurfaceRequest surface;
  std::string shape;
  int size = 128;
  int runs = 3;
  int judged = 4000;
  RunOptions run;
};

Grid<float> readLevel(const Options& options) {
  if (!options.shape.empty()) return shapeLevel(options.shape, options.size);
  StageLog log(options.run);
  Surface surface = readSurface(options.surface, log);
  return std::move(surface.level);
}

struct TimedSolver {
  DistanceSolver solver;
  std::vector<double> seconds;
};

void takeTurns(int runs, std::size_t voxels, std::vector<TimedSolver>& solvers) {
  for (const TimedSolver& timed : solvers) timed.solver.solve();
  for (int run = 0; run < runs; ++run)
    for (TimedSolver& timed : solvers) {
      readyMemory(voxels);
      timed.seconds.push_back(secondsOf(timed.solver.solve));
    }
}

nlohmann::ordered_json judge(const TimedSolver& timed, const std::vector<JudgedVoxel>& voxels) {
  const DistanceSolver& solver = timed.solver;
  const DistanceError error = distanceError(voxels, solver);
  nlohmann::ordered_json judged{{"solver", solver.name},
                                {"version", solver.version},
                                {"call", solver.call},
                                {"seconds", timed.seconds},
                                {"mean_error", error.mean},
                                {"max_error", error.max},
                                {"mean_error_near", error.meanNear},
                                {"max_error_near", error.maxNear},
                                {"wrong_sign", error.wrongSign}};
  if (std::isfinite(solver.reach)) judged["mean_error"] = judged["max_error"] = nullptr;
  if (solver.reach < kNearVoxels) judged["mean_error_near"] = judged["max_error_near"] = nullptr;
  return judged;
}

nlohmann::ordered_json work(const Options& options) {
  limitThreads(options.run.threads);
  const Grid<float> level = readLevel(options);
  checkBorderOutside(level.view(), options.shape.empty() ? options.surface.input : options.shape);
  const std::vector<JudgedVoxel> voxels = judgedVoxels(level.view(), options.judged);
  nlohmann::ordered_json report{{"voxels", level.count()},
                                {"dims", {level.size().x, level.size().y, level.size().z}},
                                {"threads", threadCount()},
                                {"judged", voxels.size()},
                                {"truth_tolerance", kTruthTolerance},
                                {"near", kNearVoxels}};
  report["solvers"] = nlohmann::ordered_json::array();
  report["gaps"] = nlohmann::ordered_json::array();
  std::vector<TimedSolver> solvers;
  for (DistanceSolver& solver : isolumeSolvers(level.view())) solvers.push_back({std::move(solver), {}});
  for (const auto& make :
       {openVdbSolver, +[](GridView<const float> view) { return itkMaurerSolver(view, threadCount()); }}) {
    SolverOrGap made = make(level.view());
    if (made.solver)
      solvers.push_back({std::move(*made.solver), {}});
    else
      report["gaps"].push_back({{"solver", made.name}, {"reason", made.gap}});
  }
  takeTurns(options.runs, level.count(), solvers);
  for (const TimedSolver& timed : solvers) report["solvers"].push_back(judge(timed, voxels));
  return report;
}

}  // namespace
}  // namespace isolume::bench

int main(int argc, char** argv) {
  using namespace isolume;
  bench::Options options;
  CLI::App app{"Times and judges distance solvers on one volume.", "report_distance"};
  addSurfaceOptions(app, options.surface);
  addRunOptions(app, options.run);
  app.add_option("--shape", options.shape, "instead of INPUT: a shape or scene");
  app.add_option("--size", options.size, "samples along each axis of the shape")->check(CLI::Range(8, 1024));
  app.add_option("--runs", options.runs, "timed runs")->check(CLI::PositiveNumber);
  app.add_option("--judged", options.judged, "voxels judged: from anywhere, and as many near")
      ->check(CLI::PositiveNumber);
  return bench::runReportProgram(app, argc, argv, [&options] { return bench::work(options); });
}
