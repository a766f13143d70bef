#include "src/jobs/report.h"

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "src/io/output_file.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

std::string metadataOf(const Provenance& provenance, const std::string& key) {
  for (const auto& [name, value] : provenance.metadata)
    if (name == key) return value;
  return {};
}

}  // namespace

std::size_t fileBytes(const std::string& path) {
  std::error_code noSize;
  const std::uintmax_t size = std::filesystem::file_size(path, noSize);
  return noSize ? 0 : size;
}

void writeReport(const std::string& path, const StageLog& log, const Surface& surface, const Provenance& provenance) {
  constexpr int kIndent = 2;
  nlohmann::ordered_json report;
  report["command"] = metadataOf(provenance, "isolume:command");
  report["version"] = metadataOf(provenance, "isolume:version");
  report["input"] = {{"path", metadataOf(provenance, "isolume:input")},
                     {"sha256", metadataOf(provenance, "isolume:input_sha256")},
                     {"format", surface.format},
                     {"type", surface.sampleType}};
  const glm::ivec3 size = surface.level.size();
  report["voxels"] = surface.level.count();
  report["dims"] = {size.x, size.y, size.z};
  report["threads"] = threadCount();
  report["stages"] = nlohmann::ordered_json::array();
  for (const StageRecord& stage : log.stages())
    report["stages"].push_back({{"name", stage.name}, {"seconds", stage.seconds}, {"bytes", stage.bytes}});
  report["seconds"] = log.secondsSinceStart();
  report["peak_rss_bytes"] = peakResidentBytes();
  report["settings"] = provenance.settings;
  // File names may hold any bytes: what is not UTF-8 is replaced, not refused.
  writeFileAtomically(path, report.dump(kIndent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace isolume
