// Closest points taken over from neighbours across faces, for many samples of one z plane at once, in SIMD.
//
// A candidate is a neighbour's offset plus the step to it; it replaces the sample's own offset if it is strictly nearer
// (by the factor that is asked for). Unset neighbours and those beyond the grid never are. Order: x - 1, x + 1, y - 1,
// y + 1, z - 1, z + 1. The same bits on every target. Thread-safe.
#pragma once

#include "offset_field.h"
#include "point_batch.h"

namespace isolume {

/// Which neighbours may give: bits.
inline constexpr unsigned kAlongX = 1, kAlongY = 2, kAlongZ = 4;

/// Replaces batch.offset by the nearest candidate, where its square is less than `share` times that of the offset;
/// the state becomes settled there and searching elsewhere. The trial becomes the offset. `step` in smallest spacings.
void takeFromNeighbours(const OffsetField& field, glm::vec3 step, int z, unsigned axes, float share, PointBatch& batch);

/// State stuck for samples one of whose neighbours' points is not on the sheet of their own: it leaves the plane there,
/// across the offset, by more than kSameSheet. State searching for all others.
void doubtNeighbours(const OffsetField& field, glm::vec3 step, int z, PointBatch& batch);

}  // namespace isolume
