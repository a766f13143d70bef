#include "src/jobs/compare_job.h"

#include <fmt/format.h>

#include <cstdio>

#include "src/compare/heat_map.h"
#include "src/errors.h"
#include "src/io/image.h"

namespace isolume {
namespace {

void print(const CompareJob& job, const Comparison& comparison) {
  constexpr int kIndent = 2;
  if (job.json)
    fmt::print("{}\n",
               comparisonJson(comparison).dump(kIndent, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  else
    fmt::print("{}", comparisonText(comparison));
  if (std::fflush(stdout) != 0) throw OutputError("standard output: cannot write");
}

}  // namespace

void runCompareJob(const CompareJob& job) {
  if (!job.heat.empty()) checkImageTarget(job.heat, {"R", "G", "B"});
  limitThreads(job.run.threads);
  const Image got = readImage(job.got), want = readImage(job.want);
  const LayerPair pair =
      pairLayers(job.layer, job.wantLayer.empty() ? job.layer : job.wantLayer, {job.got, got}, {job.want, want});
  std::optional<DifferenceField> shown;  // before anything is printed: it may be refused
  if (!job.heat.empty()) shown = shownDifference(pair);
  const Comparison comparison = compareLayer(pair);
  print(job, comparison);
  if (shown) {
    const double range = job.heatRange.value_or(defaultHeatRange(*shown));
    Image heat = drawHeatMap(*shown, pair.pixels, range);
    heat.metadata.emplace_back("isolume:command", job.run.command);
    writeImage(job.heat, heat);
  }
  if (const std::string broken = brokenLimits(comparison, job.limits); !broken.empty()) throw LimitError(broken);
}

}  // namespace isolume
