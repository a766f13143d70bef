#include "src/jobs/fields_job.h"

#include <fmt/core.h>

#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>

#include "src/errors.h"
#include "src/io/output_file.h"
#include "src/io/vdb.h"
#include "src/jobs/lighting.h"
#include "src/jobs/provenance.h"
#include "src/jobs/report.h"
#include "src/version.h"
#include "sweep/parallel.h"

namespace isolume {

namespace {

using Samples = Grid<std::uint16_t>;

Grid<float> toFloat(const Samples& samples, float full) {
  constexpr float kFull = 65535;
  Grid<float> values(samples.size(), samples.view().spacing, samples.view().origin);
  for (std::size_t i = 0; i < values.count(); ++i)
    values.data()[i] = static_cast<float>(samples.data()[i]) / kFull * full;
  return values;
}

/// Where nothing was swept the mean is stored as 0, which stands for (-1, -1, -1).
void addBent(const std::array<Samples, 3>& bent, std::vector<std::pair<std::string, Grid<float>>>& to) {
  const std::size_t first = to.size();
  for (const char* name : {"bent_x", "bent_y", "bent_z", "cone"})
    to.emplace_back(name, Grid<float>(bent[0].size(), bent[0].view().spacing, bent[0].view().origin));
  parallelFor(static_cast<std::size_t>(bent[0].size().z), [&](std::size_t z) {
    const std::size_t layer = bent[0].count() / static_cast<std::size_t>(bent[0].size().z);
    for (std::size_t i = z * layer; i < (z + 1) * layer; ++i) {
      const bool swept = (bent[0].data()[i] | bent[1].data()[i] | bent[2].data()[i]) != 0;
      glm::vec3 mean(0);
      if (swept)
        for (int c = 0; c < 3; ++c) mean[c] = bentComponent(bent[static_cast<std::size_t>(c)].data()[i]);
      const float length = glm::length(mean);
      for (int c = 0; c < 3; ++c)
        to[first + static_cast<std::size_t>(c)].second.data()[i] = length > 0 ? mean[c] / length : 0;
      to[first + 3].second.data()[i] = length > 0 ? coneAngle(length) : 0;
    }
  });
}

void sweepOthers(const OtherFields& wanted, const SweptScene& scene, FieldsFile& file, StageLog& log) {
  if (!wanted.any()) return;
  const OrdinateOptions ordinates = chooseOcclusion({}).ordinates;
  log.begin("light", fmt::format("sweeping {} ordinates over {}", ordinates.ordinates, gridText(scene)));
  LightingRequest request;
  request.bent = wanted.bent;
  request.thickness = wanted.thickness;
  const SweptLighting lighting = sweepLighting(request, ordinates, nullptr, scene, {}, glm::vec3(1));
  if (wanted.openness)
    file.others.emplace_back("openness", toFloat(lighting.fields[0].values, lighting.fields[0].full));
  if (lighting.bent) addBent(*lighting.bent, file.others);
  if (lighting.thickness)
    file.others.emplace_back("thickness", toFloat(lighting.thickness->values, lighting.thickness->full));
  log.end(lighting.bytes());
}

}  // namespace

void runFieldsJob(const FieldsJob& job) {
  checkWritable(job.output);
  if (!job.run.report.empty()) checkWritable(job.run.report);
  limitThreads(job.run.threads);
  StageLog log(job.run);
  if (isFieldsFile(job.surface.input))
    throw UsageError(fmt::format("fields: expected a volume, found a file of fields: {}", job.surface.input));

  SweptScene scene = loadScene(
      job.surface, {.distance = true, .visibility = VisibilityStorage::float32, .extent = DistanceExtent::full}, log);
  Surface& surface = scene.surface;
  FieldsFile file;
  sweepOthers(job.others, scene, file, log);

  log.begin("write", "writing " + job.output);
  const std::string checksums = checksumText(surface.files);
  const Provenance provenance = surfaceProvenance(job.run.command, job.surface.input, surface, checksums);
  file.level = std::move(surface.level);
  file.swept = std::move(scene.swept);
  file.worldFromGrid = surface.worldFromGrid;
  file.isovalue = surface.isovalue;
  file.inside = surface.inside;
  file.summary = surface.summary;
  file.source = fmt::format("isolume {}: {} (input {})", kVersion, job.run.command, checksums);
  writeFileAtomically(job.output, encodeFields(file));
  log.end(fileBytes(job.output));
  surface.level = std::move(file.level);  // the report counts its voxels
  if (!job.run.report.empty()) writeReport(job.run.report, log, surface, provenance);
  log.finish();
}

}  // namespace isolume
