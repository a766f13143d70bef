#include "placement.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>
#include <limits>
#include <new>

#include "errors.h"
#include "memory_limit.h"

namespace isolume {
namespace {

/// Headers keep 6 or 7 digits, which makes right angles right to about 1e-6. 1e-4 moves no sample: positions use the
/// matrix as it is, and distances along the axes are off by that much at most.
constexpr double kMaxShear = 1e-4;

glm::dvec3 columnLengths(const glm::dmat4& m) {
  glm::dvec3 lengths;
  // The three-argument hypot scales by the largest entry, so the length of an axis-aligned column is exact.
  for (int i = 0; i < 3; ++i) lengths[i] = std::hypot(m[i].x, m[i].y, m[i].z);
  return lengths;
}

}  // namespace

glm::dmat4 placeGrid(const std::string& path, glm::dvec3 spacing, const glm::dmat3& direction, glm::dvec3 origin) {
  glm::dmat4 worldFromGrid(1);
  for (int i = 0; i < 3; ++i) worldFromGrid[i] = glm::dvec4(direction[i] * spacing[i], 0);
  worldFromGrid[3] = glm::dvec4(origin, 1);
  checkPlacement(path, worldFromGrid);
  return worldFromGrid;
}

void checkPlacement(const std::string& path, const glm::dmat4& worldFromGrid) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      if (!std::isfinite(worldFromGrid[column][row]))
        throw InputError(fmt::format("{}: expected finite spacing, direction and origin, found {}", path,
                                     worldFromGrid[column][row]));
  const glm::dvec3 lengths = columnLengths(worldFromGrid);
  for (int i = 0; i < 3; ++i)
    if (!(lengths[i] > 0) || !std::isfinite(lengths[i]))
      throw InputError(fmt::format("{}: expected a spacing above 0 along each axis, found {} {} {}", path, lengths.x,
                                   lengths.y, lengths.z));
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double cosine =
        glm::dot(glm::dvec3(worldFromGrid[i]) / lengths[i], glm::dvec3(worldFromGrid[j]) / lengths[j]);
    if (std::abs(cosine) > kMaxShear)
      throw InputError(fmt::format("{}: expected axes at right angles, found axes {} and {} with cosine {:.6g} (shear)",
                                   path, "xyz"[i], "xyz"[j], cosine));
  }
}

Grid<float> makeGrid(const std::string& path, glm::i64vec3 size, const glm::dmat4& worldFromGrid,
                     std::size_t scratchBytesPerSample) {
  for (int i = 0; i < 3; ++i)
    if (size[i] < 2 || size[i] > std::numeric_limits<int>::max())
      throw InputError(fmt::format("{}: expected at least 2 samples along each of three axes, found {}x{}x{}", path,
                                   size.x, size.y, size.z));
  requireMemory(path, size, sizeof(float) + scratchBytesPerSample);
  try {
    return Grid<float>(glm::ivec3(size), columnLengths(worldFromGrid), glm::dvec3(worldFromGrid[3]));
  } catch (const std::bad_alloc&) {
    throw InputError(fmt::format("{}: {}x{}x{} samples need {} of memory, which the system refuses", path, size.x,
                                 size.y, size.z, formatBytes(voxelCount(glm::ivec3(size)) * sizeof(float))));
  }
}

}  // namespace isolume
