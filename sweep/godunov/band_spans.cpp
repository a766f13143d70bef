#include "band_spans.h"

#include <algorithm>
#include <cmath>

namespace isolume {

int longestChain(glm::ivec3 size, glm::dvec3 spacing, float bound) {
  // The updates round: a chain is never longer by more than this.
  constexpr double kRounding = 1 + 1e-5;
  const glm::dvec3 inverse = 1.0 / spacing;
  const double length =
      bound * kRounding * std::sqrt(inverse.x * inverse.x + inverse.y * inverse.y + inverse.z * inverse.z);
  return static_cast<int>(std::min(length, 1.0 * std::max({size.x, size.y, size.z})));
}

std::vector<TileSpan> bandSpans(const BitGrid& fixed, int chain, const TileGrid& tiles, int block, int layer) {
  const glm::ivec3 size = tiles.size;
  const int firstY = std::max(block * tiles.lanes - chain, 0), firstZ = std::max(layer * kTilePlanes - chain, 0);
  const int endY = std::min((block + 1) * tiles.lanes + chain, size.y);
  const int endZ = std::min((layer + 1) * kTilePlanes + chain, size.z);
  BitRow any(static_cast<std::size_t>(fixed.words()), 0);
  for (int z = firstZ; z < endZ; ++z)
    for (int y = firstY; y < endY; ++y) {
      const std::uint64_t* row = fixed.row(y, z);
      for (std::size_t w = 0; w < any.size(); ++w) any[w] |= row[w];
    }
  std::vector<TileSpan> spans;
  forEachRun(any.data(), fixed.words(), [&](int begin, int end) {
    const int first = std::max(begin - chain, 0), last = std::min(end + chain, size.x);
    if (!spans.empty() && first - (spans.back().first + spans.back().count) < tiles.lanes) {
      spans.back().count = last - spans.back().first;
    } else {
      spans.push_back({first, last - first});
    }
  });
  return spans;
}

}  // namespace isolume
