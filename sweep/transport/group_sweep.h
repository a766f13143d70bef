// One group of ordinates on its way through the grid (fixed_transport.h).
#pragma once

#include <cstdint>
#include <vector>

#include "light_strip.h"
#include "ordinate_groups.h"
#include "row_contents.h"
#include "strip_places.h"

namespace isolume {

/// What all groups share. Borrowed.
struct GroupScene {
  glm::ivec3 size;
  glm::dvec3 spacing;
  const TransportOptions& options;
  const RowContents& rows;
  const StripPlaces& up;    ///< for sweeps that run up in y
  const StripPlaces& down;  ///< for those that run down
  int blockStrips = 1;      ///< strips of a block
};

/// Strips of a block of a grid: what they carry fits into the cache.
int blockStrips(glm::ivec3 size, int lanes);

/// Adds to sums[2 i] what point i misses, and to sums[2 i + 1] what it would have (PlaceSum).
void sweepGroup(const GroupScene& scene, const OrdinateGroup& group, std::int32_t* sums);

}  // namespace isolume
