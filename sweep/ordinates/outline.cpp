#include "outline.h"

#include <algorithm>
#include <functional>
#include <glm/common.hpp>

#include "sweep/distance_extent.h"
#include "sweep/near_sets.h"

namespace isolume {
namespace {

// By how much outlines are narrowed at most, cells, and the least thickness behind, voxels; both by experiment.
constexpr float kMostNarrowed = 0.1F, kThickness = 0.9F;
// What the narrowest band holds (distance_extent.h); samples next to each other are not further apart where voxels are
// cubes. So a band gives the same as the whole domain.
constexpr float kKnown = kSurfaceBandVoxels + 1;

// The samples around a point of the lattice: itself, or the ends of the edge, the corners of the face or of the cell
// in whose middle it lies.
template <class Visit>
void forEachCorner(glm::ivec3 point, int refinement, const Visit& visit) {
  const glm::ivec3 low = point / refinement, parts = point % refinement;
  for (int z = low.z; z <= low.z + parts.z; ++z)
    for (int y = low.y; y <= low.y + parts.y; ++y)
      for (int x = low.x; x <= low.x + parts.x; ++x) visit(glm::ivec3(x, y, z));
}

// Depth and curvature of a point, in the smallest width of a voxel.
class Outline {
 public:
  Outline(GridView<const float> distance, int refinement)
      : distance_(distance),
        refinement_(refinement),
        voxel_(static_cast<float>(std::min({distance.spacing.x, distance.spacing.y, distance.spacing.z}))) {
    for (int axis = 0; axis < 3; ++axis) {
      const float ratio = voxel_ / static_cast<float>(distance.spacing[axis]);
      perStep_[axis] = ratio * ratio;
    }
  }

  bool isWidened(glm::ivec3 point) const {
    const float cell = 1 / static_cast<float>(refinement_), most = kMostNarrowed * cell;
    const float depth = mean(point, [&](glm::ivec3 at) { return depthOf(at); });
    if (depth >= most) return false;
    const float curvature = mean(point, [&](glm::ivec3 at) { return curvatureOf(at); });
    return depth < std::min(most, curvature * cell * cell) && deepestAround(point) > depth + kThickness;
  }

 private:
  float depthOf(glm::ivec3 at) const { return std::clamp(-distance_(at.x, at.y, at.z) / voxel_, -kKnown, kKnown); }
  // k_1 + k_2; on the border of the grid, where the solid is cut, none.
  float curvatureOf(glm::ivec3 at) const {
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (at[axis] == 0 || at[axis] == distance_.size[axis] - 1) return 0;
      glm::ivec3 before = at, after = at;
      --before[axis];
      ++after[axis];
      sum += ((depthOf(at) - depthOf(before)) + (depthOf(at) - depthOf(after))) * perStep_[axis];
    }
    return sum;
  }
  float deepestAround(glm::ivec3 point) const {
    float deepest = 0;
    forEachCorner(point, refinement_, [&](glm::ivec3 corner) {
      const glm::ivec3 low = glm::max(corner - 1, glm::ivec3(0)), high = glm::min(corner + 1, distance_.size - 1);
      for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
          for (int x = low.x; x <= high.x; ++x) deepest = std::max(deepest, depthOf({x, y, z}));
    });
    return deepest;
  }
  template <class Value>
  float mean(glm::ivec3 point, const Value& value) const {
    float sum = 0, count = 0;
    forEachCorner(point, refinement_, [&](glm::ivec3 at) {
      sum += value(at);
      ++count;
    });
    return sum / count;
  }

  GridView<const float> distance_;
  int refinement_;
  float voxel_;
  glm::vec3 perStep_{1};
};

}  // namespace

void narrowOutlines(GridView<const float> distance, const BitGrid& inside, int refinement, int y, int z,
                    std::uint64_t* row) {
  const auto words = static_cast<std::size_t>(inside.words());
  BitRow near(words, 0), crossed(words);
  forEachCorner({0, y, z}, refinement, [&](glm::ivec3 corner) {
    crossedRow(inside, corner.y, corner.z, crossed);
    std::transform(near.begin(), near.end(), crossed.begin(), near.begin(), std::bit_or());
  });
  // Points further from all samples beside the surface are deep enough.
  const Outline outline(distance, refinement);
  const int last = (inside.size().x - 1) * refinement;
  int done = -1;
  forEachBit(near.data(), inside.words(), [&](int sample) {
    const int middle = sample * refinement, reach = refinement - 1;
    for (int x = std::max(middle - reach, done + 1); x <= std::min(middle + reach, last); ++x) {
      const std::uint64_t bit = std::uint64_t{1} << (x % kWordBits);
      if ((row[x / kWordBits] & bit) != 0 && outline.isWidened({x, y, z})) row[x / kWordBits] &= ~bit;
    }
    done = middle + reach;
  });
}

}  // namespace isolume
