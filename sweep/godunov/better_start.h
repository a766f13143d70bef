// Start values of the distance sweep from the interpolant itself, in place of [Singh10]'s axis minimum.
//
// A sample v with crossed edges sees the surface of the trilinear interpolant f in one of its eight cells: along each
// axis towards the nearer crossing or, where no edge is crossed, towards smaller |f|. In that cell, Newton's method for
// the closest point: from p, the foot of the perpendicular from v to the tangent plane of f at p,
//
//   p' = v + G (G . (p - v) - f(p)) / |G|^2,   G = grad f(p);   start value = |G . (p - v) - f(p)| / |G|.
//
// It begins at v with one-sided slopes. Never more than the axis minimum. Where the foot leaves the cell by more than
// kReach the cell says nothing of the closest point (a crease, a sheet thinner than a voxel, a plateau): the value is
// then 1 / sqrt(sum 1 / d_i^2) over the crossed axes, d_i the nearer crossing, which is exact for planes that cross
// every axis. Sums and products of three axes are taken in sorted order, so mirrored and permuted grids give the same
// bits.
//
// Units: the smallest spacing. Levels are divided by the largest of the cell, so that any magnitude will do. O(1) per
// sample at the surface, vectorised over them; bitwise the same for any SIMD width. Thread-safe.
#pragma once

#include <glm/vec3.hpp>

#include "sweep/grid.h"

namespace isolume {

/// Replaces the fixed values of row (y, z) by better ones. `row` holds what the axis minimum gives (surface_start.h);
/// `spacing` in units of the smallest.
void betterStartRow(GridView<const float> level, glm::vec3 spacing, int y, int z, float* row);

}  // namespace isolume
