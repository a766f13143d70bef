// report_scene: a volume for a peer that reads no such file: its levels as raw float32 (x fastest, > 0 inside), and as
// JSON where they stand in the world and the camera that `isolume render` takes for such a picture.
#include <bit>
#include <limits>
#include <string_view>
#include <vector>

#include "raymarch/view.h"
#include "src/cli/parse_value.h"
#include "src/cli/surface_options.h"
#include "src/io/output_file.h"
#include "src/jobs/camera_choice.h"
#include "src/jobs/surface.h"
#include "tests/bench/report/report_program.h"

namespace isolume::bench {
namespace {

struct Options {
  SurfaceRequest surface;
  std::string size = "512x512", levels;
  RunOptions run;
};

nlohmann::ordered_json list(glm::dvec3 v) { return {v.x, v.y, v.z}; }

nlohmann::ordered_json work(const Options& options) {
  StageLog log(options.run);
  const Surface surface = readSurface(options.surface, log);
  const glm::ivec2 size = parseSize("--size", options.size);
  const Camera camera = chooseCamera({}, solidCorners(surface), static_cast<double>(size.x) / size.y);
  const GridFrame frame = makeGridFrame(surface.worldFromGrid);
  static_assert(std::endian::native == std::endian::little, "raw samples are written as they lie in memory");
  const GridView<const float> level = surface.level.view();
  std::vector<float> samples(level.data, level.data + level.count());
  // A level of 0 is outside; others take it for inside, so it becomes the least that is below 0.
  for (float& sample : samples)
    if (sample == 0) sample = -std::numeric_limits<float>::min();
  writeFileAtomically(options.levels,
                      std::string_view(reinterpret_cast<const char*>(samples.data()), samples.size() * sizeof(float)));
  return {{"dims", {level.size.x, level.size.y, level.size.z}},
          {"spacing", list(frame.spacing)},
          {"origin", list(glm::dvec3(surface.worldFromGrid[3]))},
          {"axes", {list(frame.worldFromAxes[0]), list(frame.worldFromAxes[1]), list(frame.worldFromAxes[2])}},
          {"eye", list(camera.eye)},
          {"target", list(camera.target)},
          {"up", list(camera.up)},
          {"fov", camera.fovDegrees},
          {"size", {size.x, size.y}}};
}

}  // namespace
}  // namespace isolume::bench

int main(int argc, char** argv) {
  using namespace isolume;
  bench::Options options;
  CLI::App app{"Writes a volume's levels and its camera for a peer.", "report_scene"};
  addSurfaceOptions(app, options.surface);
  addRunOptions(app, options.run);
  app.add_option("--size", options.size, "WxH, pixels");
  app.add_option("--levels", options.levels, "raw file to write")->required();
  return bench::runReportProgram(app, argc, argv, [&options] { return bench::work(options); });
}
