// A surface coloured by another field of the same world: what was asked for, and the field that the renderer takes.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "raymarch/color_field.h"
#include "src/jobs/stage_log.h"

namespace isolume {

enum class ColorMap { sequential, diverging, grey };

struct ColorRequest {
  std::string by;                   ///< a volume's file, or x, y or z: a coordinate; empty: one colour
  std::string grid;                 ///< of a VDB file, as ReadOptions::grid
  std::optional<glm::dvec2> range;  ///< values that the ends of the map stand for; default: those that there are
  std::optional<ColorMap> map;      ///< default: sequential
};

/// UsageError for a part of the request without the field that it is of.
void checkColorRequest(const ColorRequest& request);

/// 4 bytes per sample of the field's own grid.
struct SurfaceColoring {
  Grid<float> places;
  glm::dmat4 worldFromGrid{1};
  glm::dvec2 range{0};
  ColorMap map = ColorMap::sequential;
  std::vector<std::string> files;  ///< every file that was read
  ColorField field() const;
};

/// Stage `colours`. NaN and infinities are unknown. InputError: no finite value, or a field that misses the solid's
/// box, whose world corners are `corners`.
SurfaceColoring readColoring(const ColorRequest& request, const std::array<glm::dvec3, 8>& corners, StageLog& log);

const char* colorMapName(ColorMap map);
/// As options of the command line, with the range that it comes to.
nlohmann::ordered_json colorSettings(const ColorRequest& request, const SurfaceColoring& coloring);

}  // namespace isolume
