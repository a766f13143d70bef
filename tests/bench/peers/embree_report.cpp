// peer_embree: ambient occlusion by Embree on the mesh of OpenVDB, timed, and its pictures as EXR with the layers of
// `isolume render --layers all` and the same camera. JSON on standard output.
//
// First picture: mesh, then BVH, then one picture. Each is done once to warm up, then --runs times.
#include <fmt/core.h>
#include <openvdb/version.h>

#include <memory>

#include "src/cli/parse_value.h"
#include "src/cli/surface_options.h"
#include "src/io/image.h"
#include "src/io/image_codec.h"
#include "src/jobs/camera_choice.h"
#include "src/jobs/frame_image.h"
#include "src/jobs/surface.h"
#include "sweep/parallel.h"
#include "tests/bench/peers/embree_occlusion.h"
#include "tests/bench/report/report_program.h"
#include "tests/bench/report/timing.h"

namespace isolume::bench {
namespace {

struct Options {
  SurfaceRequest surface;
  std::string size = "512x512", output;
  std::vector<int> rays{16};
  int runs = 3;
  RunOptions run;
};

nlohmann::ordered_json work(const Options& options) {
  limitThreads(options.run.threads);
  preloadImageCodec();
  StageLog log(options.run);
  const Surface surface = readSurface(options.surface, log);
  const glm::ivec2 size = parseSize("--size", options.size);
  const Camera camera = chooseCamera({}, solidCorners(surface), static_cast<double>(size.x) / size.y);

  SurfaceMesh mesh;
  const auto meshSeconds = timedRuns(options.runs, [&] { mesh = meshOf(surface.level.view(), surface.worldFromGrid); });
  std::unique_ptr<EmbreeOcclusion> embree;
  const auto bvhSeconds =
      timedRuns(options.runs, [&] { embree = std::make_unique<EmbreeOcclusion>(mesh, threadCount()); });

  nlohmann::ordered_json report{{"peer", "Embree ambient occlusion"},
                                {"version", embreeVersion()},
                                {"mesh_version", OPENVDB_LIBRARY_VERSION_STRING},
                                {"threads", threadCount()},
                                {"triangles", mesh.triangles.size()},
                                {"ray_offset_of_diagonal", kRayOffset},
                                {"mesh", meshSeconds},
                                {"bvh", bvhSeconds}};
  report["pictures"] = nlohmann::ordered_json::array();
  for (const int rays : options.rays) {
    Frame frame;
    const auto seconds = timedRuns(options.runs, [&] { frame = embree->render(camera, size, rays); });
    RenderJob job;
    job.output = fmt::format("{}{}.exr", options.output, rays);
    job.layers.all = true;
    writeImage(job.output, imageOf(frame, job, {}));
    report["pictures"].push_back({{"rays", rays}, {"seconds", seconds}, {"picture", job.output}});
  }
  return report;
}

}  // namespace
}  // namespace isolume::bench

int main(int argc, char** argv) {
  using namespace isolume;
  bench::Options options;
  CLI::App app{"Ambient occlusion by Embree on the mesh of one volume.", "peer_embree"};
  addSurfaceOptions(app, options.surface);
  addRunOptions(app, options.run);
  app.add_option("--size", options.size, "WxH, pixels");
  app.add_option("--rays", options.rays, "rays per pixel, square numbers")->delimiter(',');
  app.add_option("--runs", options.runs, "timed runs")->check(CLI::PositiveNumber);
  app.add_option("-o,--output", options.output, "pictures are PREFIXn.exr, n the rays")->required();
  return bench::runReportProgram(app, argc, argv, [&options] { return bench::work(options); });
}
