#include "openness_transport.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "light_row.h"
#include "ordinate_groups.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// Units of a sum: a term is at most 1, and 2^23 of them fit.
constexpr double kUnit = 0x1p40;

// One group on its way through the grid.
class GroupSweep {
 public:
  GroupSweep(GridView<const float> distance, const OrdinateGroup& group, const TransportOptions& options)
      : distance_(distance), group_(group), model_(options.transmittance), size_(distance.size) {
    for (std::size_t k = 0; k < group.directions.size(); ++k) {
      const UpwindWeights weights = upwindWeights(options.scheme, group.directions[k], distance.spacing);
      for (std::size_t entry = 0; entry < weights.size(); ++entry) row_.weights[entry][k] = weights[entry];
      row_.power[k] = powerOf(model_, group.directions[k]);
    }
    row_.count = size_.x;
    row_.diagonals = options.scheme != TransportScheme::step;
    row_.powers = model_ == Transmittance::insideByLength;
    const auto values = static_cast<std::size_t>(rowStride() * (size_.y + 1));
    for (auto& plane : leaving_) plane.assign(values, 1);
    for (auto& plane : visibility_)
      plane.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) * kOrdinateGroup, 1);
    ramp_.resize(static_cast<std::size_t>(size_.x));
  }

  /// Planes in the order of the sweep.
  void sweepPlane(int order) {
    const float perSmallest = 1 / static_cast<float>(smallestSpacing(distance_.spacing));
    std::swap(leaving_[0], leaving_[1]);
    std::swap(visibility_[0], visibility_[1]);
    const int z = group_.sweep.z > 0 ? order : size_.z - 1 - order;
    for (int k = 0; k < size_.y; ++k) {
      const int y = group_.sweep.y > 0 ? k : size_.y - 1 - k;
      for (int i = 0; i < size_.x; ++i)
        ramp_[static_cast<std::size_t>(i)] =
            rampOf(model_, distance_(group_.sweep.x > 0 ? i : size_.x - 1 - i, y, z) * perSmallest);
      float* own = leaving_[0].data() + (k + 1) * rowStride();
      const float* below = leaving_[1].data() + (k + 1) * rowStride();
      row_.ramp = ramp_.data();
      row_.upwind = {own, own - rowStride(), below, below - rowStride()};
      row_.leaving = own + kOrdinateGroup;
      row_.visibility = visibility_[0].data() + static_cast<std::ptrdiff_t>(k) * size_.x * kOrdinateGroup;
      sweepLightRow(row_);
    }
  }

  /// V of the samples at x, y of the grid; the plane swept last (0) or the one before (1).
  const float* visibilityAt(int x, int y, int planesAgo) const {
    const int i = group_.sweep.x > 0 ? x : size_.x - 1 - x, k = group_.sweep.y > 0 ? y : size_.y - 1 - y;
    return visibility_[static_cast<std::size_t>(planesAgo)].data() +
           (static_cast<std::ptrdiff_t>(k) * size_.x + i) * kOrdinateGroup;
  }

 private:
  std::ptrdiff_t rowStride() const { return static_cast<std::ptrdiff_t>(size_.x + 1) * kOrdinateGroup; }

  GridView<const float> distance_;
  const OrdinateGroup& group_;
  Transmittance model_;
  glm::ivec3 size_;
  LightRow row_;
  std::array<std::vector<float>, 2> leaving_, visibility_;  // of this plane and the one before; light outside is 1
  std::vector<float> ramp_;
};

// Where a point is read.
struct Place {
  glm::ivec3 low{0};
  glm::vec3 part{0};
};

Place placeOf(const OpenPoint& point, double offset, glm::ivec3 size) {
  const glm::vec3 above = point.position + static_cast<float>(offset) * point.normal;
  const glm::vec3 within = glm::clamp(above, glm::vec3(0), glm::vec3(size - 1));
  Place place;
  place.low = glm::min(glm::ivec3(within), size - 2);
  place.part = within - glm::vec3(place.low);
  return place;
}

}  // namespace

std::vector<float> transportOpenness(GridView<const float> distance, const std::vector<OpenPoint>& points,
                                     const TransportOptions& options) {
  const glm::ivec3 size = distance.size;
  assert(options.ordinates >= 1 && size.x >= 2 && size.y >= 2 && size.z >= 2);
  std::vector<Place> places(points.size());
  std::vector<std::vector<std::size_t>> ofLayer(static_cast<std::size_t>(size.z));
  for (std::size_t i = 0; i < points.size(); ++i) {
    places[i] = placeOf(points[i], options.offsetVoxels, size);
    ofLayer[static_cast<std::size_t>(places[i].low.z)].push_back(i);
  }

  const std::vector<OrdinateGroup> groups = ordinateGroups(options.ordinates, kOrdinateGroup);
  std::vector<std::atomic<std::int64_t>> open(points.size()), all(points.size());
  parallelFor(groups.size(), [&](std::size_t g) {
    const OrdinateGroup& group = groups[g];
    GroupSweep sweep(distance, group, options);
    for (int order = 0; order < size.z; ++order) {
      sweep.sweepPlane(order);
      if (order == 0) continue;
      const bool up = group.sweep.z > 0;
      for (const std::size_t i : ofLayer[static_cast<std::size_t>(up ? order - 1 : size.z - 1 - order)]) {
        const Place& place = places[i];
        double got = 0, most = 0;
        for (std::size_t k = 0; k < group.directions.size(); ++k) {
          const double cosine = glm::dot(glm::dvec3(points[i].normal), group.directions[k]);
          if (cosine <= 0) continue;
          float sum = 0;
          for (int corner = 0; corner < 8; ++corner) {
            const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
            const glm::vec3 weight = glm::mix(1.0F - place.part, place.part, glm::vec3(side));
            const int planesAgo = (side.z == 1) == up ? 0 : 1;
            sum += weight.x * weight.y * weight.z *
                   sweep.visibilityAt(place.low.x + side.x, place.low.y + side.y, planesAgo)[k];
          }
          got += cosine * sum;
          most += cosine;
        }
        open[i] += std::llround(got * kUnit);
        all[i] += std::llround(most * kUnit);
      }
    }
  });

  std::vector<float> openness(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    openness[i] = all[i] == 0 ? 1 : static_cast<float>(static_cast<double>(open[i]) / static_cast<double>(all[i]));
  return openness;
}

}  // namespace isolume
