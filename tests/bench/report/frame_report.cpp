// report_frames: the time of Isolume's first picture of a volume and of every further one, as JSON.
//
// As `isolume render` does it (default camera, shading singh10), but within one process, so that the same things are
// timed as for the peers: reading the file, starting a process and writing the picture are not. First picture: sweep
// (distance and octants), then upload (context, shaders, textures), then one frame. Everything runs once to warm up,
// then --runs times.
#include <glm/common.hpp>

#include "raymarch/context.h"
#include "raymarch/renderer.h"
#include "src/cli/parse_value.h"
#include "src/cli/surface_options.h"
#include "src/jobs/camera_choice.h"
#include "src/jobs/surface.h"
#include "sweep/parallel.h"
#include "tests/bench/report/report_program.h"
#include "tests/bench/report/timing.h"

namespace isolume::bench {
namespace {

struct Options {
  SurfaceRequest surface;
  std::string size = "512x512";
  std::vector<double> offsets{2};
  int runs = 3;
  RunOptions run;
};

struct Seconds {
  std::vector<double> sweep, upload, firstFrame;
  std::vector<std::vector<double>> frames;  ///< for each offset
};

SceneFields sceneFields(const Surface& surface, const SweptFields& swept) {
  SceneFields fields;
  fields.worldFromGrid = surface.worldFromGrid;
  fields.level = surface.level.view();
  for (std::size_t i = 0; i < fields.octants.size(); ++i) fields.octants[i] = swept.visibility.packed[i].view();
  return fields;
}

void runOnce(const Options& options, const Surface& surface, const Camera& camera, glm::ivec2 size, Seconds& seconds) {
  SweptFields swept;
  seconds.sweep.push_back(secondsOf([&] { swept = sweepOcclusion(surface.level.view()); }));
  std::unique_ptr<Context> context;
  std::optional<Renderer> renderer;
  seconds.upload.push_back(secondsOf([&] {
    context = makeContext();
    renderer.emplace(*context).upload(sceneFields(surface, swept));
  }));
  RenderSettings settings{.size = size, .occlusionOffsetVoxels = static_cast<float>(options.offsets.front())};
  seconds.firstFrame.push_back(secondsOf([&] { renderer->render(camera, settings); }));
  for (std::size_t i = 0; i < options.offsets.size(); ++i) {
    settings.occlusionOffsetVoxels = static_cast<float>(options.offsets[i]);
    seconds.frames[i].push_back(secondsOf([&] { renderer->render(camera, settings); }));
  }
}

nlohmann::ordered_json work(const Options& options) {
  limitThreads(options.run.threads);
  StageLog log(options.run);
  const Surface surface = readSurface(options.surface, log);
  const glm::ivec2 size = parseSize("--size", options.size);
  const Camera camera = chooseCamera({}, solidCorners(surface), static_cast<double>(size.x) / size.y);
  Seconds warmUp, seconds;
  warmUp.frames.resize(options.offsets.size());
  seconds.frames.resize(options.offsets.size());
  runOnce(options, surface, camera, size, warmUp);
  for (int run = 0; run < options.runs; ++run) runOnce(options, surface, camera, size, seconds);

  nlohmann::ordered_json report{{"voxels", surface.level.count()},
                                {"threads", threadCount()},
                                {"sweep", seconds.sweep},
                                {"upload", seconds.upload},
                                {"first_frame", seconds.firstFrame}};
  report["frames"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < options.offsets.size(); ++i)
    report["frames"].push_back({{"offset", options.offsets[i]}, {"seconds", seconds.frames[i]}});
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
  app.add_option("--runs", options.runs, "timed runs")->check(CLI::PositiveNumber);
  return bench::runReportProgram(app, argc, argv, [&options] { return bench::work(options); });
}
