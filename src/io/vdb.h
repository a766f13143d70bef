// OpenVDB behind a plain interface: the only header through which the rest of the program reaches it.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sweep/grid.h"
#include "sweep/level.h"
#include "sweep/occlusion_sweep.h"
#include "volume.h"

namespace isolume {

struct VdbGridInfo {
  std::string name;       ///< as it can be given to --grid: NAME, or NAME[i] where names repeat
  std::string type;       ///< "float", "double", "half" (float stored as half), "int32", "bool", "vec3s", ...
  std::string kind;       ///< "level set", "fog volume", ...
  bool scalar = false;    ///< can be rendered
  std::string transform;  ///< one line
  std::size_t activeCount = 0;
  glm::ivec3 indexMin{0}, indexMax{-1};  ///< active bounding box, inclusive
};
std::vector<VdbGridInfo> listVdbGrids(const std::string& path);

/// One scalar grid, dense over its active bounding box and one voxel of background around it.
Volume readVdb(const std::string& path, const std::string& grid);

/// What `fields` saves and `render` starts from without a sweep. Grids: level, distance, visibility_nnn ...
/// visibility_ppp (float, octant names of sweep/octants.h), with the world transform; the box, the isovalue and the
/// side in file metadata.
struct FieldsFile {
  Grid<float> level;
  SweptFields swept;  ///< float32 octants
  glm::dmat4 worldFromGrid{1};
  double isovalue = 0;
  Inside inside = Inside::above;
  LevelSummary summary;
  std::string source;  ///< how it was made, one line
  /// Further grids for other programs, with 0 as background: written, not read back.
  std::vector<std::pair<std::string, Grid<float>>> others;
};
bool isFieldsFile(const std::string& path);  ///< a VDB that writeFields() made; false for anything else
/// Returns the file's bytes: the caller writes them (output_file.h).
std::string encodeFields(const FieldsFile& fields);
FieldsFile readFields(const std::string& path);

/// A level set (narrow band of 3 voxels when `levelSet`, dense otherwise) as VDB bytes; for `sample`.
std::string encodeVdb(GridView<const float> values, const glm::dmat4& worldFromGrid, const std::string& name,
                      bool levelSet);

}  // namespace isolume
