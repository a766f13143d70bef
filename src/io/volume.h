// A volume as it was read: samples, where they stand in the world, and what the file said about itself.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sweep/grid.h"
#include "sweep/level.h"

namespace isolume {

enum class GridKind { unknown, levelSet, fog };

struct Volume {
  /// 4 B/voxel. NaN and infinities are kept. The spacing is that of worldFromGrid, the origin its translation.
  Grid<float> values;
  /// The sample's true value is values + valueOffset. Not 0 only where a 32-bit integer or float64 file has a mean so
  /// far from 0 that float32 would lose its variation.
  double valueOffset = 0;
  /// Index to world: columns orthogonal (rotation or reflection times spacing), plus translation.
  glm::dmat4 worldFromGrid{1};
  GridKind kind = GridKind::unknown;
  std::string format;              ///< "VDB", "raw", "MetaImage", ...
  std::string sampleType;          ///< as stored: "int16", "half", ...
  std::string gridName;            ///< VDB only
  std::string world;               ///< what the world is: "LPS millimetres", or "" where the file does not say
  std::vector<std::string> files;  ///< every file that was read: header and data
  std::vector<std::string>
      notes;  ///< one line each, to be told once: precision lost, dimensions taken from the name, ...
};

/// What the user says about a raw file; anything set here wins over the file's name, and is an error for a format that
/// describes itself.
struct RawLayout {
  std::optional<glm::ivec3> dims;
  std::optional<std::string> type;  ///< uint8 int8 uint16 int16 uint32 int32 float32 float64
  std::optional<bool> bigEndian;
  std::optional<std::size_t> offset;  ///< bytes to skip
  std::optional<glm::dvec3> spacing;
  std::optional<glm::dvec3> origin;
};

struct ReadOptions {
  std::string grid;  ///< VDB: NAME or NAME[i]; empty: the only scalar grid
  RawLayout raw;
};

/// Reads any supported format, told by content where the format has a signature, else by the name. InputError: one line
/// naming the file, what was expected and what was found.
Volume readVolume(const std::string& path, const ReadOptions& options = {});

}  // namespace isolume
