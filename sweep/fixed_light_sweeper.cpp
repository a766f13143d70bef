#include "fixed_light_sweeper.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "column_shear.h"
#include "fixed_light.h"
#include "large_array.h"
#include "parallel.h"

namespace isolume {
namespace {

using Values = LargeArray<std::int16_t>;

Values makeValues(std::size_t count, std::int16_t value) {
  Values values = makeLargeArray<std::int16_t>(count);
  std::fill_n(values.get(), count, value);
  return values;
}

constexpr std::int16_t kOutside = -kFullLight;
constexpr int kOctantsOfWalk = kOctantCount / 2;
// Octants 0 and 3 of a walk share the rising diagonals, 1 and 2 the falling ones; 0 and 2 run up in x, 0 and 1 in y.
constexpr int kDiagonals = 2;
constexpr std::size_t kRising = 0, kFalling = 1;

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

// A layer at work.
struct Layer {
  Values transmittance;                                      // rows of the planes
  std::array<std::vector<Values>, kDiagonals> transmitting;  // of each column
  std::array<std::vector<Values>, kDiagonals> merged;
  std::array<Values, kOctantsOfWalk> edge;
  Values scratch;
  std::array<Values, kDiagonals> rows;
};

class Walk {
 public:
  Walk(const Request& request, int number)
      : request_(request), number_(number), size_(request.distance.size), shape_{size_.y, columnLanes()} {
    columns_ = (size_.x + shape_.lanes - 1) / shape_.lanes;
    stride_ = static_cast<std::ptrdiff_t>(columns_) * shape_.lanes;
    const glm::dvec3 inverse = 1.0 / request.distance.spacing;
    constexpr double kOne = 32768;
    const auto weightOf = [&](double part) {
      return static_cast<std::int16_t>(
          std::min(std::lround(kOne * part / (inverse.x + inverse.y + inverse.z)), 32767L));
    };
    weights_ = {weightOf(inverse.x), weightOf(inverse.y)};
    layers_.resize(static_cast<std::size_t>(std::clamp(threadCount() / 2, 1, layerCount())));
    for (Layer& layer : layers_) layer = makeLayer();
    for (auto& carried : carried_)
      for (int c = 0; c < columns_; ++c) carried.push_back(makeValues(shape_.plane(), kOutside));
  }

  int layerCount() const { return (size_.z + kFixedPlanes - 1) / kFixedPlanes; }

  /// Layers in the order of the walk.
  void sweep(int first, int last, bool secondVisit) {
    // A layer's turns: its transmittances, its columns up in y, its columns down, its results.
    const int turns = 2 * columns_ + 2;
    const int atOnce = static_cast<int>(layers_.size());
    for (int from = first; from < last; from += atOnce) {
      const int count = std::min(atOnce, last - from);
      for (int diagonal = 0; diagonal < turns + count - 1; ++diagonal) {
        const int begin = std::max(0, diagonal - turns + 1), end = std::min(diagonal + 1, count);
        parallelFor(static_cast<std::size_t>(end - begin), [&](std::size_t i) {
          const int at = begin + static_cast<int>(i), turn = diagonal - at;
          Layer& layer = layers_[static_cast<std::size_t>(at)];
          if (turn == 0)
            prepare(layer, from + at);
          else if (turn == turns - 1)
            finish(layer, from + at, secondVisit);
          else
            sweepColumns(layer, from + at, (turn - 1) % columns_, turn <= columns_);
        });
      }
    }
  }

 private:
  Layer makeLayer() const {
    Layer layer;
    // `lanes` clear rows around each plane.
    layer.transmittance = makeValues(planeRows() * kFixedPlanes, kClear);
    for (std::size_t k = 0; k < kDiagonals; ++k) {
      for (int c = 0; c < columns_; ++c) {
        layer.transmitting[k].push_back(makeValues(shape_.column(), kClear));
        layer.merged[k].push_back(makeValues(shape_.column(), 0));
      }
      layer.rows[k] = makeValues(static_cast<std::size_t>(shape_.ny * stride_), 0);
    }
    for (Values& edge : layer.edge) edge = makeValues(shape_.handover() * kFixedPlanes, kOutside);
    layer.scratch = makeValues(shearScratch(shape_), 0);
    return layer;
  }
  std::size_t planeRows() const {
    return static_cast<std::size_t>(stride_) * static_cast<std::size_t>(shape_.ny + 2 * shape_.lanes);
  }
  // Of the layer's p-th plane in the order of the walk.
  int planeOf(int layerOrder, int p) const {
    const int z = layerOrder * kFixedPlanes + p;
    return number_ == 0 ? z : layerCount() * kFixedPlanes - 1 - z;
  }

