// Certified lower bounds of the distance to the isosurface: a step of such a length along a ray crosses nothing.
//
// The surface is the boundary of { level > 0 } of the trilinear interpolant within the box of the samples, without the
// caps at the border (a ray knows the box). In a cell whose eight corners are on one side the interpolant is a mean of
// them with weights >= 0 and stays on that side, so the surface lies in M, the union of the mixed cells (closed boxes).
// Hence d(x) = distance of x to M is a lower bound everywhere, exact up to the diagonal of a cell, and changes by at
// most the way that one goes. Two bounds follow from it:
//
//   cellLowerBound()   L(c) = min d over the closed cell c, from the data alone: exact, one number per cell;
//   certifyField()     (u(x) - shift) / slope <= d(x), u the trilinear interpolant of |D| for the field D of any
//   solver.
//
// What cannot be used is D itself. First-order upwinding overestimates at 87 to 98 % of all samples, by more than a
// voxel; and every |D| of the closest-point solver is the distance to some point of the surface, an upper bound:
// nothing bounds how much nearer a point is that the propagation missed (where the Voronoi cell of that point is
// narrower than the stencil). certifyField() needs neither theory: it measures the very values that are traced.
//
// Proof for certifyField(). shift is the largest |D| of a corner of a mixed cell, so u <= shift on M. slope is the
// largest |grad u| over all other cells. For x outside M let m be the nearest point of M: the segment [x, m) lies in
// the box and outside M, so u(x) - u(m) <= slope |x - m|, and (u(x) - shift) / slope <= |x - m| = d(x). Within a cell
// du/dx is bilinear in y and z and does not depend on x, and so on, so |grad u|^2 is convex along each axis and largest
// at a corner, where the three edges that meet there are its components: slope^2 = max over corners of sum (edge/h)^2.
//
// The renderer steps by its clearance and not by these: cubes of cells take a tenth to a fifth fewer steps than balls
// (tests/bench/rays counts them), for a byte per cell.
//
// Unit: the smallest spacing ("voxels"). Unsigned. Nothing mixed: d is infinite, the cell bound is kBoundReach
// everywhere, and any field is a bound. Thread-safe; bitwise the same for any number of threads and any SIMD width.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "sweep/grid.h"

namespace isolume {

/// Cell bounds end here: nothing is gained by longer steps, and the search ends too.
inline constexpr float kBoundReach = 128;

/// L(c) for each of the (size - 1) cells, x fastest, at most kBoundReach, rounded towards 0. `level` as of makeLevel(),
/// at least two samples along each axis.
///
/// Between two boxes of a lattice the distance is that of their gaps, h_i max(|c_i - m_i| - 1, 0), whose squares add up
/// over the axes: three separable passes of min-plus convolutions ([Saito94]), each a search outwards that ends where
/// the gap alone exceeds what was found. O(n kBoundReach) at worst, O(n distance) as a rule: 10 to 17 times the cost of
/// the clearance (raymarch/clearance.h) at 256^3. 4 B per cell and O(n^(2/3)).
Grid<float> cellLowerBound(GridView<const float> level);

struct FieldBound {
  float shift = 0;  ///< voxels
  float slope = 1;  ///< at least 1
  /// `magnitude`: the interpolant of |D| in voxels, from samples as they were certified. May be negative: no bound
  /// then.
  float operator()(float magnitude) const { return (magnitude - shift) / slope; }
};

/// For a field of distances in voxels (any sign, e.g. a solver's result over the smallest spacing). Rounding of the
/// differences and of operator() is folded in; that of an interpolation is the caller's: a texture unit with w-bit
/// weights is off by up to 3/2 slope 2^-w. A value that is not finite leaves no bound (shift = +inf). O(n).
FieldBound certifyField(GridView<const float> level, GridView<const float> field);
/// The same for half-precision values, so that their rounding is part of what is measured.
FieldBound certifyField(GridView<const float> level, GridView<const std::uint16_t> field);

}  // namespace isolume
