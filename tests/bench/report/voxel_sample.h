// The voxels at which a distance field is judged, with the true distance of each.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "tests/bench/report/closest_distance.h"
#include "tests/bench/report/distance_solver.h"

namespace isolume::bench {

struct JudgedVoxel {
  glm::ivec3 index{0};
  double truth = 0;      ///< signed, < 0 inside, voxels
  bool anywhere = true;  ///< drawn from the whole grid, and not from the neighbourhood of the surface
};

/// `count` voxels uniformly from the whole grid and as many around cells that the surface passes, deterministic.
/// Threaded.
std::vector<JudgedVoxel> judgedVoxels(GridView<const float> level, int count);

/// Errors in voxels: of the magnitude of the signed difference.
struct DistanceError {
  double mean = 0;      ///< over the voxels from anywhere
  double max = 0;       ///< over all
  double meanNear = 0;  ///< over those within kNearVoxels of the surface
  double maxNear = 0;
  int wrongSign = 0;  ///< of the opposite sign (0 has none) although more than the truth's tolerance off the surface
};
inline constexpr double kNearVoxels = 3;

/// Not a number in a result makes mean and max NaN.
DistanceError distanceError(const std::vector<JudgedVoxel>& voxels, const DistanceSolver& solver);

}  // namespace isolume::bench
