// Which parts of a grid's rows a band of distances can reach, for sweeping nothing else.
//
// An update is never below the smallest upwind value by more than delta = 1 / sqrt(sum 1 / h_i^2) added to it, so a
// value below K hangs on a start value by a chain of at most K / delta neighbours: the samples no further than that
// along each axis from a fixed one hold all values below K. Thread-safe.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "sweep/bit_grid.h"
#include "wavefront.h"

namespace isolume {

/// The longest chain to a value below `bound`, in samples; no more than the longest axis. Spacing in units of the
/// smallest.
int longestChain(glm::ivec3 size, glm::dvec3 spacing, float bound);

/// Runs along x of what lies no further than `chain` along each axis from a sample of `fixed`, for the rows of a tile
/// together. Runs less than a vector's lanes apart are one: each costs so many more steps.
std::vector<TileSpan> bandSpans(const BitGrid& fixed, int chain, const TileGrid& tiles, int block, int layer);

}  // namespace isolume
