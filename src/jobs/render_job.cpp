#include "src/jobs/render_job.h"

#include <fmt/core.h>

#include <cmath>

#include <future>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "raymarch/context.h"
#include "raymarch/view.h"
#include "src/errors.h"
#include "src/io/image.h"
#include "src/io/image_codec.h"
#include "src/io/output_file.h"
#include "src/io/vdb.h"
#include "src/jobs/environment_map.h"
#include "src/jobs/frame_image.h"
#include "src/jobs/lighting.h"
#include "src/jobs/provenance.h"
#include "src/jobs/report.h"
#include "src/jobs/screen_light.h"

namespace isolume {
namespace {

constexpr int kDefaultBitDepth = 8;

Shading shadingOf(OcclusionMethod method) {
  switch (method) {
    case OcclusionMethod::singh10:
    case OcclusionMethod::octants:
      return Shading::octants;
    case OcclusionMethod::combined:
    case OcclusionMethod::ordinates:
      return Shading::lights;
    case OcclusionMethod::none:
      return Shading::local;
  }
  return Shading::local;
}

/// A file of fields is drawn from what it holds, its octants, if nothing else was asked for.
OcclusionSetting occlusionOf(const RenderJob& job) {
  OcclusionRequest request = job.occlusion;
  if (sweepsBent(job.screen)) return chooseOcclusion(request);
  if (job.screen.estimator) request.method = OcclusionMethod::none;
  if (!givenOption(request) && !givenOption(job.light) && isFieldsFile(job.surface.input))
    request.method = OcclusionMethod::octants;
  return chooseOcclusion(request);
}

RenderSettings renderSettings(const RenderJob& job, const OcclusionSetting& occlusion, const SweptLighting& lighting,
                              const SweptScene& scene, const Camera& camera) {
  RenderSettings settings;
  settings.size = job.size;
  settings.samples = job.samples;
  settings.shading = shadingOf(occlusion.method);
  settings.normals = job.normals;
  settings.occlusionOffsetVoxels = static_cast<float>(occlusion.offset);
  settings.openPlaneTerms = occlusion.openPlane;
  if (settings.shading == Shading::octants) {
    settings.octantLight =
        octantLights(job.light, makeGridFrame(scene.surface.worldFromGrid).worldFromAxes, cameraAxes(camera));
    if (job.light.opacity.value_or(1) < 1) settings.geometryTerm = GeometryTerm::bothSides;
  }
  settings.lightColors = lighting.colors;
  settings.headLight = lighting.head;
  settings.suns = lighting.suns;
  settings.gamma = static_cast<float>(job.gamma);
  settings.albedo = job.albedo.linear;
  settings.background = glm::vec4(job.background.linear, job.transparent ? 0.0f : 1.0f);
  settings.layers = job.layers.any();
  settings.screen = chooseScreen(job.screen, solidCorners(scene.surface));
  return settings;
}

SceneFields sceneFields(const SweptScene& scene, const SweptLighting& lighting,
                        const std::optional<SurfaceColoring>& coloring, NormalSource normals) {
  SceneFields fields;
  fields.worldFromGrid = scene.surface.worldFromGrid;
  fields.level = scene.surface.level.view();
  if (normals == NormalSource::distance) fields.distance = scene.swept.distance.view();
  for (std::size_t i = 0; i < fields.octants.size(); ++i)
    if (!scene.swept.visibility.packed[i].empty()) fields.octants[i] = scene.swept.visibility.packed[i].view();
  for (std::size_t i = 0; i < lighting.fields.size(); ++i) {
    fields.lights.push_back(lighting.uses[i]);
    fields.lights.back().values = &lighting.fields[i].values;
  }
  if (coloring) fields.color = coloring->field();
  return fields;
}

/// An opacity that was asked for by the solid's extent, so that outputs tell what to draw the picture again with.
void settleOpacity(LightingRequest& light, const Surface& surface) {
  if (light.freePathShare && !light.opacity) {
    const std::array<glm::dvec3, 8> corners = solidCorners(surface);
    const double path = *light.freePathShare * glm::length(corners[7] - corners[0]);
    light.opacity = -std::expm1(-smallestSpacing(surface.level.view().spacing) / path);
  }
  light.freePathShare.reset();
}

/// An open point sees half of the octants: it gets what they add up to over half their number.
SweptLighting combinedLight(const LightingRequest& request, OctantVisibility& visibility) {
  const OctantIntensities intensities = combinedIntensities(request);
  const float sum = std::accumulate(intensities.begin(), intensities.end(), 0.0f);
  SweptLighting lighting;
  lighting.fields.push_back({surfaceField(visibility.combined.view()), sum / (kOctantCount / 2)});
  visibility.combined = {};
  lighting.uses.push_back({.full = lighting.fields[0].full, .everywhere = true});
  lighting.colors.push_back(glm::vec3(1));
  return lighting;
}

/// What the scene takes on the GPU, as of raymarch/renderer.h.
std::size_t textureBytes(const SceneFields& fields) {
  constexpr std::size_t kLevelBytes = 4, kClearanceBytes = 1, kDistanceBytes = 2, kOctantsBytes = 8, kLightBytes = 2;
  std::size_t lights = 0;
  for (const LightField& field : fields.lights) lights += voxelCount(field.values->paddedSize());
  return fields.level.count() * (kLevelBytes + kClearanceBytes + (fields.distance.data ? kDistanceBytes : 0) +
                                 (fields.octants[0].data ? kOctantsBytes : 0)) +
         lights * kLightBytes + (fields.color ? fields.color->places.count() * sizeof(float) : 0);
}

/// Stage `environment`, if there is a map.
std::optional<EnvironmentMap> readMap(const RenderJob& job, StageLog& log) {
  if (job.light.environment.empty()) return std::nullopt;
  log.begin("environment", "reading " + job.light.environment);
  EnvironmentMap map = readEnvironmentMap(job.light.environment);
  log.end(map.radiance.size() * sizeof(glm::vec3));
  return map;
}

/// Stage `visibility`, with ordinates.
SweptLighting lightScene(const RenderJob& job, const OcclusionSetting& occlusion, const EnvironmentMap* map,
                         const SweptScene& scene, const Camera& camera, StageLog& log) {
  if (occlusion.method != OcclusionMethod::ordinates) return {};
  LightingRequest request = job.light;
  request.bent = job.layers.bent;
  request.thickness = job.layers.thickness;
  log.begin("visibility", fmt::format("sweeping {} ordinates over {}", occlusion.ordinates.ordinates, gridText(scene)));
  SweptLighting lighting = sweepsBent(job.screen) ? sweepForScreen(occlusion.ordinates, scene)
                           : occlusion.transport
                               ? sweepEvenSky(*occlusion.transport, job.light.exposure, scene)
                               : sweepLighting(request, occlusion.ordinates, map, scene, camera, job.albedo.linear);
  log.end(lighting.bytes());
  return lighting;
}

}  // namespace

void runRenderJob(const RenderJob& request) {
  RenderJob job = request;
  checkWritable(job.output);
  if (!job.run.report.empty()) checkWritable(job.run.report);
  limitThreads(job.run.threads);
  preloadImageCodec();
  StageLog log(job.run);

  OcclusionSetting occlusion = occlusionOf(job);
  if (!job.screen.estimator) checkLighting(job.light, occlusion.method);
  if (occlusion.openPlane && isTranslucent(job.light))
    throw UsageError("--octant-terms open-plane: expected an opaque solid, found --opacity below 1");
  if (isTranslucent(job.light)) {
    // Rays that carry lengths pass the samples themselves; the calibrated error is that of openness.
    occlusion.ordinates.refinement = 1;
    occlusion.error.reset();
  }
  const Shading shading = shadingOf(occlusion.method);
  FieldNeeds needs{.distance = job.normals == NormalSource::distance || shading == Shading::lights};
  needs.bandVoxels = job.normals == NormalSource::distance ? kBandVoxels : kSurfaceBandVoxels;
  if (shading == Shading::octants) needs.visibility = VisibilityStorage::rgba8;
  if (byOctants(occlusion.method)) needs.opacity = static_cast<float>(job.light.opacity.value_or(1));
  if (occlusion.method == OcclusionMethod::combined) {
    needs.visibility = VisibilityStorage::combined;
    needs.intensities = combinedIntensities(job.light);
  }
  SweptScene scene = loadScene(job.surface, needs, log);
  settleOpacity(job.light, scene.surface);
  const double aspect = static_cast<double>(job.size.x) / job.size.y;
  const Camera camera = chooseCamera(job.camera, solidCorners(scene.surface), aspect);
  const std::optional<EnvironmentMap> map = readMap(job, log);
  std::optional<SurfaceColoring> coloring;
  if (!job.color.by.empty()) coloring = readColoring(job.color, solidCorners(scene.surface), log);
  SweptLighting lighting = lightScene(job, occlusion, map ? &*map : nullptr, scene, camera, log);
  if (occlusion.method == OcclusionMethod::combined) lighting = combinedLight(job.light, scene.swept.visibility);
  RenderSettings settings = renderSettings(job, occlusion, lighting, scene, camera);
  if (settings.screen)
    settings.screen->sky =
        screenSky(job.light, map ? &*map : nullptr, makeGridFrame(scene.surface.worldFromGrid).worldFromAxes);
  // Beside drawing: it reads the files once more and uses one core.
  std::vector<std::string> files = scene.surface.files;
  if (!job.light.environment.empty()) files.push_back(job.light.environment);
  if (coloring) files.insert(files.end(), coloring->files.begin(), coloring->files.end());
  std::future<std::string> checksums = std::async(std::launch::async, checksumText, files);

  log.begin("upload", "preparing OpenGL");
  const std::unique_ptr<Context> context = makeContext(job.backend);
  Renderer renderer(*context);
  const SceneFields fields = sceneFields(scene, lighting, coloring, job.normals);
  renderer.upload(fields);
  renderer.prepare(settings);
  log.end(textureBytes(fields));

  log.begin("frame", "drawing");
  const Frame frame = renderer.render(camera, settings);
  log.end(frameBytes(frame));

  log.begin("write", "writing " + job.output);
  const Provenance provenance =
      renderProvenance(job, occlusion, settings.screen, coloring, scene.surface, camera, *context, checksums.get());
  Image image = imageOf(frame, job, lighting);
  image.metadata = provenance.metadata;
  writeImage(job.output, image, {.bitDepth = job.bitDepth.value_or(kDefaultBitDepth)});
  log.end(fileBytes(job.output));
  if (!job.run.report.empty()) writeReport(job.run.report, log, scene.surface, provenance);
  log.finish();
}

}  // namespace isolume
