// OpenVDB's fast sweeping, used as its header says for an approximate level set: sdfToSdf, one iteration, every voxel
// active. The voxel size is 1, since the solver takes neighbours beyond 1000 world units as unset.
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/FastSweeping.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "tests/bench/report/distance_solver.h"

namespace isolume::bench {
namespace {

openvdb::FloatGrid::Ptr activeGrid(GridView<const float> level) {
  std::vector<float> values(level.count());
  // A level of 0 is outside, which for this solver is what lies above 0.
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = level.data[i] == 0 ? std::numeric_limits<float>::min() : -level.data[i];
  const openvdb::CoordBBox box(openvdb::Coord(0), openvdb::Coord(level.size.x - 1, level.size.y - 1, level.size.z - 1));
  const openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box, values.data());
  // A background that no sample has, so that none of them is taken for background and left inactive.
  float background = 0;
  for (const float value : values) background = std::max(background, value);
  auto grid = openvdb::FloatGrid::create(2 * background + 1);
  openvdb::tools::copyFromDense(dense, *grid, 0.0F);
  return grid;
}

}  // namespace

SolverOrGap openVdbSolver(GridView<const float> level) {
  const std::string name = "OpenVDB fast sweeping";
  if (level.spacing.x != level.spacing.y || level.spacing.y != level.spacing.z)
    return {name, std::nullopt, "works on cubic voxels alone"};
  openvdb::initialize();
  const auto output = std::make_shared<openvdb::FloatGrid::Ptr>();
  const auto solve = [input = activeGrid(level), output] { *output = openvdb::tools::sdfToSdf(*input); };
  const auto distanceAt = [output](int x, int y, int z) {
    return static_cast<double>((*output)->tree().getValue(openvdb::Coord(x, y, z)));
  };
  return {name,
          DistanceSolver{name, openvdb::getLibraryVersionString(), "tools::sdfToSdf, one iteration, every voxel active",
                         solve, distanceAt},
          ""};
}

}  // namespace isolume::bench
