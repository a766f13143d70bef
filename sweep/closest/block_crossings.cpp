#include "block_crossings.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace isolume {
namespace {

// The 3 x 3 x 3 samples around one sample, and the eight cells among them: cell c lies at x + (c & 1) - 1 and so on.
struct Edge {
  int from = 0, to = 0, axis = 0;
  unsigned cells = 0;  // one bit for each cell that it bounds
};

constexpr int kBlockStride[3] = {1, 3, 9};

constexpr std::array<Edge, kBlockEdges> makeEdges() {
  std::array<Edge, kBlockEdges> edges;
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 27; ++i) {
      const int at[3] = {i % 3, i / 3 % 3, i / 9};
      if (at[axis] == 2) continue;
      Edge edge{i, i + kBlockStride[axis], axis, 0};
      for (int cell = 0; cell < 8; ++cell) {
        bool bounds = (cell >> axis & 1) == at[axis];
        for (int other = 0; other < 3; ++other) {
          const int low = cell >> other & 1;
          bounds = bounds && (other == axis || at[other] == low || at[other] == low + 1);
        }
        if (bounds) edge.cells |= 1U << cell;
      }
      edges[count++] = edge;
    }
  return edges;
}
constexpr std::array<Edge, kBlockEdges> kEdges = makeEdges();

struct Block {
  float level[27];
  unsigned cells = 0;  // one bit for each cell within the grid; an axis of one sample has one layer of flat cells
};

Block loadBlock(GridView<const float> level, glm::ivec3 sample) {
  Block block;
  int i = 0;
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy) {
      const int y = std::clamp(sample.y + dy, 0, level.size.y - 1);
      const int z = std::clamp(sample.z + dz, 0, level.size.z - 1);
      const float* row = level.data + (z * level.strideZ() + y * level.strideY());
      block.level[i++] = row[std::max(sample.x - 1, 0)];
      block.level[i++] = row[sample.x];
      block.level[i++] = row[std::min(sample.x + 1, level.size.x - 1)];
    }
  unsigned outside = 0;
  constexpr unsigned kLowCells[3] = {0x55, 0x33, 0x0F};  // bits of the cells on the low side of an axis
  for (int axis = 0; axis < 3; ++axis) {
    if (sample[axis] == 0) outside |= kLowCells[axis];
    if (sample[axis] == level.size[axis] - 1 && level.size[axis] > 1) outside |= ~kLowCells[axis];
  }
  block.cells = ~outside & 0xFF;  // all eight
  return block;
}

}  // namespace

void findCrossings(const LevelInterpolant& level, glm::ivec3 sample, BlockCrossings& crossings) {
  const Block block = loadBlock(level.level, sample);
  crossings.nearest.fill(kNoCrossing);
  crossings.squared.fill(std::numeric_limits<double>::max());
  int count = 0;
  for (const Edge& edge : kEdges) {
    const float from = block.level[edge.from], to = block.level[edge.to];
    unsigned cells = edge.cells & block.cells;
    if ((from > 0) == (to > 0) || cells == 0) continue;
    glm::dvec3& crossing = crossings.offset[static_cast<std::size_t>(count)];
    crossing = glm::dvec3(edge.from % 3 - 1, edge.from / 3 % 3 - 1, edge.from / 9 - 1);
    crossing[edge.axis] += from / (static_cast<double>(from) - to);
    crossing *= level.step;
    const double length = glm::dot(crossing, crossing);
    for (; cells != 0; cells &= cells - 1) {
      const auto cell = static_cast<std::size_t>(std::countr_zero(cells));
      if (!(length < crossings.squared[cell])) continue;
      crossings.squared[cell] = length;
      crossings.nearest[cell] = count;
    }
    ++count;
  }
}

}  // namespace isolume
