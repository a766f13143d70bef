#include "lower_bound.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr float kReachSquared = kBoundReach * kBoundReach;
// Squares, two sums, the root and this product: six roundings of 2^-24, of which the root halves the first five.
constexpr float kRoundedDown = 1 - 0x1p-21F;
// A search ends on its own for a block of neighbours that are about equally far.
constexpr int kBlock = 64;
// Looking whether it may end costs as much as eight steps of it, which are vectorised.
constexpr int kLookEvery = 8;

// Squares of the gap between boxes 0, 1, 2, ... cells apart, up to the first that is out of reach.
std::vector<float> squaredGaps(double spacing) {
  std::vector<float> gaps{0};
  while (gaps.back() < kReachSquared) {
    const double gap = spacing * static_cast<double>(gaps.size() - 1);
    gaps.push_back(static_cast<float>(gap * gap));
  }
  return gaps;
}

// A row of cells between four rows of samples: the squared gap to the nearest mixed cell of the row.
void rowOfCells(const float* const level[4], const std::vector<float>& gaps, int cells, float* out) {
  const auto farthest = static_cast<int>(gaps.size()) - 1;
  const auto spread = [&](int x, int& apart) {
    apart = out[x] == 0 ? 0 : std::min(apart + 1, farthest);
    return gaps[static_cast<std::size_t>(apart)];
  };
  for (int x = 0; x < cells; ++x) {
    int inside = 0;
    for (int row = 0; row < 4; ++row) inside += (level[row][x] > 0) + (level[row][x + 1] > 0);
    constexpr int kCorners = 8;
    out[x] = inside == 0 || inside == kCorners ? kReachSquared : 0;
  }
  // A cell next to a mixed one has the square 0 too, so what is marked is read before it is overwritten.
  std::vector<float> fromLeft(static_cast<std::size_t>(cells));
  int apart = farthest;
  for (int x = 0; x < cells; ++x) fromLeft[static_cast<std::size_t>(x)] = spread(x, apart);
  apart = farthest;
  for (int x = cells - 1; x >= 0; --x) {
    const float fromRight = spread(x, apart);
    out[x] = std::min({fromLeft[static_cast<std::size_t>(x)], fromRight, kReachSquared});
  }
}

// out[i][x] = min over k of lines[k][x] + gaps[|i - k|], for x in [0, width); line k starts at lines + k * stride.
void spreadAcross(const float* lines, std::size_t stride, int count, int width, const std::vector<float>& gaps, int i,
                  float* out) {
  for (int begin = 0; begin < width; begin += kBlock) {
    const int end = std::min(begin + kBlock, width);
    const auto take = [&](int line, float gap) {
      const float* from = lines + static_cast<std::size_t>(line) * stride;
      for (int x = begin; x < end; ++x) out[x] = std::min(out[x], from[x] + gap);
    };
    std::copy(lines + static_cast<std::size_t>(i) * stride + begin, lines + static_cast<std::size_t>(i) * stride + end,
              out + begin);
    for (int apart = 1; apart < count; ++apart) {
      const float gap = gaps[std::min(static_cast<std::size_t>(apart), gaps.size() - 1)];
      if (apart % kLookEvery == 1 && gap >= *std::max_element(out + begin, out + end)) break;
      if (i - apart >= 0) take(i - apart, gap);
      if (i + apart < count) take(i + apart, gap);
      if (i - apart < 0 && i + apart >= count) break;
    }
  }
}

}  // namespace

Grid<float> cellLowerBound(GridView<const float> level) {
  const glm::ivec3 cells = level.size - 1;
  const glm::dvec3 spacing = level.spacing / smallestSpacing(level.spacing);
  const std::vector<float> gapsX = squaredGaps(spacing.x), gapsY = squaredGaps(spacing.y),
                           gapsZ = squaredGaps(spacing.z);
  Grid<float> bound(cells, level.spacing, level.origin);
  const GridView<float> out = bound.view();
  const auto width = static_cast<std::size_t>(cells.x);
  const auto perPlane = static_cast<std::size_t>(out.strideZ());

  parallelFor(static_cast<std::size_t>(cells.z), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    std::vector<float> rows(perPlane);
    for (int y = 0; y < cells.y; ++y) {
      const float* samples[4];
      for (int row = 0; row < 4; ++row) samples[row] = level.data + level.index(0, y + (row & 1), z + row / 2);
      rowOfCells(samples, gapsX, cells.x, rows.data() + static_cast<std::size_t>(y) * width);
    }
    for (int y = 0; y < cells.y; ++y)
      spreadAcross(rows.data(), width, cells.y, cells.x, gapsY, y, out.data + out.index(0, y, z));
  });

  parallelFor(static_cast<std::size_t>(cells.y), [&](std::size_t slab) {
    const int y = static_cast<int>(slab);
    std::vector<float> rows(width * static_cast<std::size_t>(cells.z));
    for (int z = 0; z < cells.z; ++z)
      std::copy_n(out.data + out.index(0, y, z), width, rows.data() + static_cast<std::size_t>(z) * width);
    for (int z = 0; z < cells.z; ++z) {
      float* row = out.data + out.index(0, y, z);
      spreadAcross(rows.data(), width, cells.z, cells.x, gapsZ, z, row);
      for (int x = 0; x < cells.x; ++x) row[x] = std::sqrt(row[x]) * kRoundedDown;
    }
  });
  return bound;
}

}  // namespace isolume
