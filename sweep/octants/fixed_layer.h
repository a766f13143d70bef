// A layer of the walks of fixed_light_sweeper.h, kFixedPlanes planes: from distances to diagonals of transmittances,
// and from diagonals of what light leaves back to rows.
//
// A block is a column of a layer in kSegment rows. Blocks of one transmittance are not laid in diagonals, and where
// both octants of a diagonal leave one value, nothing is laid back.
//
// Memory: 16-bit values, of each voxel of the layer one transmittance, and in diagonals, both ways, a transmittance and
// a part of the result; in diagonals and rows of one plane two parts.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "column_shear.h"
#include "fixed_light.h"
#include "sweep/grid.h"
#include "sweep/large_array.h"
#include "sweep/octants.h"

namespace isolume {

/// Octants of a walk: 0 and 3 share the rising diagonals, 1 and 2 the falling ones; 0 and 2 run up in x, 0 and 1 in y.
inline constexpr int kOctantsOfWalk = kOctantCount / 2;
inline constexpr int kDiagonals = 2;
inline constexpr std::size_t kRising = 0, kFalling = 1;

/// N (fixed_light.h) of what lies outside the grid: all light.
inline constexpr std::int16_t kOutside = -kFullLight;

using FixedValues = LargeArray<std::int16_t>;
FixedValues makeFixedValues(std::size_t count, std::int16_t value);

/// Values, and what each segment of them holds.
struct MarkedValues {
  FixedValues values;
  std::vector<Content> held;
};
/// A column's merged parts: of even segments `held` is what the buffer holds, not what is meant.
struct MergedValues : MarkedValues {
  std::vector<Content> meant;
};

/// How a grid's layers are cut in columns.
struct LayerShape {
  explicit LayerShape(glm::ivec3 gridSize);

  int layers() const { return (size.z + kFixedPlanes - 1) / kFixedPlanes; }
  /// Blocks of a layer, by [column][segment of rows].
  std::size_t blocks() const { return block(columns, 0); }
  std::size_t block(int c, int segment) const { return static_cast<std::size_t>(c * column.rowSegments() + segment); }
  Stretch rows(int segment) const { return {segment * kSegment, std::min((segment + 1) * kSegment, size.y)}; }
  Stretch steps(int segment) const { return {segment * kSegment, std::min((segment + 1) * kSegment, column.steps())}; }
  std::vector<Content> segments(Content content) const {
    return std::vector<Content>(static_cast<std::size_t>(column.segments()), content);
  }

  glm::ivec3 size;
  ColumnShape column;
  int columns = 0;
  std::ptrdiff_t stride = 0;  ///< of rows, values
};

/// z of a layer's planes in the order of the walk; size.z and more: beyond the grid, clear, the last on the way up and
/// the first on the way down.
using LayerPlanes = std::array<int, kFixedPlanes>;

class FixedLayer {
 public:
  explicit FixedLayer(const LayerShape& shape);

  /// Lays out the transmittances of `distance` ([Singh10] Eq. 7, Eq. 8 with opacity), and edges that let all light in.
  /// `blocks`: -tau of the layer's blocks, found here unless `known`; then even blocks' distances are not read.
  void prepare(GridView<const float> distance, float opacity, const LayerPlanes& planes, bool known, Content* blocks);

  /// Calls store(z, rows) for each plane of the grid, with what was merged.
  void finish(const LayerPlanes& planes, const std::function<void(int z, const MergedRows& rows)>& store);

  const MarkedValues& transmitting(std::size_t diagonal, std::size_t c) const { return transmitting_[diagonal][c]; }
  MergedValues& merged(std::size_t diagonal, std::size_t c) { return merged_[diagonal][c]; }
  FixedValues& edge(std::size_t octantOfWalk) { return edge_[octantOfWalk]; }

 private:
  std::size_t planeRows() const;
  std::int16_t* transmittanceRows(int p) const;
  std::int16_t* inColumn(MarkedValues& column, int p) const;
  void fill(MarkedValues& column, int segment, Content content) const;
  void fillRows(std::int16_t* rows, int c, int segment, Content content) const;
  Content findContent(const LayerPlanes& planes, int c, int segment) const;
  void shearColumn(int c, const Content* blocks);
  std::vector<Content> settle(MergedValues& merged) const;
  void layInRows(std::size_t diagonal, int c, int p, const std::vector<Content>& contents);

  const LayerShape& shape_;
  MarkedValues transmittance_;  // rows of the planes, `lanes` clear rows around each; held: by block
  std::array<std::vector<MarkedValues>, kDiagonals> transmitting_;  // of each column
  std::array<std::vector<MergedValues>, kDiagonals> merged_;
  std::array<FixedValues, kOctantsOfWalk> edge_;
  FixedValues scratch_;
  std::array<MarkedValues, kDiagonals> rows_;  // of one plane; held: by block
};

}  // namespace isolume
