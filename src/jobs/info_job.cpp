#include "src/jobs/info_job.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <system_error>

#include "raymarch/camera.h"
#include "src/errors.h"
#include "src/io/statistics.h"
#include "src/io/vdb.h"
#include "src/jobs/stage_log.h"
#include "src/jobs/surface.h"

namespace isolume {
namespace {

using Json = nlohmann::ordered_json;

/// OpenVDB files start with 0x56444220, little-endian. False for what is not a plain file (a pipe would block).
bool hasVdbSignature(const std::string& path) {
  constexpr std::array<char, 4> kSignature{' ', 'B', 'D', 'V'};
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(path, unreadable)) return false;
  std::array<char, 4> start{};
  std::ifstream file(path, std::ios::binary);
  return file.read(start.data(), start.size()) && start == kSignature;
}

Json vectorJson(glm::dvec3 v) { return {v.x, v.y, v.z}; }

Json gridsJson(const std::vector<VdbGridInfo>& grids) {
  Json list = Json::array();
  for (const VdbGridInfo& grid : grids)
    list.push_back({{"name", grid.name},
                    {"type", grid.type},
                    {"kind", grid.kind},
                    {"scalar", grid.scalar},
                    {"active", grid.activeCount},
                    {"index_min", vectorJson(grid.indexMin)},
                    {"index_max", vectorJson(grid.indexMax)},
                    {"transform", grid.transform}});
  return list;
}

void addPlacement(Json& info, glm::ivec3 size, const glm::dmat4& worldFromGrid) {
  info["dims"] = {size.x, size.y, size.z};
  info["voxels"] = voxelCount(size);
  glm::dvec3 spacing{0};
  Json direction = Json::array();
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 column(worldFromGrid[axis]);
    spacing[axis] = glm::length(column);
    direction.push_back(vectorJson(column / spacing[axis]));
  }
  info["spacing"] = vectorJson(spacing);
  info["origin"] = vectorJson(glm::dvec3(worldFromGrid[3]));
  info["direction"] = direction;
  const std::array<glm::dvec3, 8> corners = boxCorners(worldFromGrid, glm::dvec3(0), glm::dvec3(size - 1));
  glm::dvec3 low = corners[0], high = corners[0];
  for (const glm::dvec3& corner : corners) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  info["bounds"] = {{"min", vectorJson(low)}, {"max", vectorJson(high)}};
  info["extent"] = vectorJson(glm::dvec3(size - 1) * spacing);
}

void addFields(Json& info, const std::string& path) {
  const FieldsFile file = readFields(path);
  info["format"] = "VDB fields";
  addPlacement(info, file.level.size(), file.worldFromGrid);
  info["fields"] = {{"isovalue", file.isovalue}, {"inside", insideName(file.inside)}, {"source", file.source}};
}

void addVolume(Json& info, const Volume& volume) {
  info["format"] = volume.format;
  info["type"] = volume.sampleType;
  if (!volume.gridName.empty()) info["grid"] = volume.gridName;
  info["files"] = volume.files;
  addPlacement(info, volume.values.size(), volume.worldFromGrid);
  info["world"] = volume.world;
  const VolumeStatistics statistics = computeStatistics(volume);
  const std::size_t finite = statistics.count - statistics.nanCount - statistics.infCount;
  Json values{{"nan", statistics.nanCount}, {"inf", statistics.infCount}};
  if (finite > 0) {
    values["min"] = statistics.min;
    values["max"] = statistics.max;
    values["mean"] = statistics.mean;
    values["histogram"] = statistics.histogram;
    const IsovalueChoice choice = defaultIsovalue(volume, statistics);
    info["isovalue"] = choice.isovalue;
    info["isovalue_choice"] = choice.reason;
    info["inside"] = insideName(volume.kind == GridKind::levelSet ? Inside::below : Inside::above);
  }
  info["values"] = values;
  info["notes"] = volume.notes;
}

}  // namespace

nlohmann::ordered_json gatherInfo(const InfoJob& job) {
  Json info;
  info["input"] = job.input;
  if (hasVdbSignature(job.input)) {
    const std::vector<VdbGridInfo> grids = listVdbGrids(job.input);
    info["format"] = "VDB";
    info["grids"] = gridsJson(grids);
    if (job.read.grid.empty() && isFieldsFile(job.input)) {
      addFields(info, job.input);
      return info;
    }
    const auto scalars = std::count_if(grids.begin(), grids.end(), [](const VdbGridInfo& grid) { return grid.scalar; });
    if (job.read.grid.empty() && scalars != 1) return info;
  }
  const Volume volume = readVolume(job.input, job.read);
  addVolume(info, volume);
  return info;
}

void runInfoJob(const InfoJob& job) {
  RunOptions run;
  run.quiet = job.quiet;
  StageLog log(run);
  log.begin("read", "reading " + job.input);
  const Json info = gatherInfo(job);
  log.end(0);
  constexpr int kIndent = 2;
  if (job.json)
    fmt::print("{}\n", info.dump(kIndent, ' ', false, Json::error_handler_t::replace));
  else
    fmt::print("{}", infoText(info));
}

}  // namespace isolume
