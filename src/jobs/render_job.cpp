#include "src/jobs/render_job.h"

#include <future>

#include "raymarch/context.h"
#include "src/io/image.h"
#include "src/io/image_codec.h"
#include "src/io/output_file.h"
#include "src/io/vdb.h"
#include "src/jobs/frame_image.h"
#include "src/jobs/provenance.h"
#include "src/jobs/report.h"

namespace isolume {
namespace {

constexpr int kDefaultBitDepth = 8;

Shading shadingOf(OcclusionMethod method) {
  switch (method) {
    case OcclusionMethod::singh10:
    case OcclusionMethod::octants:
      return Shading::octants;
    case OcclusionMethod::ordinates:
      return Shading::openness;
    case OcclusionMethod::none:
      return Shading::local;
  }
  return Shading::local;
}

/// A file of fields is drawn from what it holds, its octants, if nothing else was asked for.
OcclusionSetting occlusionOf(const RenderJob& job) {
  OcclusionRequest request = job.occlusion;
  if (job.screen.estimator) request.method = OcclusionMethod::none;
  if (!givenOption(request) && isFieldsFile(job.surface.input)) request.method = OcclusionMethod::octants;
  return chooseOcclusion(request);
}

RenderSettings renderSettings(const RenderJob& job, const OcclusionSetting& occlusion) {
  RenderSettings settings;
  settings.size = job.size;
  settings.samples = job.samples;
  settings.shading = shadingOf(occlusion.method);
  settings.normals = job.normals;
  settings.occlusionOffsetVoxels = static_cast<float>(occlusion.offset);
  settings.gamma = static_cast<float>(job.gamma);
  settings.albedo = job.albedo.linear;
  settings.background = glm::vec4(job.background.linear, job.transparent ? 0.0f : 1.0f);
  settings.layers = job.layers.any();
  return settings;
}

SceneFields sceneFields(const SweptScene& scene, NormalSource normals) {
  SceneFields fields;
  fields.worldFromGrid = scene.surface.worldFromGrid;
  fields.level = scene.surface.level.view();
  if (normals == NormalSource::distance) fields.distance = scene.swept.distance.view();
  for (std::size_t i = 0; i < fields.octants.size(); ++i)
    if (!scene.swept.visibility.packed[i].empty()) fields.octants[i] = scene.swept.visibility.packed[i].view();
  if (!scene.openness.empty()) fields.openness = scene.openness.view();
  return fields;
}

/// What the scene takes on the GPU, as of raymarch/renderer.h.
std::size_t textureBytes(const SceneFields& fields) {
  constexpr std::size_t kLevelBytes = 4, kClearanceBytes = 1, kDistanceBytes = 2, kOctantsBytes = 8, kOpennessBytes = 2;
  return fields.level.count() *
         (kLevelBytes + kClearanceBytes + (fields.distance.data ? kDistanceBytes : 0) +
          (fields.octants[0].data ? kOctantsBytes : 0) + (fields.openness.data ? kOpennessBytes : 0));
}

}  // namespace

void runRenderJob(const RenderJob& job) {
  checkWritable(job.output);
  if (!job.run.report.empty()) checkWritable(job.run.report);
  limitThreads(job.run.threads);
  preloadImageCodec();
  StageLog log(job.run);

  FieldNeeds needs{.distance = job.normals == NormalSource::distance};
  const OcclusionSetting occlusion = occlusionOf(job);
  const Shading shading = shadingOf(occlusion.method);
  if (shading == Shading::octants) needs.visibility = VisibilityStorage::rgba8;
  if (shading == Shading::openness) needs.openness = occlusion.ordinates;
  const SweptScene scene = loadScene(job.surface, needs, log);
  // Beside drawing: it reads the files once more and uses one core.
  std::future<std::string> checksums = std::async(std::launch::async, checksumText, scene.surface.files);

  log.begin("upload", "preparing OpenGL");
  const std::unique_ptr<Context> context = makeContext(job.backend);
  Renderer renderer(*context);
  const SceneFields fields = sceneFields(scene, job.normals);
  renderer.upload(fields);
  log.end(textureBytes(fields));

  log.begin("frame", "drawing");
  const double aspect = static_cast<double>(job.size.x) / job.size.y;
  const Camera camera = chooseCamera(job.camera, solidCorners(scene.surface), aspect);
  RenderSettings settings = renderSettings(job, occlusion);
  settings.screen = chooseScreen(job.screen, solidCorners(scene.surface));
  const Frame frame = renderer.render(camera, settings);
  log.end(frameBytes(frame));

  log.begin("write", "writing " + job.output);
  const Provenance provenance =
      renderProvenance(job, occlusion, settings.screen, scene.surface, camera, *context, checksums.get());
  Image image = imageOf(frame, job);
  image.metadata = provenance.metadata;
  writeImage(job.output, image, {.bitDepth = job.bitDepth.value_or(kDefaultBitDepth)});
  log.end(fileBytes(job.output));
  if (!job.run.report.empty()) writeReport(job.run.report, log, scene.surface, provenance);
  log.finish();
}

}  // namespace isolume
