#include "src/jobs/sample_job.h"

#include <fmt/core.h>

#include <bit>
#include <glm/mat4x4.hpp>
#include <string_view>
#include <vector>

#include "src/errors.h"
#include "src/io/output_file.h"
#include "src/io/vdb.h"
#include "src/suggest.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

/// Voxel (i, j, k) at ((i, j, k) + 1/2) / size, as sampleScene() places it.
glm::dmat4 unitCubeFromGrid(int size) {
  const double spacing = 1.0 / size;
  glm::dmat4 worldFromGrid(1);
  for (int axis = 0; axis < 3; ++axis) {
    worldFromGrid[axis][axis] = spacing;
    worldFromGrid[3][axis] = spacing / 2;
  }
  return worldFromGrid;
}

std::string_view rawBytes(const Grid<float>& grid) {
  static_assert(std::endian::native == std::endian::little, "raw samples are written as they lie in memory");
  return {reinterpret_cast<const char*>(grid.data()), grid.count() * sizeof(float)};
}

}  // namespace

std::string sampleNameList() {
  std::string list;
  for (const std::string_view name : sceneNames()) list.append(list.empty() ? "" : ", ").append(name);
  return list;
}

void checkSample(const SampleJob& job) {
  if (!findScene(job.name)) {
    const std::vector<std::string_view> names = sceneNames();
    throw UsageError(fmt::format("sample: expected one of {}, found '{}'{}", sampleNameList(), job.name,
                                 didYouMean(job.name, {names.begin(), names.end()})));
  }
  if (!job.output.ends_with(".vdb") && !job.output.ends_with(".raw"))
    throw UsageError(fmt::format("--output: expected a name that ends in .vdb or .raw, found '{}'", job.output));
}

void runSampleJob(const SampleJob& job) {
  checkWritable(job.output);
  const Scene& scene = *findScene(job.name);
  const Grid<float> grid = sampleScene(scene, job.size);
  const bool vdb = job.output.ends_with(".vdb");
  const bool levelSet = vdb && scene.exactDistance;
  if (vdb)
    writeFileAtomically(job.output, encodeVdb(grid.view(), unitCubeFromGrid(job.size), job.name, levelSet));
  else
    writeFileAtomically(job.output, rawBytes(grid));

  if (job.quiet) return;
  const std::string layout = fmt::format("{0}x{0}x{0}", job.size);
  const bool nameTellsLayout = job.output.ends_with(fmt::format("_{}_float32.raw", layout));
  std::string options = levelSet ? "" : " --isovalue 0 --inside below";
  if (!vdb && !nameTellsLayout) options += fmt::format(" --dims {} --type float32", layout);
  fmt::print("{}: {}, {} samples; draw it with: isolume render {}{} -o {}.png\n", job.output, scene.description, layout,
             job.output, options, job.name);
}

}  // namespace isolume
