// The openness of a level as the program computes it, and its value at points of the surface.
#pragma once

#include <glm/common.hpp>
#include <vector>

#include "support/octant_openness.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/ordinates/openness_sweep.h"

namespace isolume::test {

inline constexpr double kOpen = 65535;

inline SurfaceField opennessOf(GridView<const float> level, const OrdinateOptions& options = {}) {
  const Grid<float> distance = closestDistance(level, {.extent = DistanceExtent::band});
  return sweepOpenness(level, distance.view(), options);
}

/// Of all padded samples.
inline std::vector<std::uint16_t> paddedNumbers(const SurfaceField& field) {
  std::vector<std::uint16_t> numbers(voxelCount(field.paddedSize()));
  field.copyLayers(0, field.paddedSize().z, numbers.data());
  return numbers;
}

/// At a point of index space within the grid, 1 = open. At least two samples per axis.
inline double opennessAt(const SurfaceField& values, glm::dvec3 position) {
  return surfaceValueAt(values, position) / kOpen;
}

/// visit(sample) for each sample at least `margin` from the border.
template <class Visit>
void forEachWithin(glm::ivec3 size, int margin, const Visit& visit) {
  for (int z = margin; z < size.z - margin; ++z)
    for (int y = margin; y < size.y - margin; ++y)
      for (int x = margin; x < size.x - margin; ++x) visit(glm::ivec3(x, y, z));
}

/// Has any of the 26 samples around it on the other side; not on the border.
inline bool isNextToSurface(GridView<const float> level, glm::ivec3 at) {
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 p = at + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if ((level(p.x, p.y, p.z) > 0) != (level(at.x, at.y, at.z) > 0)) return true;
  }
  return false;
}

}  // namespace isolume::test