  void prepare(Layer& layer, int layerOrder) const {
    const GridView<const float>& distance = request_.distance;
    const auto perSmallest = 1 / static_cast<float>(smallestSpacing(distance.spacing));
    for (int p = 0; p < kFixedPlanes; ++p) {
      const int z = planeOf(layerOrder, p);
      std::int16_t* rows =
          layer.transmittance.get() + static_cast<std::size_t>(p) * planeRows() + shape_.lanes * stride_;
      // Planes beyond the grid come first on the way down, clear as the layer is made, and last on the way up.
      for (int y = 0; z < size_.z && y < size_.y; ++y)
        transmittanceRow(&distance(0, y, z), size_.x, perSmallest, request_.opacity, rows + y * stride_);
      for (std::size_t k = 0; k < kDiagonals; ++k)
        for (int c = 0; c < columns_; ++c)
          shearRows(rows + static_cast<std::ptrdiff_t>(c) * shape_.lanes, stride_, shape_, k == kRising,
                    layer.scratch.get(), inColumn(layer.transmitting[k], c, p));
    }
    for (Values& edge : layer.edge) std::fill_n(edge.get(), shape_.handover() * kFixedPlanes, kOutside);
  }
  // Step 0 of a plane of a column.
  std::int16_t* inColumn(std::vector<Values>& columns, int c, int p) const {
    return columns[static_cast<std::size_t>(c)].get() + static_cast<std::size_t>(p) * shape_.plane() + shape_.lanes;
  }

  void sweepColumns(Layer& layer, int layerOrder, int order, bool forward) {
    const std::size_t upOctant = forward ? 0 : 2, downOctant = forward ? 1 : 3;
    const std::size_t upDiagonal = forward ? kRising : kFalling, downDiagonal = forward ? kFalling : kRising;
    const auto upColumn = static_cast<std::size_t>(order), downColumn = static_cast<std::size_t>(columns_ - 1 - order);
    // sign_x x + sign_y y + sign_z z along the diagonal of the first step.
    const int firstPlane = planeOf(layerOrder, 0), downX = static_cast<int>(downColumn) * shape_.lanes;
    const int z = number_ == 0 ? firstPlane : -firstPlane;
    const int upPhase = z + order * shape_.lanes - (forward ? 0 : size_.y - 1);
    const int downPhase = z - downX - (forward ? shape_.lanes - 1 : shape_.steps() - 1);
    const auto columnOf = [&](std::size_t octant, std::size_t diagonal, std::size_t column, int phase) {
      const LightPart& part = request_.parts[static_cast<std::size_t>(number_ * kOctantsOfWalk) + octant];
      return FixedColumn{layer.transmitting[diagonal][column].get(),
                         part,
                         layer.merged[diagonal][column].get(),
                         carried_[octant][column].get(),
                         layer.edge[octant].get(),
                         phase};
    };
    sweepFixedColumns(columnOf(upOctant, upDiagonal, upColumn, upPhase),
                      columnOf(downOctant, downDiagonal, downColumn, downPhase), shape_, weights_, forward);
  }

  void finish(Layer& layer, int layerOrder, bool secondVisit) const {
    for (int p = 0; p < kFixedPlanes; ++p) {
      const int z = planeOf(layerOrder, p);
      if (z >= size_.z) continue;
      for (std::size_t k = 0; k < kDiagonals; ++k)
        for (int c = 0; c < columns_; ++c)
          unshearRows(inColumn(layer.merged[k], c, p), shape_, k == kRising, layer.scratch.get(),
                      layer.rows[k].get() + static_cast<std::ptrdiff_t>(c) * shape_.lanes, stride_);
      request_.store({request_.distance.index(0, 0, z),
                      number_,
                      secondVisit,
                      {layer.rows[kRising].get(), layer.rows[kFalling].get(), size_.x, size_.y, stride_}});
    }
  }

  const Request& request_;
  int number_;
  glm::ivec3 size_;
  ColumnShape shape_;
  int columns_ = 0;
  std::ptrdiff_t stride_ = 0;
  FixedWeights weights_;
  std::vector<Layer> layers_;
  std::array<std::vector<Values>, kOctantsOfWalk> carried_;
};

void sweepBothWays(const Request& request) {
  std::array<Walk, 2> walks{Walk(request, 0), Walk(request, 1)};
  const int layers = walks[0].layerCount(), half = layers / 2;
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
