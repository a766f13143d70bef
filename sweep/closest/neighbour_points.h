// Closest points taken over from neighbours, for many samples of one z plane at once, in SIMD.
//
// A candidate is a neighbour's offset plus the step to it; it replaces the sample's own offset if it is strictly nearer
// (by the factor that is asked for), in the order of the steps. Unset neighbours and those beyond the grid never are.
// The same bits on every target. Thread-safe.
#pragma once

#include <span>

#include "offset_field.h"
#include "point_batch.h"

namespace isolume {

/// The steps to neighbours across faces, edges and corners.
using NeighbourSteps = std::span<const glm::ivec3>;
NeighbourSteps faceSteps();
NeighbourSteps edgeSteps();
NeighbourSteps cornerSteps();

/// Offset and trial of each sample become the nearest of its own point and the candidates; the state says whether a
/// candidate was taken: settled, else searching. A candidate's square must be less than `share` times the own one's.
/// `unit` is the spacing in smallest spacings.
void takeFromNeighbours(const OffsetField& field, glm::vec3 unit, int z, NeighbourSteps steps, float share,
                        PointBatch& batch);

/// Offset and trial become the sample's own point. State stuck for samples one of whose neighbours across faces has a
/// point that is not on the sheet of their own: it leaves the plane there, across the offset, by more than kSameSheet.
/// State searching for all others.
void doubtNeighbours(const OffsetField& field, glm::vec3 unit, int z, PointBatch& batch);

}  // namespace isolume
