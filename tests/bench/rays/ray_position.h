// What the counted tracers have in common: where a ray is, where it starts, and the surface in one cell. In double.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "sweep/grid.h"
#include "sweep/reference/grid_ray.h"
#include "sweep/reference/ray_walk.h"

namespace isolume::bench {

/// Cells low to high, both included.
struct CellBox {
  glm::ivec3 low{0}, high{0};
};

/// Where a ray is: never back in t, and in a cell that is known by integers once it went through a face, as the
/// shader's.
class RayPosition {
 public:
  /// Borrows the ray.
  RayPosition(const GridRay& ray, glm::ivec3 size, double t);

  double t() const { return t_; }
  glm::ivec3 cell() const { return cell_; }
  glm::dvec3 point() const { return at(t_); }
  glm::dvec3 at(double t) const;
  const GridRay& ray() const { return ray_; }

  /// To a parameter within the box of the grid.
  void goTo(double t);
  /// Parameter at which the ray leaves a box of cells around its own.
  double exit(const CellBox& box) const;
  double exit() const { return exit({cell_, cell_}); }
  /// Into the cell beyond; false if that is out of the grid.
  bool leave(const CellBox& box);

 private:
  struct Face {
    double t;
    int axis;
  };
  Face faceOf(const CellBox& box) const;
  void locate();

  const GridRay& ray_;
  glm::ivec3 lastCell_;
  glm::ivec3 cell_{0};
  double t_;
};

/// The part of a ray within the grid, and the side on which it starts.
struct RayStart {
  std::optional<RayClip> clip;
  bool inside = false;
  std::optional<glm::dvec3> cap;  ///< the ray enters the solid with the grid: it ends there
};
RayStart startOf(GridView<const float> level, const GridRay& ray);

/// What a ray shows that found no surface: from inside the cap, from behind; else nothing.
std::optional<glm::dvec3> foundAtEnd(const RayStart& start, const RayPosition& position);

bool isMixed(GridView<const float> level, glm::ivec3 cell);

/// Whether a cell that is not mixed lies on the other side than where the ray started: then the surface was on the face
/// before it. Where samples are exactly at the isovalue, the level of a mixed cell may come down to 0 there and no
/// lower.
bool isBeyondSurface(GridView<const float> level, glm::ivec3 cell, bool startsInside);

/// The surface in the cell of `position`, from there to parameter `end`; on the way out of the solid if `inside`.
std::optional<glm::dvec3> surfaceInCell(GridView<const float> level, const RayPosition& position, double end,
                                        bool inside);

/// Trilinear, at a point of a cell.
double interpolate(GridView<const float> field, glm::dvec3 position, glm::ivec3 cell);

}  // namespace isolume::bench
