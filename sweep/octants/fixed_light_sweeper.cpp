#include "fixed_light_sweeper.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "fixed_layer.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// One plane after all octants of a walk.
struct LitPlane {
  std::size_t firstVoxel = 0;
  int walk = 0;       // 0: octants 0 to 3
  bool last = false;  // the other walk has been here
  MergedRows rows;
};

struct Request {
  GridView<const float> distance;
  float opacity = 1;
  std::array<LightPart, kOctantCount> parts;
  std::function<void(const LitPlane&)> store;
};

// -tau of the blocks of a grid: what the first walk finds there, for the second.
using BlockContents = std::vector<Content>;

FixedWeights weightsOf(glm::dvec3 spacing) {
  const glm::dvec3 inverse = 1.0 / spacing;
  constexpr double kOne = 32768;
  const auto weightOf = [&](double part) {
    return static_cast<std::int16_t>(std::min(std::lround(kOne * part / (inverse.x + inverse.y + inverse.z)), 32767L));
  };
  return {weightOf(inverse.x), weightOf(inverse.y)};
}

class Walk {
 public:
  Walk(const Request& request, int number, const LayerShape& shape, BlockContents& blocks)
      : request_(request),
        shape_(shape),
        blocks_(blocks),
        number_(number),
        weights_(weightsOf(request.distance.spacing)) {
    const int atOnce = std::clamp(threadCount() / 2, 1, shape_.layers());
    for (int i = 0; i < atOnce; ++i) layers_.emplace_back(shape_);
    for (auto& carried : carried_)
      for (int c = 0; c < shape_.columns; ++c)
        carried.push_back({makeFixedValues(shape_.column.plane(), kOutside), shape_.segments({true, kOutside})});
  }

  /// Layers in the order of the walk.
  void sweep(int first, int last, bool secondVisit) {
    // A layer's turns: its transmittances, its columns up in y, its columns down, its results.
    const int columns = shape_.columns, turns = 2 * columns + 2;
    const int atOnce = static_cast<int>(layers_.size());
    for (int from = first; from < last; from += atOnce) {
      const int count = std::min(atOnce, last - from);
      for (int diagonal = 0; diagonal < turns + count - 1; ++diagonal) {
        const int begin = std::max(0, diagonal - turns + 1), end = std::min(diagonal + 1, count);
        parallelFor(static_cast<std::size_t>(end - begin), [&](std::size_t i) {
          const int at = begin + static_cast<int>(i), turn = diagonal - at;
          FixedLayer& layer = layers_[static_cast<std::size_t>(at)];
          const LayerPlanes planes = planesOf(from + at);
          if (turn == 0)
            layer.prepare(request_.distance, request_.opacity, planes, secondVisit, blocksOf(planes));
          else if (turn == turns - 1)
            finish(layer, planes, secondVisit);
          else
            sweepColumns(layer, planes[0], (turn - 1) % columns, turn <= columns);
        });
      }
    }
  }

 private:
  LayerPlanes planesOf(int layerOrder) const {
    LayerPlanes planes;
    for (int p = 0; p < kFixedPlanes; ++p) {
      const int z = layerOrder * kFixedPlanes + p;
      planes[static_cast<std::size_t>(p)] = number_ == 0 ? z : shape_.layers() * kFixedPlanes - 1 - z;
    }
    return planes;
  }
  Content* blocksOf(const LayerPlanes& planes) const {
    return blocks_.data() + static_cast<std::size_t>(planes[0] / kFixedPlanes) * shape_.blocks();
  }
  void finish(FixedLayer& layer, const LayerPlanes& planes, bool secondVisit) const {
    layer.finish(planes, [&](int z, const MergedRows& rows) {
      request_.store({request_.distance.index(0, 0, z), number_, secondVisit, rows});
    });
  }

