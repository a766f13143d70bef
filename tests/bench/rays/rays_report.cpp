// report_rays: is what the renderer finds along its rays right, and how exactly, as JSON and as a row of a table.
//
// Renders a volume from random cameras (random_views.h) with the renderer itself until there are --rays rays, traces
// the same rays with the exact reference in double, and counts (ray_judge.h): missed surfaces, hits where there is
// none, and what rounding may decide either way; the distance of each hit to the isosurface; the angle between its
// normal and, at the very point of the hit, the same difference quotient in double, and the gradient of the trilinear
// interpolant within its cell. The latter jumps from cell to cell, so that it says how much the definitions differ, not
// how exact a normal is.
#include <fmt/core.h>

#include <numeric>

#include "raymarch/context.h"
#include "src/cli/surface_options.h"
#include "src/jobs/reference_camera.h"
#include "tests/bench/rays/judged_volume.h"
#include "tests/bench/rays/picture_judge.h"
#include "tests/bench/report/report_program.h"

namespace isolume::bench {
namespace {

struct Options {
  VolumeRequest volume;
  std::int64_t rays = 10'000'000;
  std::uint64_t first = 0;
  RunOptions run;
};

constexpr double kMostHits = 0.999, kMostCells = 0.99;

double mean(const std::vector<float>& values) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

nlohmann::ordered_json report(RayCounts& counts, const JudgedVolume& volume) {
  const glm::ivec3 size = volume.level.size();
  const auto within = [](std::vector<float>& values, double share) { return quantile(values, share); };
  const auto offNormals =
      std::count_if(counts.normal.begin(), counts.normal.end(), [](float angle) { return angle > kNormalTarget; });
  const auto hitsOff =
      std::count_if(counts.distance.begin(), counts.distance.end(), [](float off) { return off > kSamePlace; });
  return {{"dims", {size.x, size.y, size.z}},
          {"rays", counts.rays},
          {"hits", counts.hits},
          {"caps", counts.caps},
          {"missed", counts.missed},
          {"false_hits", counts.falseHits},
          {"ties", counts.ties},
          {"grazing", counts.grazing},
          {"hit_distance_max", within(counts.distance, 1)},
          {"hit_distance_999", within(counts.distance, kMostHits)},
          {"hits_off", hitsOff},
          {"hit_across_max", within(counts.across, 1)},
          {"hit_across_999", within(counts.across, kMostHits)},
          {"tangent", counts.tangent},
          {"normal_max", within(counts.normal, 1)},
          {"normal_999", within(counts.normal, kMostHits)},
          {"normals_off", offNormals},
          {"flat", counts.flat},
          {"cell_normal_mean", mean(counts.cellNormal)},
          {"cell_normal_99", within(counts.cellNormal, kMostCells)},
          {"wrong", counts.wrong},
          {"off_hits", counts.offHit},
          {"off_normals", counts.offNormal}};
}

nlohmann::ordered_json work(const Options& options) {
  limitThreads(options.run.threads);
  const JudgedVolume volume = readJudgedVolume(options.volume, options.run);
  const RayJudge judge(volume.level.view());
  const auto context = makeContext();
  Renderer renderer(*context);
  SceneFields fields;
  fields.worldFromGrid = worldFromGrid(volume);
  fields.level = volume.level.view();
  renderer.upload(fields);
  RenderSettings settings{.size = kViewSize, .shading = Shading::local};
  settings.layers = true;

  const GridFrame frame = makeGridFrame(fields.worldFromGrid);
  RayCounts counts;
  nlohmann::ordered_json views = nlohmann::ordered_json::array();
  for (std::uint64_t number = options.first; counts.rays < options.rays; ++number) {
    const Camera camera = randomView(volume.box, number);
    const Frame picture = renderer.render(camera, settings);
    const RayCounts view = judgePicture(judge, picture, pixelRays(camera, kViewSize, frame));
    counts.add(view);
    if (view.missed + view.falseHits > 0)
      views.push_back({{"number", number},
                       {"kind", viewKindName(static_cast<int>(number % kViewKinds))},
                       {"missed", view.missed},
                       {"false_hits", view.falseHits},
                       {"wrong", view.wrong}});
  }
  nlohmann::ordered_json result = report(counts, volume);
  result["views_with_errors"] = views;
  const auto number = [&result](const char* key) { return result[key].get<double>(); };
  fmt::print(
      stderr,
      "| {}x{}x{} | {} | {} | {} | {} | {} | {} | {:.2g} | {:.2g} | {} | {:.2g} | {:.2g} | {:.2g} | {} | {:.2f} | "
      "{:.1f} |\n",
      volume.level.size().x, volume.level.size().y, volume.level.size().z, counts.rays, counts.hits, counts.missed,
      counts.falseHits, counts.ties, counts.grazing, number("hit_distance_999"), number("hit_distance_max"),
      result["hits_off"].get<std::int64_t>(), number("hit_across_max"), number("normal_999"), number("normal_max"),
      result["normals_off"].get<std::int64_t>(), number("cell_normal_mean"), number("cell_normal_99"));
  return result;
}

}  // namespace
}  // namespace isolume::bench

int main(int argc, char** argv) {
  using namespace isolume;
  bench::Options options;
  CLI::App app{"Judges the renderer's rays against the exact reference.", "report_rays"};
  bench::addVolumeOptions(app, options.volume);
  addRunOptions(app, options.run);
  app.add_option("--rays", options.rays, "rays at least")->check(CLI::PositiveNumber);
  app.add_option("--first", options.first, "number of the first view");
  return bench::runReportProgram(app, argc, argv, [&options] { return bench::work(options); });
}
