// report_calibration: seconds and error of every setting of openness on the reference scenes, as the JSON that
// src/jobs/occlusion_calibration.json holds.
//
// Held fixed: the scenes and their size, the points (random ones of the surface, one to a random crossed cell, each
// moved to the surface along the gradient), and the exact openness there, Monte Carlo with `--rays` rays. Openness is
// read as the shaders do, at the point, with its normal. Seconds: of the sweep beyond the distance, all threads, least
// of three runs, mean over the scenes.
#include <algorithm>
#include <cmath>

#include "sweep/level.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/octants/open_plane.h"
#include "sweep/ordinates/openness_sweep.h"
#include "sweep/parallel.h"
#include "sweep/reference/reference.h"
#include "tests/bench/report/report_program.h"
#include "tests/bench/report/surface_sample.h"
#include "tests/bench/report/timing.h"
#include "tests/support/octant_openness.h"
#include "volumes/scenes.h"

namespace isolume::bench {
namespace {

constexpr const char* kScenes[] = {"corner", "gyroid", "capsules"};

struct Options {
  int size = 128, points = 2000, rays = 4096, runs = 3;
};

struct JudgedScene {
  std::string name;
  Grid<float> level, distance;
  std::vector<JudgedPoint> points;
};

JudgedScene judgedScene(const std::string& name, const Options& options) {
  JudgedScene scene{name, sampleScene(*findScene(name), options.size), {}, {}};
  makeLevel(scene.level.view(), 0, Inside::below);
  SweepOptions sweep;
  sweep.visibility = VisibilityStorage::none;
  scene.distance = sweepOcclusion(std::as_const(scene.level).view(), sweep).distance;
  scene.points = judgedPoints(std::as_const(scene.level).view(), options.points, options.rays);
  return scene;
}

// Seconds and what the setting gives at each point.
struct Measured {
  double seconds = 0;
  std::vector<double> openness;
};

Measured measureOctants(const JudgedScene& scene, double offset, bool openPlane, int runs) {
  OctantVisibility swept;
  const auto sweep = [&](VisibilityStorage storage) {
    return [&, storage] { swept = sweepVisibility(std::as_const(scene.distance).view(), storage); };
  };
  const std::vector<double> seconds = timedRuns(runs, sweep(VisibilityStorage::rgba8));
  sweep(VisibilityStorage::float32)();
  Measured measured{*std::min_element(seconds.begin(), seconds.end()), {}};
  const OpenPlaneTable plane = makeOpenPlaneTable(scene.distance.view().spacing, offset);
  for (const JudgedPoint& point : scene.points) {
    const double openness = test::octantOpenness(swept, point.position + offset * point.normal, point.normal);
    measured.openness.push_back(openPlane ? std::min(1.0, openness / plane.at(point.normal)) : openness);
  }
  return measured;
}

Measured measureOrdinates(const JudgedScene& scene, const OrdinateOptions& options, int runs) {
  SurfaceField swept;
  const std::vector<double> seconds = timedRuns(runs, [&] {
    swept = sweepOpenness(std::as_const(scene.level).view(), std::as_const(scene.distance).view(), options);
  });
  constexpr double kOpen = 65535;
  Measured measured{*std::min_element(seconds.begin(), seconds.end()), {}};
  for (const JudgedPoint& point : scene.points)
    measured.openness.push_back(wallValueAt(swept, std::as_const(scene.level).view(), point.position, point.normal) /
                                kOpen);
  return measured;
}

template <class Measure>
nlohmann::ordered_json settingOf(nlohmann::ordered_json setting, const std::vector<JudgedScene>& scenes,
                                 const Measure& measure) {
  double seconds = 0;
  auto judged = nlohmann::ordered_json::array();
  for (const JudgedScene& scene : scenes) {
    const Measured measured = measure(scene);
    seconds += measured.seconds / static_cast<double>(scenes.size());
    double squares = 0, bias = 0;
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      const double error = measured.openness[i] - scene.points[i].openness;
      squares += error * error;
      bias += error;
    }
    const auto count = static_cast<double>(scene.points.size());
    judged.push_back({{"scene", scene.name}, {"rmse", std::sqrt(squares / count)}, {"bias", bias / count}});
  }
  setting["seconds"] = seconds;
  setting["scenes"] = judged;
  return setting;
}

nlohmann::ordered_json work(const Options& options) {
  std::vector<JudgedScene> scenes;
  for (const char* name : kScenes) scenes.push_back(judgedScene(name, options));
  auto settings = nlohmann::ordered_json::array();
  for (const auto& [name, offset] : {std::pair{"singh10", 0.0}, {"octants", 2.0}})
    for (const bool openPlane : {false, true}) {
      nlohmann::ordered_json setting{{"occlusion", name}, {"occlusion-offset", offset}};
      if (openPlane) setting["octant-terms"] = "open-plane";
      settings.push_back(settingOf(setting, scenes, [&](const JudgedScene& scene) {
        return measureOctants(scene, offset, openPlane, options.runs);
      }));
    }
  for (const int refinement : {1, 2})
    for (const int ordinates : {32, 64, 72, 128, 256, 512, 1024, 2048, 4096})
      settings.push_back(settingOf({{"occlusion", "ordinates"}, {"ordinates", ordinates}, {"refinement", refinement}},
                                   scenes, [&](const JudgedScene& scene) {
                                     return measureOrdinates(scene, {.ordinates = ordinates, .refinement = refinement},
                                                             options.runs);
                                   }));
  return {{"size", options.size},
          {"points", options.points},
          {"rays", options.rays},
          {"threads", threadCount()},
          {"settings", std::move(settings)}};
}

}  // namespace
}  // namespace isolume::bench

int main(int argc, char** argv) {
  using namespace isolume;
  bench::Options options;
  CLI::App app{"Measures every setting of openness on the reference scenes.", "report_calibration"};
  app.add_option("--size", options.size, "samples along each axis");
  app.add_option("--points", options.points, "of the surface, for each scene");
  app.add_option("--rays", options.rays, "of the truth at each point, a multiple of 16");
  app.add_option("--runs", options.runs, "timed runs of each");
  return bench::runReportProgram(app, argc, argv, [&options] { return bench::work(options); });
}
