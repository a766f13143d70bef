// Carries closest points through the whole grid: two passes over its z planes, one up, one down, and of what both bring
// to a sample the nearer.
//
// A candidate for a sample is a neighbour's offset plus the step to that neighbour; it replaces the sample's own if its
// square is strictly smaller (ties keep the old one, so the order below is the tie rule). A pass, which starts from the
// fixed samples alone, takes per plane, in this order:
//   1. nine candidates from the plane before, dy = -1, 0, 1 outermost, dx = -1, 0, 1 inside;
//   2. rows in rising y three candidates (dx = -1, 0, 1) each from the row before, then rows in falling y;
//   3. columns in rising x three candidates (dy = -1, 0, 1) each from the column before, then columns in falling x;
//   4. the fixed samples get their own points back;
//   5. the first pass that visits a sample keeps the square of its distance there, the second writes the distance.
// Closest points travel almost without turning back, so neither pass needs what the other has found: a second round
// from the nearer points of both shortens the mean distance on a torus at 64^3 by 2e-5 voxels and no distance by more
// than .05. Along y and x a point may go its way in any order, by steps 2 and 3; with one candidate alone per sample in
// step 3, from the column before, ways within planes were off by up to .25 voxel. Neighbours differ by the spacing at
// most, to a few thousandths on thin sheets. After [Danielsson80] (vector distance transform by raster scans), with
// subvoxel points instead of voxel centres.
//
// No offset but the fixed samples' own is ever written to the field, so that memory that the band has not touched stays
// untouched in two of its components.
//
// Cost: 2 (9 + 6 + 6) candidates per voxel, SIMD along x (in step 3 along y, in a transposed plane), O(nx ny) scratch.
// The two passes run beside each other: towards each other up to the middle of the planes with fixed samples, then on
// through what the other has kept. Within a pass steps 2 and 3 run on one thread, all else by groups of rows. Bitwise
// the same for any number of lanes and threads.
#pragma once

#include "offset_field.h"
#include "sweep/bit_grid.h"

namespace isolume {

/// Both passes over `field`, of which only the samples of `fixed` (at least one) need to be set. Writes the signed
/// distance in world units over the first components; the others are left as they were.
void carryOffsets(GridView<const float> level, const BitGrid& fixed, OffsetField& field);

}  // namespace isolume
