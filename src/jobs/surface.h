// From an input file to levels: what `render` and `fields` have in common.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "raymarch/camera.h"
#include "src/io/volume.h"
#include "src/jobs/distance_method.h"
#include "src/jobs/stage_log.h"
#include "sweep/level.h"

namespace isolume {

struct SurfaceRequest {
  std::string input;
  std::optional<double> isovalue;  ///< default: defaultIsovalue() of src/io/statistics.h
  std::optional<Inside> inside;    ///< default: below for a VDB level set, above otherwise
  DistanceRequest distance;
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
  std::string source;  ///< of a fields file: how it was made
  nlohmann::ordered_json method =
      nlohmann::ordered_json::object();  ///< how its distances were computed (distanceSettings()); empty until they are
  std::vector<std::string> files;        ///< every file that was read
};

/// A solid with its fields, swept now or read from a file.
struct SweptScene {
  Surface surface;
  SweptFields swept;
};

/// Stage `read`. InputError if nothing is inside, or if the isovalue is outside the range of the finite samples:
/// `FILE: no surface at isovalue V: values span A to B`. Tells the user the reader's notes and the number of NaN.
Surface readSurface(const SurfaceRequest& request, StageLog& log);

/// What a job wants of a scene.
struct FieldNeeds {
  bool distance = false;  ///< visibility needs it in any case
  VisibilityStorage visibility = VisibilityStorage::none;
  float opacity = 1;                             ///< of the visibility
  OctantIntensities intensities = kEvenOctants;  ///< of the combined visibility
  DistanceExtent extent = DistanceExtent::band;  ///< of the distance, if the user does not say
  int bandVoxels = kBandVoxels;                  ///< of a band
};

/// Stages `read` and, as needed, `distance` and `visibility`; a file of fields leaves no choice of surface (UsageError
/// for any such option) and has its distance and octants, packed if they are wanted as rgba8.
SweptScene loadScene(const SurfaceRequest& request, const FieldNeeds& needs, StageLog& log);

/// Bytes that the visibility takes.
std::size_t visibilityBytes(const OctantVisibility& visibility);

/// "256x256x256 voxels".
std::string gridText(const SweptScene& scene);

/// World corners of the box that holds the whole solid: its voxels and the one beyond them, within the grid.
std::array<glm::dvec3, 8> solidCorners(const Surface& surface);

const char* insideName(Inside inside);

}  // namespace isolume
