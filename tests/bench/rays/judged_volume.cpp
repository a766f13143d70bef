#include "tests/bench/rays/judged_volume.h"

#include <algorithm>
#include <glm/common.hpp>

#include "src/cli/surface_options.h"
#include "sweep/level.h"
#include "tests/bench/report/shapes.h"

namespace isolume::bench {
namespace {

struct Solid {
  Grid<float> level;
  LevelSummary summary;
  glm::dvec3 spacing{1};
};

Solid solidOf(const VolumeRequest& request, const RunOptions& run) {
  if (!request.shape.empty()) {
    Solid solid{shapeLevel(request.shape, request.size), {}};
    solid.summary = makeLevel(solid.level.view(), 0, Inside::above);
    return solid;
  }
  StageLog log(run);
  Surface surface = readSurface(request.surface, log);
  const glm::dvec3 spacing = surface.level.view().spacing;
  return {std::move(surface.level), surface.summary, spacing};
}

}  // namespace

void addVolumeOptions(CLI::App& app, VolumeRequest& target) {
  addSurfaceOptions(app, target.surface);
  app.add_option("--shape", target.shape, "instead of INPUT: a shape or scene");
  constexpr int kSmallest = 8, kLargest = 1024;
  app.add_option("--size", target.size, "samples along each axis of the shape")->check(CLI::Range(kSmallest, kLargest));
}

JudgedVolume readJudgedVolume(const VolumeRequest& request, const RunOptions& run) {
  const Solid solid = solidOf(request, run);
  const glm::dvec3 scale = solid.spacing / smallestSpacing(solid.spacing);
  JudgedVolume volume{Grid<float>(solid.level.size(), scale), {}};
  std::copy_n(solid.level.data(), solid.level.count(), volume.level.data());
  const glm::ivec3 last = solid.level.size() - 1;
  volume.box.high = glm::dvec3(last) * scale;
  volume.box.solidLow = glm::dvec3(glm::max(solid.summary.solidMin - 1, glm::ivec3(0))) * scale;
  volume.box.solidHigh = glm::dvec3(glm::min(solid.summary.solidMax + 1, last)) * scale;
  return volume;
}

glm::dmat4 worldFromGrid(const JudgedVolume& volume) {
  glm::dmat4 matrix(1);
  for (int axis = 0; axis < 3; ++axis) matrix[axis][axis] = volume.level.view().spacing[axis];
  return matrix;
}

}  // namespace isolume::bench
