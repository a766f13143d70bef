// Which samples are near the surface, 64 at a time: from the signs of the level, by operations on rows of bits.
//
// Thread-safe for different rows of output.
#pragma once

#include "bit_grid.h"

namespace isolume {

/// Bits of value > 0 for `count` values, into whole words (rounded up), zeros beyond. NaN is 0.
void positiveBits(const float* values, int count, std::uint64_t* words);

/// The same bits of those that say fixed (surface_start.h).
void fixedBits(const float* values, int count, std::uint64_t* words);

/// The samples with level > 0. Threaded.
BitGrid insideSamples(GridView<const float> level);

/// Samples of row (y, z) with a neighbour of the other sign along an axis.
void crossedRow(const BitGrid& inside, int y, int z, BitRow& row);

/// Samples of row (y, z) that lie inside on the border of the grid: the cap.
void capRow(const BitGrid& inside, int y, int z, BitRow& row);

/// Corners of cells with samples on both sides, in row (y, z).
void cornerRow(const BitGrid& inside, int y, int z, BitRow& row);

/// Neighbours of a sample: the 6 across faces; with those across edges, 18; with those across corners, 26. The value:
/// steps along an axis, one at most along each.
enum class Across { faces = 1, edges = 2, corners = 3 };

/// Samples of row (y, z) that are in `set` or one of whose neighbours is.
void grownRow(const BitGrid& set, Across across, int y, int z, BitRow& row);

}  // namespace isolume
