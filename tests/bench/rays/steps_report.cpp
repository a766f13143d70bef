// report_steps: how many steps a ray takes by different ways to trace, and how many rays they get wrong, as JSON and as
// a table.
//
// On the CPU (counts, not times), along the same random views as report_rays, thinned to --rays rays that enter the
// grid. The ways: the shader's own text (shader_march.h), and sphere tracing by a solver's distance as it is, by that
// distance certified, and by the distance to the nearest mixed cell, the latter two also with over-relaxed steps
// (sphere_tracers.h), and leaps through cubes of cells ahead of the ray (octant_cubes.h). A wrong ray is a missed or
// false hit (ray_judge.h); a raw distance stops short of the surface, so there a hit is wrong only if it is more than
// kRawWrong off.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "src/cli/surface_options.h"
#include "src/jobs/reference_camera.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/half.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/parallel.h"
#include "tests/bench/rays/judged_volume.h"
#include "tests/bench/rays/octant_cubes.h"
#include "tests/bench/rays/picture_judge.h"
#include "tests/bench/rays/shader_march.h"
#include "tests/bench/rays/sphere_tracers.h"
#include "tests/bench/report/report_program.h"
#include "tests/reference/brute_force.h"

namespace isolume::bench {
namespace {

struct Options {
  VolumeRequest volume;
  std::int64_t rays = 1'000'000;
  RunOptions run;
};

/// Voxels.
constexpr double kRawWrong = 0.5;

/// Everything that some way to trace reads; distances in voxels.
struct Fields {
  GridView<const float> level;
  Grid<float> godunov, closest, fromHalves, cells;
  FieldBound ofGodunov, ofClosest, ofHalves;
  ShaderMarch march;
  OctantCubes octants;

  explicit Fields(GridView<const float> data)
      : level(data),
        godunov(sweepOcclusion(data, {.visibility = VisibilityStorage::none}).distance),
        closest(closestDistance(data)),
        fromHalves(data.size, data.spacing),
        cells(cellLowerBound(data)),
        ofGodunov(certifyField(data, godunov.view())),
        ofClosest(certifyField(data, closest.view())),
        march(data),
        octants(data) {
    Grid<std::uint16_t> halves(data.size, data.spacing);
    for (std::size_t i = 0; i < halves.count(); ++i) {
      halves.data()[i] = halfFromFloat(closest.data()[i]);
      fromHalves.data()[i] = floatFromHalf(halves.data()[i]);
    }
    ofHalves = certifyField(data, GridView<const std::uint16_t>(halves.view()));
  }
};

struct PictureRay {
  GridRay ray;
  glm::ivec2 pixel;
};

struct Way {
  std::string name;
  std::function<TracedRay(const shader::FrameUniforms&, const PictureRay&)> trace;
  bool raw = false;
};

std::vector<Way> waysToTrace(const Fields& fields) {
  std::vector<Way> ways;
  ways.push_back(
      {"clearance leaps (the shader)", [&fields](const shader::FrameUniforms& uniforms, const PictureRay& ray) {
         return fields.march.trace(uniforms, ray.pixel, kViewSize);
       }});
  ways.push_back({"raw godunov",
                  [&fields](const shader::FrameUniforms&, const PictureRay& ray) {
                    return traceRaw(fields.level, fields.godunov.view(), ray.ray);
                  },
                  true});
  ways.push_back({"octant cubes", [&fields](const shader::FrameUniforms&, const PictureRay& ray) {
                    return fields.octants.trace(ray.ray);
                  }});
  const auto certified = [&](const std::string& name, const PointBound& bound, double omega) {
    ways.push_back({name, [&fields, bound, omega](const shader::FrameUniforms&, const PictureRay& ray) {
                      return traceCertified(fields.level, bound, ray.ray, omega);
                    }});
  };
  certified("godunov certified", fieldPointBound(fields.godunov.view(), fields.ofGodunov), 1);
  certified("closest certified, half", fieldPointBound(fields.fromHalves.view(), fields.ofHalves), 1);
  for (const double omega : {1.0, 1.2, 1.4, 1.6, 1.8})
    certified(fmt::format("closest certified, omega {}", omega),
              fieldPointBound(fields.closest.view(), fields.ofClosest), omega);
  for (const double omega : {1.0, 1.2, 1.4, 1.6, 1.8})
    certified(fmt::format("mixed cells, omega {}", omega), cellPointBound(fields.cells.view()), omega);
  return ways;
}

struct Counts {
  std::vector<float> steps, solves;
  std::int64_t missed = 0, falseHits = 0;

