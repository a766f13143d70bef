// The points of a surface at which light is summed, and the lattice that its rays pass, made once for any number of
// sweeps over directions of any kind: the sky, a map, a disc.
//
// Memory: surface_feet.h and solid_lattice.h; per foot 84 bytes for the three orders of points (ray_points.h) where
// they are kept, 24 more while they are made; where they are remade 28 while a sweep runs, and 24 for as many feet as
// two bytes per voxel or 16 MiB hold beside all else; while a sweep runs 4 bytes per foot and channel, and 4 more for
// each thread at work. Sweeps are threaded, bitwise the same for any number of threads and any SIMD width.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "ray_points.h"
#include "sheared_rays.h"
#include "solid_lattice.h"
#include "surface_feet.h"
#include "sweep/large_array.h"

namespace isolume {

/// A direction towards the light, along the grid's axes, unit, and what is summed for it, by channel.
struct Ordinate {
  glm::dvec3 direction{0, 0, 1};
  std::array<float, kMostChannels> value{1};
};

/// What fixed-point sums may come to: far from the end of int32 even where every rounding of a group goes one way.
inline constexpr double kLargestSum = 1 << 30;

/// Directions of one axis and sense that are swept together.
struct RayGroup {
  int towards = 1;
  std::vector<RayDirection> directions;
};
/// Those whose rays cross most layers of `axis`, in groups of up to `most`.
std::vector<RayGroup> rayGroups(int axis, const std::vector<Ordinate>& ordinates, glm::dvec3 cell, int most);

class SurfaceRays {
 public:
  /// Whether the orders of points are kept for many sweeps, or each is made anew by each sweep: for a single one.
  enum class Orders { kept, remade };
  /// `level` as of makeLevel(), `distance` exact next to its surface; both are borrowed for good. std::length_error
  /// where a layer of the lattice has 2^24 points or more (2048^3 refined).
  SurfaceRays(GridView<const float> level, GridView<const float> distance, int refinement,
              Orders orders = Orders::kept);

  const SurfaceFeet& surface() const { return surface_; }
  /// The surface alone: all else is freed, and nothing can be swept any more.
  SurfaceFeet takeSurface() &&;
  const SolidLattice& lattice() const { return lattice_; }
  glm::dvec3 spacing() const { return spacing_; }
  glm::dvec3 cell() const { return spacing_ / static_cast<double>(lattice_.refinement); }
  std::size_t count() const { return surface_.count(); }

  enum class Count { blocked, visible };
  /// A sweep of one group along an axis, which adds to sums[c * stride + i] for point i and channel c.
  using GroupSweep = std::function<void(int axis, const LatticeLayers& lattice, const RayPoints& points,
                                        const RayGroup& group, std::ptrdiff_t stride, std::int32_t* sums)>;
  /// [c * count() + foot] = the sums of all groups of up to `most` ordinates. Threaded.
  std::vector<std::int32_t> sumGroups(const std::vector<Ordinate>& ordinates, int channels, int most,
                                      const GroupSweep& sweep) const;

  /// [c * count() + foot] = sum of value[c] max(N . w, 0) over the ordinates that are blocked or visible; with four
  /// channels without the cosine, over those that face the foot. To 2^-30 of the sum of all values.
  std::vector<float> sum(const std::vector<Ordinate>& ordinates, int channels, Count count) const;

 private:
  void keepFeet(std::size_t most);
  FootChunks chunks() const;
  const RayPoints& ordered(int axis, RayPoints& room) const;

  glm::dvec3 spacing_;
  SurfaceFeet surface_;
  SolidLattice lattice_;
  std::vector<RayPoints> kept_;   // by axis
  LargeArray<SurfaceFoot> feet_;  // of the first chunks
  std::size_t keptChunks_ = 0;
};

}  // namespace isolume
