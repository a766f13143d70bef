// Closest points taken over from neighbours, for the samples of one row at a time, in SIMD.
//
// A candidate is a neighbour's offset plus the step to it; the nearest one counts, and of equals the first in the order
// of the steps (rising z, y, x). Only samples of the set have points: nothing else of the field is read. What is found
// goes to the end of a batch. The same bits on every target. Thread-safe.
#pragma once

#include "offset_field.h"
#include "point_batch.h"
#include "sweep/bit_grid.h"

namespace isolume {

/// The points that there are.
struct KnownPoints {
  const OffsetField& field;
  const BitGrid& set;
  glm::vec3 unit{1};  ///< the spacing in smallest spacings
};

/// Samples of `wanted` in row (y, z), none of the set: offsets are the nearest candidate across faces; where there is
/// none, across edges; else across corners, of which there must be one. Trials are the feet of the samples on the plane
/// through that point across the neighbour's own offset: where the surface is flat, the closest points.
void appendStarts(const KnownPoints& known, int y, int z, const BitRow& wanted, PointBatch& batch);

/// Those samples of `wanted`, all of the set, that have a candidate across faces whose square is less than `share`
/// times that of their own point: offset and trial are the nearest of these.
void appendNearer(const KnownPoints& known, int y, int z, const BitRow& wanted, float share, PointBatch& batch);

/// Those samples of `wanted`, all of the set, one of whose neighbours across faces has a point that is not on the sheet
/// of their own: it leaves the plane there, across the offset, by more than kSameSheet. Offset and trial are their own.
void appendDoubtful(const KnownPoints& known, int y, int z, const BitRow& wanted, PointBatch& batch);

}  // namespace isolume