  void add(const Counts& other) {
    steps.insert(steps.end(), other.steps.begin(), other.steps.end());
    solves.insert(solves.end(), other.solves.begin(), other.solves.end());
    missed += other.missed, falseHits += other.falseHits;
  }
};

void countRaw(const RayJudge& judge, const GridRay& ray, const TracedRay& traced, Counts& counts) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto hit = judge.tracer().firstHit(ray);
  const double wanted = hit ? hit->t : kNever;
  const glm::dvec3 scale = judge.scale();
  const double got = traced.found ? glm::dot((*traced.found - ray.origin) * scale, ray.direction * scale) : kNever;
  counts.missed += got > wanted + kRawWrong;
  counts.falseHits += got < wanted - kRawWrong;
}

void count(const RayJudge& judge, const Way& way, const shader::FrameUniforms& uniforms, const PictureRay& ray,
           Counts& counts) {
  const TracedRay traced = way.trace(uniforms, ray);
  counts.steps.push_back(static_cast<float>(traced.steps));
  counts.solves.push_back(static_cast<float>(traced.solves));
  if (way.raw) return countRaw(judge, ray.ray, traced, counts);
  const Verdict verdict = judge.judge(ray.ray, traced.found);
  counts.missed += verdict == Verdict::missed;
  counts.falseHits += verdict == Verdict::falseHit;
}

// Of the view with that number, every `stride`-th pixel along each axis whose ray enters the grid.
std::vector<PictureRay> raysOfView(const PixelRays& rays, const RayJudge& judge, int stride) {
  std::vector<PictureRay> all;
  for (int y = stride / 2; y < kViewSize.y; y += stride)
    for (int x = stride / 2; x < kViewSize.x; x += stride) {
      const GridRay ray = pixelRay(rays, {x, y}, judge.scale());
      if (test::boxSpan(judge.tracer().level().size, ray)) all.push_back({ray, {x, y}});
    }
  return all;
}

double mean(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

nlohmann::ordered_json rowOf(const Way& way, Counts& counts) {
  constexpr double kMost = 0.99;
  nlohmann::ordered_json row{{"way", way.name},
                             {"mean", mean(counts.steps)},
                             {"p99", quantile(counts.steps, kMost)},
                             {"max", quantile(counts.steps, 1)},
                             {"solves", mean(counts.solves)},
                             {"missed", counts.missed},
                             {"false_hits", counts.falseHits}};
  fmt::print(stderr, "| {} | {:.1f} | {:.0f} | {:.0f} | {:.2f} | {} | {} |\n", way.name, row["mean"].get<double>(),
             row["p99"].get<double>(), row["max"].get<double>(), row["solves"].get<double>(), counts.missed,
             counts.falseHits);
  return row;
}

nlohmann::ordered_json work(const Options& options) {
  limitThreads(options.run.threads);
  const JudgedVolume volume = readJudgedVolume(options.volume, options.run);
  const RayJudge judge(volume.level.view());
  const Fields fields(volume.level.view());
  const std::vector<Way> ways = waysToTrace(fields);
  const GridFrame frame = makeGridFrame(worldFromGrid(volume));

  std::vector<Counts> counts(ways.size());
  std::int64_t rays = 0;
  for (std::uint64_t number = 0; rays < options.rays; ++number) {
    constexpr int kStride = 4;
    const Camera camera = randomView(volume.box, number);
    const shader::FrameUniforms uniforms = rayUniforms(camera, kViewSize, frame, volume.level.size());
    const std::vector<PictureRay> chosen = raysOfView(pixelRays(camera, kViewSize, frame), judge, kStride);
    constexpr std::size_t kChunk = 256;
    std::vector<std::vector<Counts>> chunks((chosen.size() + kChunk - 1) / kChunk, std::vector<Counts>(ways.size()));
    parallelFor(chunks.size(), [&](std::size_t chunk) {
      for (std::size_t i = chunk * kChunk; i < std::min(chosen.size(), (chunk + 1) * kChunk); ++i)
        for (std::size_t way = 0; way < ways.size(); ++way)
          count(judge, ways[way], uniforms, chosen[i], chunks[chunk][way]);
    });
    for (const std::vector<Counts>& chunk : chunks)
      for (std::size_t way = 0; way < ways.size(); ++way) counts[way].add(chunk[way]);
    rays += static_cast<std::int64_t>(chosen.size());
  }

  nlohmann::ordered_json report{{"rays", rays},
                                {"godunov_shift", fields.ofGodunov.shift},
                                {"godunov_slope", fields.ofGodunov.slope},
                                {"closest_shift", fields.ofClosest.shift},
                                {"closest_slope", fields.ofClosest.slope},
                                {"half_shift", fields.ofHalves.shift},
                                {"half_slope", fields.ofHalves.slope}};
  report["ways"] = nlohmann::ordered_json::array();
  for (std::size_t way = 0; way < ways.size(); ++way) report["ways"].push_back(rowOf(ways[way], counts[way]));
  return report;
}

}  // namespace
}  // namespace isolume::bench

int main(int argc, char** argv) {
  using namespace isolume;
  bench::Options options;
  CLI::App app{"Counts the steps of rays by different ways to trace.", "report_steps"};
  bench::addVolumeOptions(app, options.volume);
  addRunOptions(app, options.run);
  app.add_option("--rays", options.rays, "rays that enter the grid, at least")->check(CLI::PositiveNumber);
  return bench::runReportProgram(app, argc, argv, [&options] { return bench::work(options); });
}
