// Rays against the exact isosurface, in double: the ground truth that everything else is measured with.
//
// The solid is { level > 0 } of the trilinear interpolant within the box of the samples [0, size - 1] (index space);
// nothing lies outside the box, so a solid that the border cuts has a flat cap. Shares nothing with the sweeps and the
// shaders: no distance, no clearance, no float arithmetic. Bricks without a sign change are skipped; in every other
// cell that a ray passes, its level is a cubic polynomial of the ray parameter, whose first root is isolated by its
// extrema. Double roots (a ray that touches the surface) count as a hit only if the level gets above 0. No tolerance to
// tune.
//
// Thread-safe once built. [Amanatides87] for the walk, [Parker98] for the cubic.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "sweep/grid.h"
#include "sweep/reference/grid_ray.h"
#include "sweep/reference/solid_cells.h"

namespace isolume {

class SurfaceTracer {
 public:
  /// Borrows the level (sweep/level.h: finite). At least two samples along each axis. Memory: solid_cells.h.
  explicit SurfaceTracer(GridView<const float> level);

  /// Where the ray first passes from outside into the solid. A ray that starts inside finds where it leaves (the
  /// surface, or the cap, from behind), as the renderer shows it.
  std::optional<SurfacePoint> firstHit(const GridRay& ray) const;

  /// Where a ray that starts at a point of the surface (an earlier hit: the ray's point at ray.start is from.position)
  /// meets the solid again, or at once if it points into the solid. The ray is taken to start just outside, by no more
  /// than the rounding of the point, so that it never meets the spot that it leaves.
  std::optional<SurfacePoint> nextHit(const GridRay& ray, const SurfacePoint& from) const;
  /// The same question without where: stops at the first crossing found.
  bool isBlocked(const GridRay& ray, const SurfacePoint& from) const;
  /// How much of a ray that starts within the box, at ray.start, lies in the solid, in units of its parameter. Cell by
  /// cell what the cubic has above 0: nothing counts crossings, so that a touch adds no more than it is long. Visits
  /// every cell of the solid on its way.
  double lengthInside(const GridRay& ray) const;

  /// The interpolant, and its exact gradient in the cell (index space), at a point within the box; at the face between
  /// two cells, of the upper one.
  double levelAt(glm::dvec3 position) const;
  glm::dvec3 cellGradient(glm::dvec3 position) const;
  /// Difference quotient of the interpolant one sample to each side (one-sided at the border), per index unit: what the
  /// renderer's `--normals data` shows; continuous from cell to cell.
  glm::dvec3 smoothGradient(glm::dvec3 position) const;

  GridView<const float> level() const { return level_; }

 private:
  GridView<const float> level_;
  SolidCells solid_;
};

}  // namespace isolume
