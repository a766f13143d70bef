// Sphere tracing ([Hart96]) through different fields, to count its steps and its wrong rays: on the CPU, in double.
//
// All of them know the box of the grid and start where the ray enters it. A ray that starts inside the solid looks for
// the way out. Three ways to step:
//
//   raw    t += |D(x)|, D a solver's distance, trilinear; a hit where |D| is below kRawHit. No certificate.
//   field  t += the certified bound of such a field (FieldBound); where it leaves less than the rest of the cell, the
//          ray goes through that cell: a mixed one is solved, any other is free.
//   cells  t += the cell bound (cellLowerBound()), the same otherwise.
//
// The last two certify a ball around x, so over-relaxation holds ([Keinert14] Sec. 3.1): step omega times the bound,
// and if the balls before and after do not overlap, go back to the end of the first and on with omega = 1.
#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "sweep/bounds/lower_bound.h"
#include "sweep/reference/grid_ray.h"
#include "tests/bench/rays/traced_ray.h"

namespace isolume::bench {

/// Voxels; below it plain sphere tracing says hit.
inline constexpr double kRawHit = 1e-3;
/// Steps after which it gives up: along a surface it creeps.
inline constexpr int kRawSteps = 10'000;

/// `distance` in voxels, < 0 inside; same size and spacing as `level`. The ray's direction has unit length in voxels.
TracedRay traceRaw(GridView<const float> level, GridView<const float> distance, const GridRay& ray);

/// Voxels around a point of index space, in that cell, that are free of surface.
using PointBound = std::function<double(glm::dvec3 position, glm::ivec3 cell)>;

PointBound fieldPointBound(GridView<const float> distance, FieldBound bound);
PointBound cellPointBound(GridView<const float> cells);

TracedRay traceCertified(GridView<const float> level, const PointBound& bound, const GridRay& ray, double omega);

}  // namespace isolume::bench
