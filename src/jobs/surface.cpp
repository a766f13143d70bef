#include "src/jobs/surface.h"

#include <fmt/core.h>

#include <glm/common.hpp>
#include <utility>

#include "src/errors.h"
#include "src/io/statistics.h"
#include "src/io/vdb.h"

namespace isolume {
namespace {

/// Settles the isovalue: asked for, or the default with its reason.
IsovalueChoice chooseIsovalue(const SurfaceRequest& request, const Volume& volume) {
  if (request.isovalue) return {*request.isovalue, "asked for"};
  return defaultIsovalue(volume, computeStatistics(volume));
}

/// A sample as the user knows it: as few digits as a float needs, or the sum with the offset.
std::string sampleText(float value, double offset) {
  return offset == 0 ? fmt::format("{}", value) : fmt::format("{}", value + offset);
}

void checkHasSurface(const Surface& surface, float isovalue, double offset, const std::string& input) {
  const LevelSummary& summary = surface.summary;
  if (summary.finiteMin > summary.finiteMax)
    throw InputError(fmt::format("{}: no surface: expected numbers, found only NaN and infinities", input));
  if (isovalue >= summary.finiteMin && isovalue <= summary.finiteMax && summary.hasSurface()) return;
  throw InputError(fmt::format("{}: no surface at isovalue {} (inside {}): values span {} to {}", input,
                               surface.isovalue, insideName(surface.inside), sampleText(summary.finiteMin, offset),
                               sampleText(summary.finiteMax, offset)));
}

void refuseSurfaceOptions(const SurfaceRequest& request, double isovalue, Inside inside) {
  const RawLayout& raw = request.read.raw;
  const char* option = request.isovalue             ? "--isovalue"
                       : request.inside             ? "--inside"
                       : !request.read.grid.empty() ? "--grid"
                       : raw.dims                   ? "--dims"
                       : raw.type                   ? "--type"
                       : raw.bigEndian              ? "--endian"
                       : raw.offset                 ? "--offset"
                       : raw.spacing                ? "--spacing"
                       : raw.origin                 ? "--origin"
                                                    : givenOption(request.distance);
  if (option)
    throw UsageError(fmt::format(
        "{}: {} holds fields swept at isovalue {}, inside {}: expected the volume itself for another surface", option,
        request.input, isovalue, insideName(inside)));
}

SweptScene readScene(const SurfaceRequest& request, VisibilityStorage storage, StageLog& log) {
  log.begin("read", "reading fields from " + request.input);
  FieldsFile file = readFields(request.input);
  refuseSurfaceOptions(request, file.isovalue, file.inside);
  SweptScene scene;
  scene.surface.worldFromGrid = file.worldFromGrid;
  scene.surface.isovalue = file.isovalue;
  scene.surface.isovalueReason = "of the fields file";
  scene.surface.inside = file.inside;
  scene.surface.summary = file.summary;
  scene.surface.format = "VDB fields";
  scene.surface.sampleType = "float";
  scene.surface.source = file.source;
  scene.surface.files = {request.input};
  scene.surface.level = std::move(file.level);
  scene.swept = std::move(file.swept);
  if (storage == VisibilityStorage::rgba8) scene.swept.visibility.packed = packOctants(scene.swept.visibility.octants);
  if (storage != VisibilityStorage::float32) scene.swept.visibility.octants = {};
  log.end((scene.surface.level.count() + scene.swept.distance.count()) * sizeof(float) +
          visibilityBytes(scene.swept.visibility));
  return scene;
}

/// Stages `distance` and, if the method has it, `visibility`.
void sweepFields(SweptScene& scene, const SweepOptions& method, StageLog& log) {
  const bool withVisibility = method.visibility != VisibilityStorage::none;
  log.begin("distance", "sweeping distance over " + gridText(scene));
  SweepOptions sweep = method;
  sweep.visibility = VisibilityStorage::none;
  scene.swept = sweepOcclusion(std::as_const(scene.surface.level).view(), sweep);
  scene.surface.method = distanceSettings(method);
  log.end(scene.swept.distance.count() * sizeof(float));
  if (!withVisibility) return;
  log.begin("visibility", "sweeping visibility over " + gridText(scene));
  scene.swept.visibility = sweepVisibility(std::as_const(scene.swept.distance).view(), method.visibility,
                                           method.opacity, method.intensities);
  log.end(visibilityBytes(scene.swept.visibility));
}

}  // namespace

const char* insideName(Inside inside) { return inside == Inside::above ? "above" : "below"; }

std::size_t visibilityBytes(const OctantVisibility& visibility) {
  std::size_t bytes = 0;
  for (const auto& grid : visibility.packed) bytes += grid.count() * sizeof(glm::u8vec4);
  for (const auto& grid : visibility.octants) bytes += grid.count() * sizeof(float);
  bytes += visibility.combined.count() * sizeof(std::uint16_t);
  return bytes;
}

Surface readSurface(const SurfaceRequest& request, StageLog& log) {
  log.begin("read", "reading " + request.input);
  Volume volume = readVolume(request.input, request.read);
  for (const std::string& note : volume.notes) log.tell("note", note);
  const IsovalueChoice choice = chooseIsovalue(request, volume);

  Surface surface;
  surface.isovalue = choice.isovalue;
  surface.isovalueReason = choice.reason;
  surface.inside = request.inside.value_or(volume.kind == GridKind::levelSet ? Inside::below : Inside::above);
  surface.worldFromGrid = volume.worldFromGrid;
  surface.format = volume.format;
  surface.sampleType = volume.sampleType;
  surface.gridName = volume.gridName;
  surface.files = volume.files;
  surface.level = std::move(volume.values);
  const float isovalue = static_cast<float>(surface.isovalue - volume.valueOffset);
  surface.summary = makeLevel(surface.level.view(), isovalue, surface.inside);
  checkHasSurface(surface, isovalue, volume.valueOffset, request.input);
  if (surface.summary.replacedCount > 0)
    log.tell("warning", fmt::format("{}: {} of {} values are NaN or infinite and count as outside", request.input,
                                    surface.summary.replacedCount, surface.level.count()));
  log.end(surface.level.count() * sizeof(float));
  return surface;
}

SweptScene loadScene(const SurfaceRequest& request, const FieldNeeds& needs, StageLog& log) {
  SweepOptions method = distanceMethod(request.distance, needs.visibility, needs.extent);
  method.opacity = needs.opacity;
  method.intensities = needs.intensities;
  method.bandVoxels = needs.bandVoxels;
  SweptScene scene;
  if (isFieldsFile(request.input)) {
    if (needs.opacity != 1 || needs.visibility == VisibilityStorage::combined)
      throw UsageError(fmt::format(
          "{}: expected the volume itself for --opacity or --occlusion combined, found its fields", request.input));
    scene = readScene(request, needs.visibility, log);
  } else {
    scene.surface = readSurface(request, log);
    const bool withVisibility = needs.visibility != VisibilityStorage::none;
    if (needs.distance || withVisibility) sweepFields(scene, method, log);
  }
  return scene;
}

std::string gridText(const SweptScene& scene) {
  const glm::ivec3 size = scene.surface.level.size();
  return fmt::format("{}x{}x{} voxels", size.x, size.y, size.z);
}

std::array<glm::dvec3, 8> solidCorners(const Surface& surface) {
  const glm::ivec3 last = surface.level.size() - 1;
  return boxCorners(surface.worldFromGrid, glm::dvec3(glm::max(surface.summary.solidMin - 1, glm::ivec3(0))),
                    glm::dvec3(glm::min(surface.summary.solidMax + 1, last)));
}

}  // namespace isolume
