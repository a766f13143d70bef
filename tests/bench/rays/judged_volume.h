// The volume whose rays are judged: a file as every command takes it, or a shape or scene by name.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "src/jobs/surface.h"
#include "tests/bench/rays/random_views.h"

namespace isolume::bench {

struct VolumeRequest {
  SurfaceRequest surface;
  std::string shape;  ///< instead of the file
  int size = 256;
};

/// INPUT, --isovalue and so on, and instead of them --shape and --size.
void addVolumeOptions(CLI::App& app, VolumeRequest& target);

struct JudgedVolume {
  Grid<float> level;  ///< spacing in voxels (smallest = 1), origin 0
  ViewedBox box;
};

JudgedVolume readJudgedVolume(const VolumeRequest& request, const RunOptions& run);

/// Index to the world of the views: the grid's own axes, in voxels.
glm::dmat4 worldFromGrid(const JudgedVolume& volume);

}  // namespace isolume::bench
