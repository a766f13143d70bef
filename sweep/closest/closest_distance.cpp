#include "closest_distance.h"

#include <cmath>
#include <limits>

#include "plane_pass.h"
#include "row_kernels.h"
#include "surface_band.h"
#include "sweep/parallel.h"

namespace isolume {

Grid<float> closestDistance(GridView<const float> level, const ClosestOptions& options) {
  OffsetField field(level);
  const bool hasSurface = startOffsets(level, options.band, field) > 0;
  if (hasSurface) {
    for (int round = 0; round < options.rounds; ++round) carryOffsets(field);
  }
  // Without a surface there is nothing inside: a grid that is all inside has its cap.
  const float unit =
      hasSurface ? static_cast<float>(smallestSpacing(level.spacing)) : std::numeric_limits<float>::infinity();
  const std::size_t perPlane = voxelCount({level.size.x, level.size.y, 1});
  parallelFor(static_cast<std::size_t>(level.size.z), [&](std::size_t z) {
    const std::size_t first = z * perPlane;
    offsetsToDistance(field.component[0].data() + first, field.component[1].data() + first,
                      field.component[2].data() + first, level.data + first, unit, perPlane);
  });
  return std::move(field.component[0]);
}

}  // namespace isolume
