// The steps by which the band of surface_band.h grows. Every step ends with all its points in the field.
//
// A step works on blocks of rows, few enough that the level and the points around one stay in the second-level cache.
// It reads points of the set alone and writes those of new samples where they belong; the set takes these over when
// all blocks are done. So no block sees what another one does.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "neighbour_points.h"
#include "offset_field.h"
#include "point_kernels.h"
#include "sweep/near_sets.h"

namespace isolume {

class BandSolver {
 public:
  /// `set`: the samples that have a point, none at first.
  BandSolver(GridView<const float> level, OffsetField& field, BitGrid& set);

  /// The samples with a crossed edge and the caps get their points.
  void seed(const BitGrid& inside);
  /// The samples that seeds share a cell with: all corners of cells that hold surface.
  void growToCorners(const BitGrid& inside);
  /// Corners that found another sheet than one of their neighbours did look at every cell around them.
  void reseedCorners(const BitGrid& inside);
  /// One layer: the neighbours of the set.
  void grow(Across across);
  /// Samples of the set take over neighbours' points that are nearer, and go on from there, until that changes nothing
  /// or `rounds` times.
  void relax(int rounds);

 private:
  // Rows of which one thread takes care at a time, and their number along y and z.
  struct Block {
    glm::ivec2 first{0}, end{0};  // y, z
  };
  struct NewPoint {
    glm::ivec3 at{0};
    glm::vec3 offset{0};
  };

  Block block(std::size_t index) const;
  std::vector<std::size_t> blocksNear(const std::vector<char>& marked) const;
  template <class OnRow>
  static void forRows(const Block& block, const OnRow& onRow);
  template <class RowOf>
  void growTo(const RowOf& rowOf);
  void search(bool isSeed, PointBatch& batch) const;
  void place(const PointBatch& batch);
  void placeFound();
  KnownPoints known() const { return {field_, set_, frame_.step}; }

  GridView<const float> level_;
  LevelInterpolant interpolant_;
  PointFrame frame_;
  OffsetField& field_;
  BitGrid& set_;
  BitGrid next_;  // the set after this step, or what relax() has changed
  glm::ivec2 blocks_{0};
  std::vector<char> hasPoints_;               // of each block
  std::vector<std::vector<NewPoint>> found_;  // of each block, better points that are not in the field yet
};

}  // namespace isolume
