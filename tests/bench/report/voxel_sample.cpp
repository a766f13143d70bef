#include "tests/bench/report/voxel_sample.h"

#include <cmath>
#include <glm/common.hpp>

#include "sweep/parallel.h"
#include "volumes/random.h"

namespace isolume::bench {
namespace {

int below(Random& random, int bound) { return static_cast<int>(random.uniform() * bound); }

/// The larger of the two, and NaN if either is.
double largest(double a, double b) { return std::isnan(a) || a > b ? a : b; }

}  // namespace

std::vector<JudgedVoxel> judgedVoxels(GridView<const float> level, int count) {
  constexpr std::uint64_t kSeed = 3;
  constexpr int kReach = static_cast<int>(kNearVoxels);
  Random random(kSeed);
  const ClosestDistance closest(level);
  const std::vector<glm::ivec3> cells = closest.mixedCells();
  std::vector<JudgedVoxel> voxels;
  for (int i = 0; i < count; ++i) {
    const int x = below(random, level.size.x), y = below(random, level.size.y), z = below(random, level.size.z);
    voxels.push_back({{x, y, z}, 0, true});
  }
  for (int i = 0; i < count && !cells.empty(); ++i) {
    const glm::ivec3 cell = cells[static_cast<std::size_t>(random.uniform() * static_cast<double>(cells.size()))];
    const int x = below(random, 2 * kReach), y = below(random, 2 * kReach), z = below(random, 2 * kReach);
    const glm::ivec3 index = cell + glm::ivec3(x, y, z) + 1 - kReach;  // as far below the cell's centre as above it
    voxels.push_back({glm::clamp(index, glm::ivec3(0), level.size - 1), 0, false});
  }
  parallelFor(voxels.size(), [&](std::size_t i) {
    const glm::ivec3 at = voxels[i].index;
    const double distance = closest(glm::dvec3(at));
    voxels[i].truth = level(at.x, at.y, at.z) > 0 ? -distance : distance;
  });
  return voxels;
}

DistanceError distanceError(const std::vector<JudgedVoxel>& voxels, const DistanceSolver& solver) {
  DistanceError error;
  double sum = 0, sumNear = 0;
  std::size_t count = 0, countNear = 0;
  for (const JudgedVoxel& voxel : voxels) {
    const double got = solver.distanceAt(voxel.index.x, voxel.index.y, voxel.index.z);
    const double off = std::abs(got - voxel.truth);
    error.max = largest(error.max, off);
    if (std::abs(voxel.truth) > kTruthTolerance && got * voxel.truth < 0) ++error.wrongSign;
    if (voxel.anywhere) {
      sum += off;
      ++count;
    }
    if (std::abs(voxel.truth) > kNearVoxels) continue;
    error.maxNear = largest(error.maxNear, off);
    sumNear += off;
    ++countNear;
  }
  error.mean = sum / static_cast<double>(count);
  error.meanNear = sumNear / static_cast<double>(countNear);
  return error;
}

}  // namespace isolume::bench