  void sweepColumns(FixedLayer& layer, int firstPlane, int order, bool forward) {
    const std::size_t upOctant = forward ? 0 : 2, downOctant = forward ? 1 : 3;
    const std::size_t upDiagonal = forward ? kRising : kFalling, downDiagonal = forward ? kFalling : kRising;
    const ColumnShape& shape = shape_.column;
    const auto upColumn = static_cast<std::size_t>(order);
    const auto downColumn = static_cast<std::size_t>(shape_.columns - 1 - order);
    // sign_x x + sign_y y + sign_z z along the diagonal of the first step.
    const int downX = static_cast<int>(downColumn) * shape.lanes;
    const int z = number_ == 0 ? firstPlane : -firstPlane;
    const int upPhase = z + order * shape.lanes - (forward ? 0 : shape_.size.y - 1);
    const int downPhase = z - downX - (forward ? shape.lanes - 1 : shape.steps() - 1);
    const auto columnOf = [&](std::size_t octant, std::size_t diagonal, std::size_t column, int phase) {
      const MarkedValues& transmitting = layer.transmitting(diagonal, column);
      MergedValues& merged = layer.merged(diagonal, column);
      MarkedValues& carried = carried_[octant][column];
      return FixedColumn{transmitting.values.get(),
                         transmitting.held.data(),
                         request_.parts[static_cast<std::size_t>(number_ * kOctantsOfWalk) + octant],
                         merged.values.get(),
                         merged.meant.data(),
                         carried.values.get(),
                         carried.held.data(),
                         layer.edge(octant).get(),
                         phase};
    };
    sweepFixedColumns(columnOf(upOctant, upDiagonal, upColumn, upPhase),
                      columnOf(downOctant, downDiagonal, downColumn, downPhase), shape, weights_, forward);
  }

  const Request& request_;
  const LayerShape& shape_;
  BlockContents& blocks_;
  int number_;
  FixedWeights weights_;
  std::vector<FixedLayer> layers_;  // at work at once
  std::array<std::vector<MarkedValues>, kOctantsOfWalk> carried_;
};

void sweepBothWays(const Request& request) {
  const LayerShape shape(request.distance.size);
  const int layers = shape.layers(), half = layers / 2;
  BlockContents blocks(static_cast<std::size_t>(layers) * shape.blocks());
  std::array<Walk, 2> walks{Walk(request, 0, shape, blocks), Walk(request, 1, shape, blocks)};
  parallelFor(2, [&](std::size_t w) { walks[w].sweep(0, w == 0 ? half : layers - half, false); });
  parallelFor(2, [&](std::size_t w) { walks[w].sweep(w == 0 ? half : layers - half, layers, true); });
}

}  // namespace

void sweepOctantBytes(GridView<const float> distance, float opacity, std::array<glm::u8vec4*, 2> grids) {
  Request request{distance, opacity, {}, {}};
  for (std::size_t s = 0; s < request.parts.size(); ++s)
    request.parts[s] = s % kOctantsOfWalk < 2 ? kFirstByte : kSecondByte;
  request.store = [&](const LitPlane& plane) {
    packBytes(plane.rows, grids[static_cast<std::size_t>(plane.walk)] + plane.firstVoxel);
  };
  sweepBothWays(request);
}

void sweepOctantMean(GridView<const float> distance, float opacity, const std::array<float, kOctantCount>& shares,
                     std::uint16_t* mean) {
  Request request{distance, opacity, {}, {}};
  constexpr int kOne = 32768;
  int total = 0;
  for (std::size_t s = 0; s < shares.size(); ++s) {
    const auto share = std::min(std::lround(static_cast<float>(kOne) * shares[s]), static_cast<long>(kFullLight));
    request.parts[s] = missingLight(static_cast<std::int16_t>(share));
    total += static_cast<int>((share * kFullLight + kOne / 2) / kOne);  // R(share * all)
  }
  request.store = [&](const LitPlane& plane) { packMeans(plane.rows, plane.last, total, mean + plane.firstVoxel); };
  sweepBothWays(request);
}

}  // namespace isolume
