#include "src/jobs/fields_job.h"

#include <fmt/core.h>

#include <utility>

#include "src/errors.h"
#include "src/io/output_file.h"
#include "src/io/vdb.h"
#include "src/jobs/provenance.h"
#include "src/jobs/report.h"
#include "src/version.h"

namespace isolume {

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

  log.begin("write", "writing " + job.output);
  const std::string checksums = checksumText(surface.files);
  const Provenance provenance = surfaceProvenance(job.run.command, job.surface.input, surface, checksums);
  FieldsFile file;
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
