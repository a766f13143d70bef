// Judges many rays of the exact tracer against brute force, and counts.
#pragma once

#include <cstdint>
#include <string>

#include "sweep/grid.h"
#include "sweep/reference/surface_tracer.h"

namespace isolume::test {

struct HitCounts {
  std::int64_t rays = 0;     ///< first hits judged
  std::int64_t hits = 0;     ///< of them on the isosurface from outside
  std::int64_t inside = 0;   ///< of them from inside the solid
  std::int64_t caps = 0;     ///< of them on the box, from either side
  std::int64_t ties = 0;     ///< the two differ, but only where the level is 0 to rounding
  std::int64_t leaving = 0;  ///< rays on from a hit, judged
  std::int64_t blocked = 0;  ///< of them blocked
  std::int64_t grazing = 0;  ///< of those too flat to the surface for brute force to tell their start
  std::int64_t wrong = 0;    ///< misses, false hits and wrong places
  std::string firstWrong;    ///< what the first wrong one is

  HitCounts& operator+=(const HitCounts& other);
  std::string text() const;
};

/// Random rays (random_rays.h) number `first` to first + count - 1, and from each hit on the isosurface one random ray
/// on. A first hit is right if it lies within 1e-9 voxels of the judge's, or if between the two the level (for a ray
/// from inside: minus the level) exceeds 0 by no more than rounding, 2^-38 of the largest corner of the cell.
HitCounts judgeHits(const SurfaceTracer& tracer, std::int64_t first, std::int64_t count);

}  // namespace isolume::test
