// The steps by which the band of surface_band.h grows. Every step ends with all its points in the field.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "sweep/near_sets.h"
#include "offset_field.h"
#include "point_kernels.h"

namespace isolume {

class BandSolver {
 public:
  /// `set`: the samples that have a point, none at first.
  BandSolver(GridView<const float> level, OffsetField& field, BitGrid& set);

  /// The samples with a crossed edge and the caps get their points; all others become unset.
  void seed(const BitGrid& inside);
  /// The samples that seeds share a cell with: all corners of cells that hold surface.
  void growToCorners(const BitGrid& inside);
  /// Corners that found another sheet than one of their neighbours did look at every cell around them.
  void reseedCorners(const BitGrid& inside);
  /// One layer: the 26 neighbours of the set, or the 6 across faces.
  void grow();
  void growAcrossFaces();
  /// Samples of the set take over neighbours' points that are nearer, and go on from there, until that changes nothing
  /// or `rounds` times.
  void relax(int rounds);

 private:
  struct NewPoint {
    glm::ivec2 at{0};
    glm::vec3 offset{0};
  };

  template <class RowOf>
  void growTo(const RowOf& rowOf);
  void start(int z, const std::vector<glm::ivec2>& samples, PointBatch& batch) const;
  void search(int z, bool isSeed, PointBatch& batch) const;
  void keep(std::size_t plane, const PointBatch& batch);
  void placeFound();
  std::size_t planeIndex(int z) const { return level_.index(0, 0, z); }

  GridView<const float> level_;
  LevelInterpolant interpolant_;
  PointFrame frame_;
  OffsetField& field_;
  BitGrid& set_;
  std::vector<std::vector<NewPoint>> found_;  // of each plane, not in the field yet
};

}  // namespace isolume
