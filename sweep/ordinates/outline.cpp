#include "outline.h"

#include <algorithm>
#include <functional>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

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

// In the smallest width of a voxel.
class Depths {
 public:
  explicit Depths(GridView<const float> distance)
      : distance_(distance),
        voxel_(static_cast<float>(std::min({distance.spacing.x, distance.spacing.y, distance.spacing.z}))) {
    for (int axis = 0; axis < 3; ++axis) {
      const float ratio = voxel_ / static_cast<float>(distance.spacing[axis]);
      perStep_[axis] = ratio * ratio;
    }
  }

  const float* row(int y, int z) const { return &distance_(0, y, z); }
  float voxel() const { return voxel_; }
  float at(glm::ivec3 sample) const {
    return std::clamp(-distance_(sample.x, sample.y, sample.z) / voxel_, -kKnown, kKnown);
  }
  // k_1 + k_2; on the border of the grid, where the solid is cut, none.
  float curvatureAt(glm::ivec3 sample) const {
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (sample[axis] == 0 || sample[axis] == distance_.size[axis] - 1) return 0;
      glm::ivec3 before = sample, after = sample;
      --before[axis];
      ++after[axis];
      sum += ((at(sample) - at(before)) + (at(sample) - at(after))) * perStep_[axis];
    }
    return sum;
  }
  // One of the 26 around, or the sample.
  bool isDeeperAround(glm::ivec3 sample, float depth) const {
    const glm::ivec3 low = glm::max(sample - 1, glm::ivec3(0)), high = glm::min(sample + 1, distance_.size - 1);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x)
          if (at({x, y, z}) > depth) return true;
    return false;
  }

 private:
  GridView<const float> distance_;
  float voxel_;
  glm::vec3 perStep_{1};
};

// The points of a row of the lattice, by words of samples.
class OutlineRow {
 public:
  OutlineRow(const Depths& depths, int refinement, int y, int z)
      : depths_(depths),
        refinement_(refinement),
        y_(y),
        z_(z),
        cell_(1 / static_cast<float>(refinement)),
        most_(kMostNarrowed * cell_) {
    forEachCorner({0, y, z}, refinement, [&](glm::ivec3 corner) { rows_[count_++] = depths.row(corner.y, corner.z); });
  }

  // Reads the depths of samples [begin, end), a word of them and one more at most.
  void read(int begin, int end) {
    begin_ = begin;
    float sums[kWordBits + 1] = {};
    const float known = kKnown * depths_.voxel();
    for (int i = 0; i < count_; ++i)
      for (int k = 0; k < end - begin; ++k) sums[k] += std::min(std::max(rows_[i][begin + k], -known), known);
    std::copy_n(sums, kWordBits + 1, distances_);
  }

  // Of what was read: the point at a sample, or half a voxel after it.
  bool isWidened(int sample, bool between) const {
    const float* sum = distances_ + (sample - begin_);
    const auto samples = static_cast<float>(between ? 2 * count_ : count_);
    const float depth = -(between ? sum[0] + sum[1] : sum[0]) / (samples * depths_.voxel());
    if (depth >= most_) return false;
    const glm::ivec3 point(sample * refinement_ + (between ? 1 : 0), y_, z_);
    float curvature = 0;
    forEachCorner(point, refinement_, [&](glm::ivec3 corner) { curvature += depths_.curvatureAt(corner); });
    if (depth >= std::min(most_, curvature / samples * cell_ * cell_)) return false;
    bool thick = false;
    forEachCorner(point, refinement_,
                  [&](glm::ivec3 corner) { thick = thick || depths_.isDeeperAround(corner, depth + kThickness); });
    return thick;
  }

 private:
  const Depths& depths_;
  int refinement_, y_, z_, count_ = 0, begin_ = 0;
  float cell_, most_;
  const float* rows_[4];
  float distances_[kWordBits + 1];  // sums over the rows around
};

// The rows of a layer, one after the other.
class OutlineLayer {
 public:
  OutlineLayer(GridView<const float> distance, const BitGrid& inside, int refinement)
      : depths_(distance),
        inside_(inside),
        refinement_(refinement),
        crossed_(static_cast<std::size_t>(inside.words())),
        near_(static_cast<std::size_t>(inside.words()) + 1) {}

  void narrow(int y, int z, std::uint64_t* row) {
    std::fill(near_.begin(), near_.end(), std::uint64_t{0});
    forEachCorner({0, y, z}, refinement_, [&](glm::ivec3 corner) {
      crossedRow(inside_, corner.y, corner.z, crossed_);
      std::transform(crossed_.begin(), crossed_.end(), near_.begin(), near_.begin(), std::bit_or());
    });
    // Points further from all samples beside the surface are deep enough.
    OutlineRow outline(depths_, refinement_, y, z);
    const auto test = [&](int sample, bool between) {
      const int x = sample * refinement_ + (between ? 1 : 0);
      const std::uint64_t bit = std::uint64_t{1} << (x % kWordBits);
      if ((row[x / kWordBits] & bit) != 0 && outline.isWidened(sample, between)) row[x / kWordBits] &= ~bit;
    };
    for (int w = 0; w < inside_.words(); ++w) {
      const auto i = static_cast<std::size_t>(w);
      const std::uint64_t at = near_[i], between = refinement_ == 1 ? 0 : at | at >> 1 | near_[i + 1] << (kWordBits - 1);
      const std::uint64_t any = at | between;
      if (any == 0) continue;
      const int begin = w * kWordBits;
      outline.read(begin, std::min(begin + kWordBits + 1, inside_.size().x));
      forEachBit(&any, 1, [&](int k) {
        const int sample = begin + k;
        if ((at >> k & 1) != 0) test(sample, false);
        if ((between >> k & 1) != 0 && sample + 1 < inside_.size().x) test(sample, true);
      });
    }
  }

 private:
  Depths depths_;
  const BitGrid& inside_;
  int refinement_;
  BitRow crossed_, near_;
};

}  // namespace

void narrowOutlines(GridView<const float> distance, const BitGrid& inside, int refinement, int z, BitRows& lattice) {
  OutlineLayer layer(distance, inside, refinement);
  for (int y = 0; y < lattice.rows; ++y) layer.narrow(y, z, lattice.row(y, z));
}

}  // namespace isolume
