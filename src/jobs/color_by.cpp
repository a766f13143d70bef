#include "src/jobs/color_by.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <utility>

#include "src/compare/color_map.h"
#include "src/errors.h"
#include "src/io/srgb.h"
#include "src/io/statistics.h"
#include "src/io/volume.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

/// A map of so many colours, straight lines between them, has no visible steps.
constexpr int kColors = 257;

glm::vec3 colorAt(ColorMap map, double share) {
  switch (map) {
    case ColorMap::sequential:
      return sequentialColor(share);
    case ColorMap::diverging:
      return divergingColor(2 * share - 1);
    case ColorMap::grey:
      return glm::vec3(linearFromSrgb(static_cast<float>(share)));
  }
  return glm::vec3(0);
}

int coordinateOf(const std::string& by) {
  const std::size_t axis = std::string("xyz").find(by);
  return by.size() == 1 && axis != std::string::npos ? static_cast<int>(axis) : -1;
}

/// A coordinate is linear: two samples along each axis hold it, at the corners of the box around the solid.
Volume coordinateVolume(int axis, const std::array<glm::dvec3, 8>& corners) {
  glm::dvec3 low = corners[0], high = corners[0];
  for (const glm::dvec3& corner : corners) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  Volume volume;
  volume.values = Grid<float>(glm::ivec3(2), high - low, low);
  volume.valueOffset = low[axis];
  for (std::size_t i = 0; i < volume.values.count(); ++i)
    volume.values.data()[i] = (i >> axis & 1) != 0 ? static_cast<float>(high[axis] - low[axis]) : 0.0F;
  for (int c = 0; c < 3; ++c) volume.worldFromGrid[c][c] = high[c] - low[c];
  volume.worldFromGrid[3] = glm::dvec4(low, 1);
  return volume;
}

/// Both boxes along the axes of the field.
bool reachesBox(const Volume& volume, const std::array<glm::dvec3, 8>& corners) {
  const glm::dmat4 gridFromWorld = glm::inverse(volume.worldFromGrid);
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 at(gridFromWorld * glm::dvec4(corner, 1));
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  constexpr double kHalfVoxel = 0.5;
  return glm::all(glm::lessThanEqual(low, glm::dvec3(volume.values.size()) - 1.0 + kHalfVoxel)) &&
         glm::all(glm::greaterThanEqual(high, glm::dvec3(-kHalfVoxel)));
}

Grid<float> colorPlaces(const Volume& volume, glm::dvec2 range) {
  Grid<float> places(volume.values.size(), volume.values.view().spacing, volume.values.view().origin);
  const double low = range[0] - volume.valueOffset, length = range[1] - range[0];
  const auto layer = places.count() / static_cast<std::size_t>(places.size().z);
  parallelFor(static_cast<std::size_t>(places.size().z), [&](std::size_t z) {
    for (std::size_t i = z * layer; i < (z + 1) * layer; ++i) {
      const float value = volume.values.data()[i];
      places.data()[i] = std::isfinite(value)
                             ? std::clamp(static_cast<float>((value - low) / length), -kLargestPlace, kLargestPlace)
                             : kUnknownPlace;
    }
  });
  return places;
}

}  // namespace

const char* colorMapName(ColorMap map) {
  switch (map) {
    case ColorMap::sequential:
      return "sequential";
    case ColorMap::diverging:
      return "diverging";
    case ColorMap::grey:
      return "grey";
  }
  return nullptr;
}

void checkColorRequest(const ColorRequest& request) {
  const char* part = !request.grid.empty() ? "--color-grid"
                     : request.range       ? "--color-range"
                     : request.map         ? "--color-map"
                                           : nullptr;
  if (part && request.by.empty()) throw UsageError(fmt::format("{}: expected --color-by beside it, found none", part));
  if (coordinateOf(request.by) >= 0 && !request.grid.empty())
    throw UsageError(fmt::format("--color-grid: expected a file to colour by, found the coordinate {}", request.by));
}

ColorField SurfaceColoring::field() const {
  ColorField field;
  field.places = places.view();
  field.worldFromGrid = worldFromGrid;
  for (int i = 0; i < kColors; ++i) field.colors.push_back(colorAt(map, static_cast<double>(i) / (kColors - 1)));
  return field;
}

SurfaceColoring readColoring(const ColorRequest& request, const std::array<glm::dvec3, 8>& corners, StageLog& log) {
  log.begin("colours", "colouring by " + request.by);
  const int axis = coordinateOf(request.by);
  const Volume volume =
      axis >= 0 ? coordinateVolume(axis, corners) : readVolume(request.by, {.grid = request.grid, .raw = {}});
  for (const std::string& note : volume.notes) log.tell("note", note);
  if (!reachesBox(volume, corners))
    throw InputError(fmt::format("{}: expected a field that reaches the surface, found it beside its box", request.by));
  SurfaceColoring coloring;
  const VolumeStatistics statistics = computeStatistics(volume);
  if (!request.range && !(statistics.min < statistics.max))
    throw InputError(fmt::format("{}: expected values that differ, or a --color-range, found {} finite ones of {}",
                                 request.by, statistics.count - statistics.nanCount - statistics.infCount,
                                 statistics.count));
  coloring.range = request.range.value_or(glm::dvec2(statistics.min, statistics.max));
  coloring.places = colorPlaces(volume, coloring.range);
  coloring.worldFromGrid = volume.worldFromGrid;
  coloring.map = request.map.value_or(ColorMap::sequential);
  coloring.files = volume.files;
  log.end(coloring.places.count() * sizeof(float));
  return coloring;
}

nlohmann::ordered_json colorSettings(const ColorRequest& request, const SurfaceColoring& coloring) {
  nlohmann::ordered_json settings;
  settings["color-by"] = request.by;
  if (!request.grid.empty()) settings["color-grid"] = request.grid;
  settings["color-range"] = fmt::format("{},{}", coloring.range[0], coloring.range[1]);
  settings["color-map"] = colorMapName(coloring.map);
  return settings;
}

}  // namespace isolume
