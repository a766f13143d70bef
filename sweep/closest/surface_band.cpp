#include "surface_band.h"

#include <cstdint>
#include <vector>

#include "closest_point.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// Samples of one z plane, by their index y * nx + x in it.
using PlaneList = std::vector<std::uint32_t>;

struct NewSample {
  std::uint32_t index = 0;
  glm::vec3 offset{0};
};

// Where the signs of a plane lie: one byte per sample, bit 0 inside, bit 1 outside, joined over x - 1, x, x + 1 and
// y - 1, y, y + 1.
constexpr std::uint8_t kInsideBit = 1;
constexpr std::uint8_t kOutsideBit = 2;
constexpr std::uint8_t kBothBits = kInsideBit | kOutsideBit;

// Joins the signs of the nine rows around row (y, z) into `signs`, then those of x - 1 and x + 1.
void joinSigns(GridView<const float> level, int y, int z, std::vector<std::uint8_t>& column,
               std::vector<std::uint8_t>& signs) {
  const int nx = level.size.x;
  std::fill(column.begin(), column.end(), std::uint8_t{0});
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy) {
      if (y + dy < 0 || y + dy >= level.size.y || z + dz < 0 || z + dz >= level.size.z) continue;
      const float* row = level.data + (z + dz) * level.strideZ() + (y + dy) * level.strideY();
      std::uint8_t* to = column.data() + 1;
      for (int x = 0; x < nx; ++x) to[x] = static_cast<std::uint8_t>(to[x] | (row[x] > 0 ? kInsideBit : kOutsideBit));
    }
  for (int x = 0; x < nx; ++x) signs[x] = static_cast<std::uint8_t>(column[x] | column[x + 1] | column[x + 2]);
}

void clearPlane(OffsetField& field, std::size_t first, std::size_t count) {
  std::fill_n(field.component[0].data() + first, count, kUnsetOffset);
  std::fill_n(field.component[1].data() + first, count, 0.0F);
  std::fill_n(field.component[2].data() + first, count, 0.0F);
}

PlaneList seedPlane(const LevelInterpolant& level, int z, OffsetField& field) {
  const glm::ivec3 size = level.level.size;
  const std::size_t first = level.level.index(0, 0, z);
  clearPlane(field, first, voxelCount({size.x, size.y, 1}));
  PlaneList list;
  std::vector<std::uint8_t> column(static_cast<std::size_t>(std::max(size.x, 1)) + 2);
  std::vector<std::uint8_t> signs(static_cast<std::size_t>(size.x));
  for (int y = 0; y < size.y; ++y) {
    joinSigns(level.level, y, z, column, signs);
    const bool borderRow = y == 0 || z == 0 || y == size.y - 1 || z == size.z - 1;
    for (int x = 0; x < size.x; ++x) {
      const bool border = borderRow || x == 0 || x == size.x - 1;
      if (signs[x] != kBothBits && !(border && signs[x] == kInsideBit)) continue;
      glm::dvec3 offset(0);
      if (!seedOffset(level, {x, y, z}, offset)) continue;
      const auto index = static_cast<std::uint32_t>(y * level.level.strideY() + x);
      field.set(first + index, glm::vec3(offset));
      list.push_back(index);
    }
  }
  return list;
}

// Best point of the 26 neighbours of an unset sample, refined.
glm::vec3 layerOffset(const LevelInterpolant& level, const OffsetField& field, glm::ivec3 p) {
  const glm::ivec3 low = glm::max(p - 1, glm::ivec3(0));
  const glm::ivec3 high = glm::min(p + 1, level.level.size - 1);
  glm::vec3 best(kUnsetOffset, 0, 0);
  float nearest = squaredLength(best);
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const glm::vec3 from = field.at(level.level.index(x, y, z));
        if (from.x == kUnsetOffset) continue;
        const glm::vec3 candidate = from + glm::vec3(glm::dvec3(glm::ivec3(x, y, z) - p) * level.step);
        const float length = squaredLength(candidate);
        if (length < nearest) {
          nearest = length;
          best = candidate;
        }
      }
  glm::dvec3 refined(best);
  return refineOffset(level, p, refined) ? glm::vec3(refined) : best;
}

// The samples of plane z that are unset and have a neighbour in the newest layer, with their points.
std::vector<NewSample> growPlane(const LevelInterpolant& level, const OffsetField& field,
                                 const std::vector<PlaneList>& newest, int z) {
  const glm::ivec3 size = level.level.size;
  const std::size_t first = level.level.index(0, 0, z);
  std::vector<NewSample> found;
  std::vector<std::uint8_t> marked;
  for (int from = std::max(z - 1, 0); from <= std::min(z + 1, size.z - 1); ++from)
    for (const std::uint32_t index : newest[static_cast<std::size_t>(from)]) {
      if (marked.empty()) marked.resize(voxelCount({size.x, size.y, 1}));
      const int fromX = static_cast<int>(index % static_cast<std::uint32_t>(size.x));
      const int fromY = static_cast<int>(index / static_cast<std::uint32_t>(size.x));
      for (int y = std::max(fromY - 1, 0); y <= std::min(fromY + 1, size.y - 1); ++y)
        for (int x = std::max(fromX - 1, 0); x <= std::min(fromX + 1, size.x - 1); ++x) {
          const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + x;
          if (marked[at] != 0 || field.isSet(first + at)) continue;
          marked[at] = 1;
          found.push_back({static_cast<std::uint32_t>(at), {}});
        }
    }
  for (NewSample& sample : found) {
    const auto [y, x] = std::div(static_cast<std::int64_t>(sample.index), static_cast<std::int64_t>(size.x));
    sample.offset = layerOffset(level, field, {static_cast<int>(x), static_cast<int>(y), z});
  }
  return found;
}

}  // namespace

std::size_t startOffsets(GridView<const float> level, int layers, OffsetField& field) {
  const LevelInterpolant interpolant(level, smallestSpacing(level.spacing));
  const auto planeCount = static_cast<std::size_t>(level.size.z);
  std::vector<PlaneList> newest(planeCount);
  parallelFor(planeCount, [&](std::size_t z) { newest[z] = seedPlane(interpolant, static_cast<int>(z), field); });
  std::size_t count = 0;
  for (const PlaneList& list : newest) count += list.size();

  for (int layer = 0; layer < layers; ++layer) {
    std::vector<std::vector<NewSample>> found(planeCount);
    parallelFor(planeCount,
                [&](std::size_t z) { found[z] = growPlane(interpolant, field, newest, static_cast<int>(z)); });
    parallelFor(planeCount, [&](std::size_t z) {
      const std::size_t first = level.index(0, 0, static_cast<int>(z));
      newest[z].clear();
      for (const NewSample& sample : found[z]) {
        field.set(first + sample.index, sample.offset);
        newest[z].push_back(sample.index);
      }
    });
    for (const PlaneList& list : newest) count += list.size();
  }
  return count;
}

}  // namespace isolume
