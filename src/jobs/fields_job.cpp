#include "src/jobs/fields_job.h"

#include <fmt/core.h>

#include <cstdint>
#include <utility>

#include "raymarch/view.h"
#include "src/errors.h"
#include "src/io/output_file.h"
#include "src/io/vdb.h"
#include "src/jobs/provenance.h"
#include "src/jobs/report.h"
#include "src/version.h"
#include "sweep/ordinates/light_sweeps.h"
#include "sweep/ordinates/openness_sweep.h"
#include "sweep/ordinates/translucency.h"
#include "sweep/parallel.h"
#include "sweep/transport/transport_sweep.h"

namespace isolume {
namespace {

Grid<float> toFloat(const SweptLight& swept, GridView<const float> level) {
  const Grid<std::uint16_t> samples = bySample(swept.values, level);
  Grid<float> values(level.size, level.spacing, level.origin);
  for (std::size_t i = 0; i < values.count(); ++i)
    values.data()[i] = swept.valueOf(static_cast<float>(samples.data()[i]));
  return values;
}

/// Where nothing was swept the mean is stored as 0, which stands for (-1, -1, -1).
void addBent(const std::array<SurfaceField, 3>& fields, GridView<const float> level,
             std::vector<std::pair<std::string, Grid<float>>>& to) {
  const std::array<Grid<std::uint16_t>, 3> bent{bySample(fields[0], level), bySample(fields[1], level),
                                                bySample(fields[2], level)};
  const std::size_t first = to.size();
  for (const char* name : {"bent_x", "bent_y", "bent_z", "cone"})
    to.emplace_back(name, Grid<float>(level.size, level.spacing, level.origin));
  const auto layers = static_cast<std::size_t>(bent[0].size().z), layer = bent[0].count() / layers;
  parallelFor(layers, [&](std::size_t z) {
    for (std::size_t i = z * layer; i < (z + 1) * layer; ++i) {
      glm::vec3 mean(0);
      if ((bent[0].data()[i] | bent[1].data()[i] | bent[2].data()[i]) != 0)
        for (int c = 0; c < 3; ++c) mean[c] = bentComponent(bent[static_cast<std::size_t>(c)].data()[i]);
      const BentNormal normal = bentNormal(mean);
      for (int c = 0; c < 3; ++c) to[first + static_cast<std::size_t>(c)].second.data()[i] = normal.direction[c];
      to[first + 3].second.data()[i] = normal.cone;
    }
  });
}

/// What a picture of the default setting would take, but for the refinement: lengths need a lattice of the samples.
void sweepOthers(const OtherFields& wanted, const OcclusionSetting& occlusion, const SweptScene& scene,
                 FieldsFile& file, StageLog& log) {
  if (!wanted.any()) return;
  const int ordinates = occlusion.ordinates.ordinates;
  log.begin("light", fmt::format("sweeping {} ordinates over {}", ordinates, gridText(scene)));
  const GridView<const float> level = scene.surface.level.view(), distance = scene.swept.distance.view();
  if (occlusion.transport) {
    file.others.emplace_back("openness", toFloat({sweepTransport(level, distance, *occlusion.transport), 1}, level));
  } else {
    const SurfaceRays rays(level, distance, 1);
    if (wanted.openness)
      file.others.emplace_back("openness",
                               toFloat({rays.surface().spread(opennessOf(blockedShares(rays, ordinates))), 1}, level));
    if (wanted.bent)
      addBent(sweepBentNormals(rays, ordinates, makeGridFrame(scene.surface.worldFromGrid).worldFromAxes), level,
              file.others);
    if (wanted.thickness)
      file.others.emplace_back("thickness", toFloat(sweepThickness(rays, distance, ordinates), level));
  }
  std::size_t bytes = 0;
  for (const auto& [name, values] : file.others) bytes += values.count() * sizeof(float);
  log.end(bytes);
}

}  // namespace

void checkFields(const FieldsJob& job) {
  const OcclusionSetting occlusion = chooseOcclusion(job.occlusion);
  const char* option = givenOption(job.occlusion);
  if (option && !job.others.any())
    throw UsageError(fmt::format("{}: expected --with beside it, whose fields are swept so, found none", option));
  if (job.others.bent) needRays(occlusion, "--with bent");
  if (job.others.thickness) needRays(occlusion, "--with thickness");
}

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
  const OcclusionSetting occlusion = chooseOcclusion(job.occlusion);
  sweepOthers(job.others, occlusion, scene, file, log);

  log.begin("write", "writing " + job.output);
  const std::string checksums = checksumText(surface.files);
  Provenance provenance = surfaceProvenance(job.run.command, job.surface.input, surface, checksums);
  if (job.others.any()) provenance.settings.update(occlusionSettings(occlusion));
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
