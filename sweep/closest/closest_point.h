// The point of the isosurface that is closest to one sample, on the trilinear interpolant of the level: the careful
// form, in double, for what the vector kernels (point_kernels.h) leave over.
//
// Offsets are from the sample, in units of the smallest spacing. What is returned is always a point of the surface (to
// kOnSurface), so its distance is an upper bound of the true one; near a smooth surface it is the true one.
//
// Solves min |p - v| subject to f(p) = 0 by Newton's method on p - v + m grad f(p) = 0, f(p) = 0, for p and m:
//   (I + m H) dp + m' g = -(p - v),  g . dp = -f,  m = -(p - v) . g / |g|^2,  g = grad f(p), H = Hessian of f,
// each step followed by steps back onto the surface, p -= f g / |g|^2. A step counts only if it ends on the surface and
// closer than before; if it does not, steps along the tangent plane towards the foot of v are tried, shorter each time.
// An error e along the surface changes the distance by e^2 / (2 distance) alone. Where it cannot move (saddles with
// g = 0, creases between cells) the last point found stays. On the border of the grid the steps run along the border.
// A fraction of a microsecond per sample; thread-safe.
#pragma once

#include <glm/vec3.hpp>

#include "level_cell.h"

namespace isolume {

/// How far from the surface a point may lie and still count as a point of it, in units of the smallest spacing.
inline constexpr double kOnSurface = 1e-6;

/// A start belongs to the sheet already found if it leaves the tangent plane there by less than this slope. A sphere of
/// radius 4 spacings leaves its own plane by less within two spacings.
inline constexpr double kSameSheet = .25;

/// Moves `offset`, a point of the surface, closer to its sample as far as the steps above go. True if it moved.
bool refineOffset(const LevelInterpolant& level, glm::ivec3 sample, glm::dvec3& offset);

/// Closest surface point among the cells around `sample`: starts from the crossed edges of every one of those cells
/// (several sheets in a cell, each is tried) and refines. A sample inside on the border of the grid lies on the cap: 0.
/// False if neither a cell around the sample nor the cap holds surface.
bool seedOffset(const LevelInterpolant& level, glm::ivec3 sample, glm::dvec3& offset);

}  // namespace isolume
