#include "band_cells.h"

#include <algorithm>
#include <cmath>

#include "surface_start.h"

namespace isolume {
namespace {

// Gaps of fewer cells are swept with the runs on both sides: a run costs as many more steps as a vector has lanes.
constexpr int kSmallestGap = 2;

// Takes the maximum over `reach` elements on both sides, for `count` elements `stride` apart.
void growLine(std::uint8_t* line, int count, std::ptrdiff_t stride, int reach, std::vector<std::uint8_t>& copy) {
  copy.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) copy[static_cast<std::size_t>(i)] = line[i * stride];
  int until = -1;  // the last element that a set one before it reaches
  for (int i = 0; i < count + reach; ++i) {
    if (i < count && copy[static_cast<std::size_t>(i)] != 0) until = i + 2 * reach;
    const int at = i - reach;  // seen all that reach it
    if (at >= 0 && i <= until) line[at * stride] = 1;
  }
}

}  // namespace

BandCells::BandCells(glm::ivec3 size)
    : size_(size), count_((size + kCell - 1) / kCell), cells_(voxelCount(count_), std::uint8_t{0}) {}

void BandCells::markRow(int y, int z, const float* row) {
  std::uint8_t* cells = rowOf(y / kCell.y, z / kCell.z);
  for (int cell = 0; cell < count_.x; ++cell) {
    std::uint32_t bits = 0;
    for (int x = cell * kCell.x; x < std::min((cell + 1) * kCell.x, size_.x); ++x)
      bits |= std::bit_cast<std::uint32_t>(row[x]);
    if ((bits & kFixedBit) != 0) cells[cell] = 1;
  }
}

void BandCells::grow(glm::dvec3 spacing, float bound) {
  // The updates round: a chain is never longer by more than this.
  constexpr double kRounding = 1 + 1e-5;
  const glm::dvec3 inverse = 1.0 / spacing;
  const double length =
      bound * kRounding * std::sqrt(inverse.x * inverse.x + inverse.y * inverse.y + inverse.z * inverse.z);
  const int chain = static_cast<int>(std::min(length, 1.0 * std::max({size_.x, size_.y, size_.z})));
  const glm::ivec3 reach = (chain + kCell - 1) / kCell;
  const std::ptrdiff_t strideZ = static_cast<std::ptrdiff_t>(count_.x) * count_.y;
  std::vector<std::uint8_t> copy;
  for (int z = 0; z < count_.z; ++z)
    for (int y = 0; y < count_.y; ++y) growLine(rowOf(y, z), count_.x, 1, reach.x, copy);
  for (int z = 0; z < count_.z; ++z)
    for (int x = 0; x < count_.x; ++x) growLine(rowOf(0, z) + x, count_.y, count_.x, reach.y, copy);
  for (int y = 0; y < count_.y; ++y)
    for (int x = 0; x < count_.x; ++x) growLine(rowOf(y, 0) + x, count_.z, strideZ, reach.z, copy);
}

std::vector<TileSpan> BandCells::spans(const TileGrid& tiles, int block, int layer) const {
  const int firstY = block * tiles.lanes, lastY = std::min(firstY + tiles.lanes, size_.y) - 1;
  std::vector<std::uint8_t> any(static_cast<std::size_t>(count_.x), 0);
  for (int y = firstY / kCell.y; y <= lastY / kCell.y; ++y) {
    const std::uint8_t* row = rowOf(y, layer);
    for (int x = 0; x < count_.x; ++x) any[static_cast<std::size_t>(x)] |= row[x];
  }
  std::vector<TileSpan> spans;
  for (int x = 0; x < count_.x; ++x) {
    if (any[static_cast<std::size_t>(x)] == 0) continue;
    const int first = x * kCell.x, last = std::min(first + kCell.x, size_.x);
    if (!spans.empty() && first - (spans.back().first + spans.back().count) < kSmallestGap * kCell.x) {
      spans.back().count = last - spans.back().first;
    } else {
      spans.push_back({first, last - first});
    }
  }
  return spans;
}

}  // namespace isolume
