// report_frames: the time of Isolume's first picture of a volume and of every further one, as JSON.
//
// As `isolume render` does it (default camera), but within one process, so that the same things are
// timed as for the peers: reading the file, starting a process and writing the picture are not. First picture: sweep
// (distance and occlusion), then upload (context, shaders, textures), then one frame. Everything runs once to warm up,
// then --runs times.
#include <glm/common.hpp>

#include "raymarch/context.h"
#include "raymarch/renderer.h"
#include "src/cli/parse_value.h"
#include "src/cli/surface_options.h"
#include "src/jobs/camera_choice.h"
#include "src/jobs/occlusion_method.h"
#include "src/jobs/surface.h"
#include "sweep/parallel.h"
#include "tests/bench/report/report_program.h"
#include "tests/bench/report/timing.h"

namespace isolume::bench {
namespace {

struct Options {
  SurfaceRequest surface;
  std::string size = "512x512";
  std::vector<double> offsets{0, 2};
  std::vector<std::string> ordinates{"512:1"};
  int runs = 3;
  RunOptions run;
};

// What is timed of a setting: everything from the levels to the first picture, and a further picture.
struct Timed {
  OcclusionSetting setting;
  std::vector<double> sweep, upload, firstFrame, frame;
};

std::vector<Timed> settingsOf(const Options& options) {
  std::vector<Timed> all;
  for (const double offset : options.offsets)
    all.push_back({chooseOcclusion({.method = OcclusionMethod::octants, .offset = offset}), {}, {}, {}, {}});
  for (const std::string& text : options.ordinates) {
    const std::size_t colon = text.find(':');
    const int ordinates = parseCount("--ordinates", text.substr(0, colon), kLeastOrdinates, kMostOrdinates);
    const int refinement =
        colon == text.npos ? 1 : parseCount("--ordinates", text.substr(colon + 1), 1, kMostRefinement);
    all.push_back({chooseOcclusion({.ordinates = ordinates, .refinement = refinement}), {}, {}, {}, {}});
  }
  return all;
}

void runOnce(const Surface& surface, const Camera& camera, glm::ivec2 size, Timed& timed) {
  const bool octants = timed.setting.method == OcclusionMethod::octants;
  const GridView<const float> level = surface.level.view();
  SweptFields swept;
  SurfaceField openness;
  readyMemory(level.count());
  timed.sweep.push_back(secondsOf([&] {
    SweepOptions sweep;
    if (!octants) {
      sweep.visibility = VisibilityStorage::none;
      sweep.extent = DistanceExtent::band;
    }
    swept = sweepOcclusion(level, sweep);
    if (!octants) openness = sweepOpenness(level, std::as_const(swept.distance).view(), timed.setting.ordinates);
  }));
  const RenderSettings settings{.size = size,
                                .shading = octants ? Shading::octants : Shading::lights,
                                .occlusionOffsetVoxels = static_cast<float>(timed.setting.offset)};
  std::unique_ptr<Context> context;
  std::optional<Renderer> renderer;
  timed.upload.push_back(secondsOf([&] {
    SceneFields fields;
    fields.worldFromGrid = surface.worldFromGrid;
    fields.level = level;
    if (octants)
      for (std::size_t i = 0; i < fields.octants.size(); ++i) fields.octants[i] = swept.visibility.packed[i].view();
    else
      fields.lights = {{&openness}};
    context = makeContext();
    renderer.emplace(*context).upload(fields);
    renderer->prepare(settings);
  }));
  timed.firstFrame.push_back(secondsOf([&] { renderer->render(camera, settings); }));
  timed.frame.push_back(secondsOf([&] { renderer->render(camera, settings); }));
}

nlohmann::ordered_json work(const Options& options) {
  limitThreads(options.run.threads);
  StageLog log(options.run);
  const Surface surface = readSurface(options.surface, log);
  const glm::ivec2 size = parseSize("--size", options.size);
  const Camera camera = chooseCamera({}, solidCorners(surface), static_cast<double>(size.x) / size.y);
  std::vector<Timed> warmUp = settingsOf(options), settings = warmUp;
  for (Timed& each : warmUp) runOnce(surface, camera, size, each);
  for (int run = 0; run < options.runs; ++run)
    for (Timed& each : settings) runOnce(surface, camera, size, each);

  nlohmann::ordered_json report{{"voxels", surface.level.count()}, {"threads", threadCount()}};
  report["pictures"] = nlohmann::ordered_json::array();
  for (const Timed& each : settings) {
    nlohmann::ordered_json picture = occlusionSettings(each.setting);
    picture["sweep"] = each.sweep;
    picture["upload"] = each.upload;
    picture["first_frame"] = each.firstFrame;
    picture["seconds"] = each.frame;
    report["pictures"].push_back(picture);
  }
  return report;
}

}  // namespace
}  // namespace isolume::bench

int main(int argc, char** argv) {
  using namespace isolume;
  bench::Options options;
  CLI::App app{"Times Isolume's first and further pictures of one volume.", "report_frames"};
  addSurfaceOptions(app, options.surface);
  addRunOptions(app, options.run);
  app.add_option("--size", options.size, "WxH, pixels");
  app.add_option("--offsets", options.offsets, "occlusion offsets, voxels")->delimiter(',');
  app.add_option("--ordinates", options.ordinates, "settings, ORDINATES:REFINEMENT")->delimiter(',');
  app.add_option("--runs", options.runs, "timed runs")->check(CLI::PositiveNumber);
  return bench::runReportProgram(app, argc, argv, [&options] { return bench::work(options); });
}
