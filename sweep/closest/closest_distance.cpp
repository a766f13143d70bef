#include "closest_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plane_pass.h"
#include "row_kernels.h"
#include "surface_band.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// `limit` everywhere but in the band; negative inside.
void writeBandDistance(GridView<const float> level, const BitGrid& band, float limit, OffsetField& field) {
  const auto unit = static_cast<float>(smallestSpacing(level.spacing));
  parallelFor(static_cast<std::size_t>(level.size.z), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    for (int y = 0; y < level.size.y; ++y) {
      const std::size_t at = level.index(0, y, z);
      const float* levels = level.data + at;
      float* row = field.component[0].data() + at;
      int x = 0;
      const auto limitTo = [&](int end) {
        for (; x < end; ++x) row[x] = levels[x] > 0 ? -limit : limit;
      };
      forEachRun(band.row(y, z), band.words(), [&](int begin, int end) {
        limitTo(begin);
        offsetsToDistance(row + x, field.component[1].data() + at + x, field.component[2].data() + at + x, levels + x,
                          unit, static_cast<std::size_t>(end - begin), row + x);
        x = end;
      });
      limitTo(level.size.x);
    }
  });
}

bool anyIn(const BitGrid& set) {
  for (int z = 0; z < set.size().z; ++z)
    if (set.anyInPlane(z)) return true;
  return false;
}

}  // namespace

Grid<float> closestDistance(GridView<const float> level, const ClosestOptions& options) {
  OffsetField field(level);
  const BitGrid band = solveBand(level, options.bandVoxels, field);
  if (!anyIn(band)) {
    // No sample is inside: a grid that is all inside has its cap.
    std::fill_n(field.component[0].data(), level.count(), std::numeric_limits<float>::infinity());
  } else if (options.extent == DistanceExtent::band) {
    const double limit = (options.bandVoxels + 1) * smallestSpacing(level.spacing);
    writeBandDistance(level, band, static_cast<float>(limit), field);
  } else {
    carryOffsets(level, band, field);
  }
  return std::move(field.component[0]);
}

}  // namespace isolume
