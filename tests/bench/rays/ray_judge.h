// Judges what a renderer found along one ray against the exact tracer of the same isosurface (surface_tracer.h).
//
// A renderer in float cannot know its rays better than to some roundings of their coordinates, and the reference's ray
// is exact. Where the surface is met at an angle the two differ by that little; where a ray grazes the surface, or runs
// within a plateau at the isovalue, so little decides what is hit. So a ray has one of these verdicts:
//
//   agrees   both miss, or both hit within kSamePlace of each other along the ray;
//   tie      they differ, but by mere rounding of the level (kLevelRounding of the largest corner of the cell): by that
//            it is above 0 between the surface that was passed and the point found, or from 0 where one was found;
//   grazing  they differ, but what was found is right for a ray that is displaced sideways by no more than float does
//            (kSidewaysRounding): such a ray misses too; or the point found lies on the surface (kOnSurface) and
//            nothing hides it from such a ray;
//   missed   a surface was passed through;
//   falseHit there is no surface at the point found.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "sweep/reference/surface_tracer.h"

namespace isolume::bench {

inline constexpr double kSamePlace = 1e-3;  ///< voxels: what the renderer promises
inline constexpr double kOnSurface = 1e-3;  ///< voxels
/// Four units in the last place of float, as a share of the longest side of the grid: a ray's origin is the sum of
/// three products, its direction a difference over a length, and both act across the grid.
inline constexpr double kSidewaysRounding = 0x1p-21;
/// Eight roundings of float: the corners' means along three axes, the cubic and its value.
inline constexpr double kLevelRounding = 0x1p-21;

enum class Verdict { agrees, tie, grazing, missed, falseHit };

/// What a hit is worth on its own, wherever the ray was meant to be.
struct HitQuality {
  /// Voxels from the hit to the trilinear isosurface on the line through the hit along the ray. Where that line has
  /// none near by (it grazes the surface): to the surface at right angles, by |level| / |gradient|, and `tangent`.
  double distance = 0;
  bool tangent = false;
  /// Voxels to the surface at right angles, |level| / |gradient| (first order); 0 where both are.
  double across = 0;
  bool cap = false;  ///< on the border of the grid: flat and exact, the rest is 0
};

class RayJudge {
 public:
  /// Borrows the level; its spacing tells the voxel's shape. At least two samples along each axis.
  explicit RayJudge(GridView<const float> level);

  /// The direction of `ray` has unit length in voxels, `found` is in index space.
  Verdict judge(const GridRay& ray, const std::optional<glm::dvec3>& found) const;
  HitQuality quality(const GridRay& ray, glm::dvec3 found) const;

  /// Spacing in voxels (smallest = 1).
  glm::dvec3 scale() const { return scale_; }
  const SurfaceTracer& tracer() const { return tracer_; }
  /// Gradients per voxel: the difference quotient that the renderer shows, and the interpolant's own within the cell.
  glm::dvec3 smoothGradient(glm::dvec3 position) const { return tracer_.smoothGradient(position) / scale_; }
  glm::dvec3 cellGradient(glm::dvec3 position) const { return tracer_.cellGradient(position) / scale_; }
  /// Largest |level| of the corners of the cell.
  double largestCorner(glm::dvec3 position) const;

 private:
  bool isCap(glm::dvec3 position) const;
  bool isOnSurface(const GridRay& ray, glm::dvec3 found) const;
  /// Where some ray displaced by rounding hits last; +inf if one misses.
  double farthestHit(const GridRay& ray) const;

  /// Whether between two parameters the level gets above 0 by no more than rounding.
  bool passesByRounding(const GridRay& ray, double from, double to) const;

  SurfaceTracer tracer_;
  glm::dvec3 scale_{1};
  glm::dvec3 high_{0};
  double sideways_ = 0;  ///< voxels
};

}  // namespace isolume::bench
