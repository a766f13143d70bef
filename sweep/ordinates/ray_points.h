// Feet of the surface in the order in which rays along one axis meet them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "solid_lattice.h"
#include "surface_feet.h"

namespace isolume {

/// Which axes of the lattice are bits, rows and layers. Values 0, 1, 2.
struct RayAxes {
  int bit = 0, row = 1, layer = 2;
};
/// For rays along each axis: by layers of x, y, z.
inline constexpr std::array<RayAxes, 3> kRayAxes{{{1, 2, 0}, {0, 2, 1}, {0, 1, 2}}};

/// In steps of a layer's lattice points along a point's normal, |N_b| c_b + |N_r| c_r with the cell c: how high over
/// the surface's plane a ray must be before what it meets counts (sheared_rays.h). One step, and more than rounding.
inline constexpr float kClearance = 1.001F;

/// Rows [begin, end) of a layer.
struct RowRange {
  int begin = 0, end = 0;
  bool empty() const { return begin >= end; }
};
inline RowRange unionOf(RowRange a, RowRange b) {
  if (a.empty()) return b;
  return b.empty() ? a : RowRange{std::min(a.begin, b.begin), std::max(a.end, b.end)};
}
inline RowRange sharedBy(RowRange a, RowRange b) { return {std::max(a.begin, b.begin), std::min(a.end, b.end)}; }

/// How far from a point's row the ray may be that it reads: three layers on (sheared_rays.h), of which each is a row
/// further at most, as is the first; one by rounding and by the ray's choice; a lift of 1.5 at most; and some more.
inline constexpr int kMostRowsOff = 8;

/// Lanes of the widest vector: what lies that far beyond the last point is read, and never counts.
inline constexpr std::size_t kRayPadding = 64;

/// 28 bytes per point. The six arrays of numbers are longer than `count` by kRayPadding.
class RayPoints {
 public:
  /// For up to `count` points.
  explicit RayPoints(std::size_t count);

  /// Points in groups of a layer (that at or below them), and within a layer those that face every ray along the axis
  /// in one sense, or none, and the others by how their normals tilt and turn: so those that face away from a
  /// direction stand together. A counting sort in fixed chunks: the order does not depend on the number of threads.
  /// Threaded. Takes 4 bytes per point, and 200 per layer and chunk, while it runs.
  void sort(const FootChunks& feet, const SolidLattice& lattice, glm::dvec3 spacing, int axis);

  std::size_t count() const { return count_; }
  const float* bit() const { return values(0); }  ///< position, lattice points
  const float* row() const { return values(1); }
  const float* layer() const { return values(2); }
  const float* normalBit() const { return values(3); }  ///< unit, world units
  const float* normalRow() const { return values(4); }
  const float* normalLayer() const { return values(5); }
  const std::uint32_t* foot() const { return feet_.get(); }  ///< number of each point's foot
  /// The points of a layer are [begin(layer), begin(layer + 1)); layer -1 has none.
  std::size_t begin(int layer) const { return layer < 0 ? 0 : layerBegin_[static_cast<std::size_t>(layer)]; }
  /// Rows of the lattice outside which nothing is solid and nothing is read: a ray has met nothing before it enters
  /// them, and does not count once it has left.
  RowRange rowsRead() const { return rowsRead_; }
  /// Whether a point stands at or before `layer`, seen along rays that come from the last layer (towards = 1) or the
  /// first (-1), so that the layers up to it are read.
  bool anyFrom(int layer, int towards) const { return towards > 0 ? begin(layer) > 0 : begin(layer) < count_; }

 private:
  float* values(int i) const { return values_.get() + static_cast<std::size_t>(i) * stride_; }

  std::size_t count_, stride_;
  RowRange rowsRead_;
  LargeArray<float> values_;
  LargeArray<std::uint32_t> feet_;
  std::vector<std::size_t> layerBegin_;
};

}  // namespace isolume
