// transportOpenness() for pictures: the same openness at the same points, in 15 bits (light_strip.h).
//
// A group of ordinates passes the grid by blocks of rows, each of them through all planes, so that what a block carries
// from plane to plane stays in the cache; from block to block goes the light of a block's last row, a value per sample
// of a face of the grid. What the ordinates see at the points is summed as the planes go by (place_reader.h).
//
// Against transportOpenness(): 3e-4 off at most in noise, 1e-4 in scenes (corner and capsules at 64^3, 72 ordinates).
// Integers, and no lane needs another's: the same bits for any number of threads and any SIMD width. Groups run beside
// each other.
//
// Cost: O(voxels x ordinates), bench_ordinates. Memory: 1/16 byte per voxel for what need not be computed again
// (row_contents.h); 110 bytes per point, 8 more for each thread; for each group at work, of 16 (32) ordinates,
// 32 (64) bytes for each sample of a face across y, and a megabyte.
#pragma once

#include <vector>

#include "openness_transport.h"

namespace isolume {

/// As transportOpenness(), by points; what of the hemisphere is blocked, 1 - A: 0 in the open, exactly.
std::vector<float> transportBlocked(GridView<const float> distance, const std::vector<OpenPoint>& points,
                                    const TransportOptions& options = {});

}  // namespace isolume
