#include "src/jobs/reference_job.h"

#include <fmt/core.h>

#include <algorithm>
#include <future>
#include <optional>
#include <utility>

#include "src/errors.h"
#include "src/io/image.h"
#include "src/io/image_codec.h"
#include "src/io/output_file.h"
#include "src/io/vdb.h"
#include "src/jobs/environment_map.h"
#include "src/jobs/reference_camera.h"
#include "src/jobs/reference_image.h"
#include "src/jobs/report.h"

namespace isolume {
namespace {

/// Rows are traced in bands of about that many pixels: enough for many threads, and few enough for progress to move.
constexpr int kBandPixels = 16384;

/// Of the tracer's bits (sweep/reference/solid_cells.h).
constexpr std::size_t kCellsPerByte = 8;

/// A fields file holds the level too; its swept fields are of no use here.
Surface loadSurface(const SurfaceRequest& request, StageLog& log) {
  if (isFieldsFile(request.input)) return loadScene(request, {}, log).surface;
  return readSurface(request, log);
}

IntegrandSettings integrandSettings(const ReferenceJob& job, const Environment* environment) {
  IntegrandSettings settings;
  settings.integrand = job.integrand;
  settings.normals = job.normals;
  settings.radiusWorld = job.radius;
  settings.membership = job.membership.value_or(settings.membership);
  settings.lightDirection = job.lightDirection.value_or(settings.lightDirection);
  settings.lightRadiusDegrees = job.lightRadius.value_or(0);
  settings.environment = environment;
  settings.bounces = job.bounces.value_or(kDefaultBounces);
  settings.albedo = job.albedo.linear;
  settings.opacity = job.opacity.value_or(settings.opacity);
  return settings;
}

SamplingSettings samplingSettings(const ReferenceJob& job) {
  SamplingSettings settings;
  settings.rays = job.rays.value_or(settings.rays);
  settings.targetError = job.targetError;
  settings.maxRays = job.maxRays.value_or(settings.maxRays);
  settings.seed = job.seed.value_or(settings.seed);
  return settings;
}

/// Pixels that stopped at the cap.
struct Shortfall {
  std::size_t pixels = 0, hits = 0;
  double worst = 0;

  void count(const std::vector<ReferencePixel>& traced) {
    for (const ReferencePixel& pixel : traced) {
      if (pixel.hit) ++hits;
      if (!pixel.hit || pixel.estimate.converged) continue;
      ++pixels;
      for (const double error : pixel.estimate.channels.standardError) worst = std::max(worst, error);
    }
  }
};

Image tracePicture(const ReferenceJob& job, const ReferenceScene& scene, const GridFrame& frame, const Camera& camera,
                   const Environment* environment, StageLog& log) {
  const IntegrandSettings integrand = integrandSettings(job, environment);
  const SamplingSettings sampling = samplingSettings(job);
  const PixelRays rays = pixelRays(camera, job.size, frame);
  Image image = emptyReferenceImage(job);
  const int rows = std::max(1, kBandPixels / job.size.x);
  Shortfall shortfall;
  for (int y = 0; y < job.size.y; y += rows) {
    const PixelRect band{{0, y}, {job.size.x, std::min(y + rows, job.size.y)}};
    const std::vector<ReferencePixel> pixels = traceReference(scene, rays, band, integrand, sampling);
    storePixels(image, job, band, pixels, frame, camera);
    shortfall.count(pixels);
    log.progress(fmt::format("tracing {}, {} %", integrandName(job.integrand), 100 * band.end.y / job.size.y));
  }
  if (shortfall.pixels > 0)
    log.tell("warning",
             fmt::format("--stderr {}: {} of {} pixels did not reach it with {} rays; the largest error is {:.3g}",
                         *job.targetError, shortfall.pixels, shortfall.hits, sampling.maxRays, shortfall.worst));
  return image;
}

}  // namespace

void runReferenceJob(const ReferenceJob& job) {
  checkWritable(job.output);
  if (!job.run.report.empty()) checkWritable(job.run.report);
  limitThreads(job.run.threads);
  preloadImageCodec();
  StageLog log(job.run);

  const Surface surface = loadSurface(job.surface, log);
  std::future<std::string> checksums = std::async(std::launch::async, checksumText, surface.files);
  std::optional<Environment> environment;
  std::string environmentChecksum;
  if (!job.environment.empty()) {
    log.begin("environment", "reading " + job.environment);
    EnvironmentMap map = readEnvironmentMap(job.environment);
    environment.emplace(map.size, std::move(map.radiance));
    environmentChecksum = checksumText({job.environment});
    log.end(environment->memoryBytes());
  }

  log.begin("cells", "finding the cells of the surface");
  const GridFrame frame = makeGridFrame(surface.worldFromGrid);
  const SurfaceTracer tracer(surface.level.view());
  log.end(surface.level.count() / kCellsPerByte);

  log.begin("trace", fmt::format("tracing {}", integrandName(job.integrand)));
  const double aspect = static_cast<double>(job.size.x) / job.size.y;
  const Camera camera = chooseCamera(job.camera, solidCorners(surface), aspect);
  Image image =
      tracePicture(job, {tracer, frame.worldFromAxes}, frame, camera, environment ? &*environment : nullptr, log);
  log.end(image.channels.size() * image.channels.front().values.size() * sizeof(float));

  log.begin("write", "writing " + job.output);
  const Provenance provenance = referenceProvenance(job, surface, camera, checksums.get(), environmentChecksum);
  image.metadata = provenance.metadata;
  writeImage(job.output, image);
  log.end(fileBytes(job.output));
  if (!job.run.report.empty()) writeReport(job.run.report, log, surface, provenance);
  log.finish();
}

}  // namespace isolume
