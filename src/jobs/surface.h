// From an input file to levels: what `render` and `fields` have in common.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "raymarch/camera.h"
#include "src/io/volume.h"
#include "src/jobs/stage_log.h"
#include "sweep/level.h"
#include "sweep/occlusion_sweep.h"

namespace isolume {

struct SurfaceRequest {
  std::string input;
  std::optional<double> isovalue;        ///< default: defaultIsovalue() of src/io/statistics.h
  std::optional<Inside> inside;          ///< default: below for a VDB level set, above otherwise
  std::optional<DistanceSolver> solver;  ///< default: godunov
  ReadOptions read;
};

/// A solid, ready to be swept.
struct Surface {
  Grid<float> level;
  glm::dmat4 worldFromGrid{1};
  double isovalue = 0;
  std::string isovalueReason;
  Inside inside = Inside::above;
  LevelSummary summary;
  std::string format, sampleType, gridName;
  std::string source;              ///< of a fields file: how it was made
  std::vector<std::string> files;  ///< every file that was read
};

/// A solid with its fields, swept now or read from a file.
struct SweptScene {
  Surface surface;
  SweptFields swept;
};

/// Stage `read`. InputError if nothing is inside, or if the isovalue is outside the range of the finite samples:
/// `FILE: no surface at isovalue V: values span A to B`. Tells the user the reader's notes and the number of NaN.
Surface readSurface(const SurfaceRequest& request, StageLog& log);

/// Stages `read`, `distance` and (if `storage` asks for it) `visibility`; a file of fields has only `read`, and leaves
/// no choice of surface: UsageError for any such option. Octants of a file are packed if `storage` is rgba8.
SweptScene loadScene(const SurfaceRequest& request, VisibilityStorage storage, StageLog& log);

/// Bytes that the visibility takes.
std::size_t visibilityBytes(const OctantVisibility& visibility);

/// World corners of the box that holds the whole solid: its voxels and the one beyond them, within the grid.
std::array<glm::dvec3, 8> solidCorners(const Surface& surface);

const char* insideName(Inside inside);
const char* solverName(DistanceSolver solver);

}  // namespace isolume
