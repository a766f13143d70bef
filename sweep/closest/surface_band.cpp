#include "surface_band.h"

#include <array>
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

// The signs in the 3 x 3 x 3 samples around a sample: one byte, bit 0 inside, bit 1 outside.
constexpr std::uint8_t kInsideBit = 1;
constexpr std::uint8_t kOutsideBit = 2;
constexpr std::uint8_t kBothBits = kInsideBit | kOutsideBit;

// The signs around every sample of one plane, row by row in rising y: each row of levels is read once per plane.
class SignRows {
 public:
  SignRows(GridView<const float> level, int z) : level_(level), z_(z) {
    for (Row& row : joined_) row.assign(voxelCount({level.size.x, 1, 1}), 0);
    around_ = joined_[0];
    padded_.assign(around_.size() + 2, 0);
    joinPlanes(0);
  }

  // To be called for y = 0, 1, 2, ... in turn.
  const std::uint8_t* next(int y) {
    joinPlanes(y + 1);
    const Row& a = joined_[0];
    const Row& b = joined_[1];
    const Row& c = joined_[2];
    std::uint8_t* middle = padded_.data() + 1;
    for (std::size_t x = 0; x < a.size(); ++x) middle[x] = static_cast<std::uint8_t>(a[x] | b[x] | c[x]);
    for (std::size_t x = 0; x < a.size(); ++x) {
      around_[x] = static_cast<std::uint8_t>(padded_[x] | padded_[x + 1] | padded_[x + 2]);
    }
    return around_.data();
  }

 private:
  using Row = std::vector<std::uint8_t>;

  // Joins row y of the planes z - 1, z, z + 1; a row beyond the grid has no signs.
  void joinPlanes(int y) {
    Row& row = joined_[static_cast<std::size_t>(y % 3)];
    std::fill(row.begin(), row.end(), std::uint8_t{0});
    if (y >= level_.size.y) return;
    for (int z = std::max(z_ - 1, 0); z <= std::min(z_ + 1, level_.size.z - 1); ++z) {
      const float* from = level_.data + z * level_.strideZ() + y * level_.strideY();
      for (std::size_t x = 0; x < row.size(); ++x) {
        row[x] = static_cast<std::uint8_t>(row[x] | (from[x] > 0 ? kInsideBit : kOutsideBit));
      }
    }
  }

  GridView<const float> level_;
  int z_;
  std::array<Row, 3> joined_;
  Row padded_, around_;
};

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
  SignRows rows(level.level, z);
  for (int y = 0; y < size.y; ++y) {
    const std::uint8_t* signs = rows.next(y);
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
