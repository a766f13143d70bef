// Light through a translucent solid, after [Singh10] Sec. 4.2, by ordinates.
//
//   E / pi = sum of value |N . w| T(w),  T(w) = exp(-L(w) / meanFreePath),
// with L the length of the solid that a ray passes on its way out. Eq. 8 lets a voxel of solid pass 1 - alpha:
// meanFreePath = -h / ln(1 - alpha). So light comes from behind too, and a point that sees the sky on both sides has 2.
// The error is that of L: a lattice of the samples, with the solid share of those next to the surface. The thickness of
// a ball is too small by a quarter of a voxel (measured).
#pragma once

#include <cstdint>
#include <vector>

#include "light_sweeps.h"
#include "surface_rays.h"

namespace isolume {

/// World units, for an opacity in (0, 1) and the smallest spacing.
double meanFreePath(double opacity, double smallestSpacing);

struct Translucency {
  SweptLight light;      ///< E / pi of channel 0 of the sky
  SweptLight thickness;  ///< mean of L over the directions into the solid, weighed by |N . w|; world units
};

/// The thickness alone.
SweptLight sweepThickness(const SurfaceRays& rays, GridView<const float> distance, int ordinates);

/// `rays` of refinement 1 over `distance`. The thickness is right only if the sky's values are equal.
Translucency sweepTranslucency(const SurfaceRays& rays, GridView<const float> distance,
                               const std::vector<Ordinate>& sky, double meanFreePath);

}  // namespace isolume
