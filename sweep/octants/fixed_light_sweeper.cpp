#include "fixed_light_sweeper.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "column_shear.h"
#include "fixed_light.h"
#include "sweep/large_array.h"
#include "sweep/parallel.h"

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

// Values, and what each segment of them holds.
struct Marked {
  Values values;
  std::vector<Content> held;
};
// A column's merged parts: of even segments `held` is what the buffer holds, not what is meant.
struct Merged : Marked {
  std::vector<Content> meant;
};

// A layer at work.
struct Layer {
  Marked transmittance;                                      // rows of the planes; held: [column][segment of rows]
  std::array<std::vector<Marked>, kDiagonals> transmitting;  // of each column
  std::array<std::vector<Merged>, kDiagonals> merged;
  std::array<Values, kOctantsOfWalk> edge;
  Values scratch;
  std::array<Marked, kDiagonals> rows;  // held: as of the transmittances
};

// -tau of the blocks of a grid, a column of a layer in a segment of rows: what the first walk finds there, for the
// second.
using BlockContents = std::vector<Content>;

class Walk {
 public:
  Walk(const Request& request, int number, BlockContents& blocks)
      : request_(request),
        blocks_(blocks),
        number_(number),
        size_(request.distance.size),
        shape_{size_.y, columnLanes()} {
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
      for (int c = 0; c < columns_; ++c)
        carried.push_back({makeValues(shape_.plane(), kOutside), segmentsOf({true, kOutside})});
    blocks_.resize(static_cast<std::size_t>(layerCount()) * blocksOfLayer());
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
            prepare(layer, from + at, secondVisit);
          else if (turn == turns - 1)
            finish(layer, from + at, secondVisit);
          else
            sweepColumns(layer, from + at, (turn - 1) % columns_, turn <= columns_);
        });
      }
    }
  }

 private:
  std::vector<Content> segmentsOf(Content content) const {
    return std::vector<Content>(static_cast<std::size_t>(shape_.segments()), content);
  }
  std::size_t blocksOfLayer() const { return static_cast<std::size_t>(columns_ * shape_.rowSegments()); }
  std::size_t blockOf(int column, int segment) const {
    return static_cast<std::size_t>(column * shape_.rowSegments() + segment);
  }
  Layer makeLayer() const {
    const Content clear{true, kClear}, none{true, 0};
    Layer layer;
    // `lanes` clear rows around each plane.
    layer.transmittance = {makeValues(planeRows() * kFixedPlanes, kClear),
                           std::vector<Content>(blocksOfLayer(), clear)};
    for (std::size_t k = 0; k < kDiagonals; ++k) {
      for (int c = 0; c < columns_; ++c) {
        layer.transmitting[k].push_back({makeValues(shape_.column(), kClear), segmentsOf(clear)});
        layer.merged[k].push_back({{makeValues(shape_.column(), 0), segmentsOf(none)}, segmentsOf(none)});
      }
      layer.rows[k] = {makeValues(static_cast<std::size_t>(shape_.ny * stride_), 0),
                       std::vector<Content>(blocksOfLayer(), none)};
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
  Stretch rowsOf(int segment) const { return {segment * kSegment, std::min((segment + 1) * kSegment, shape_.ny)}; }
  Stretch stepsOf(int segment) const {
    return {segment * kSegment, std::min((segment + 1) * kSegment, shape_.steps())};
  }
  // Row 0 of a layer's p-th plane.
  std::int16_t* transmittanceRows(Layer& layer, int p) const {
    return layer.transmittance.values.get() + static_cast<std::size_t>(p) * planeRows() + shape_.lanes * stride_;
  }
  // Step 0 of a plane of a column.
  std::int16_t* inColumn(Marked& column, int p) const {
    return column.values.get() + static_cast<std::size_t>(p) * shape_.plane();
  }
  // A segment of a column, if it is not so already.
  void fill(Marked& column, int segment, Content content) const {
    Content& held = column.held[static_cast<std::size_t>(segment)];
    if (held == content) return;
    const Stretch steps = stepsOf(segment);
    for (int p = 0; p < kFixedPlanes; ++p)
      std::fill_n(inColumn(column, p) + steps.begin * shape_.lanes, (steps.end - steps.begin) * shape_.lanes,
                  content.value);
    held = content;
  }
  // The same of a column's part of some rows.
  void fillRows(std::int16_t* rows, int column, int segment, Content content) const {
    const Stretch stretch = rowsOf(segment);
    for (int y = stretch.begin; y < stretch.end; ++y)
      std::fill_n(rows + y * stride_ + column * shape_.lanes, shape_.lanes, content.value);
  }
  // Calls visit(begin, end) for the runs of segments that are not even.
  template <class Visit>
  static void forEachUneven(const Content* contents, int count, const Visit& visit) {
    for (int begin = 0; begin < count; ++begin) {
      if (contents[begin].even) continue;
      int end = begin + 1;
      while (end < count && !contents[end].even) ++end;
      visit(begin, end);
      begin = end;
    }
  }

  void convertRow(int y, int z, int firstColumn, int endColumn, std::int16_t* rows) const {
    const GridView<const float>& distance = request_.distance;
    const auto perSmallest = 1 / static_cast<float>(smallestSpacing(distance.spacing));
    const int x = firstColumn * shape_.lanes, count = std::min(endColumn * shape_.lanes, size_.x) - x;
    transmittanceRow(&distance(x, y, z), count, perSmallest, centredRamp(request_.opacity), rows + y * stride_ + x);
  }
  // What a block of the layer's rows is; planes beyond the grid are clear.
  Content findContent(Layer& layer, int layerOrder, int column, int segment) const {
    const Stretch rows = rowsOf(segment);
    Content content;
    bool first = true;
    for (int p = 0; p < kFixedPlanes; ++p) {
      const std::int16_t* start = transmittanceRows(layer, p) + rows.begin * stride_ + column * shape_.lanes;
      const bool exists = planeOf(layerOrder, p) < size_.z;
      const Content plane = exists ? contentOfRows(start, stride_, rows.end - rows.begin) : Content{true, kClear};
      content = first ? plane : together(content, plane);
      first = false;
    }
    return content;
  }

  void prepare(Layer& layer, int layerOrder, bool secondVisit) const {
    const int layerOfGrid = planeOf(layerOrder, 0) / kFixedPlanes;
    Content* blocks = blocks_.data() + static_cast<std::size_t>(layerOfGrid) * blocksOfLayer();
    for (int segment = 0; segment < shape_.rowSegments(); ++segment) {
      const Stretch rows = rowsOf(segment);
      const auto convert = [&](int firstColumn, int endColumn) {
        for (int p = 0; p < kFixedPlanes; ++p) {
          const int z = planeOf(layerOrder, p);
          // Planes beyond the grid come first on the way down, clear as the layer is made, and last on the way up.
          for (int y = rows.begin; z < size_.z && y < rows.end; ++y)
            convertRow(y, z, firstColumn, endColumn, transmittanceRows(layer, p));
        }
      };
      if (!secondVisit) convert(0, columns_);
      for (int c = 0; c < columns_; ++c) {
        Content& block = blocks[blockOf(c, segment)];
        Content& held = layer.transmittance.held[blockOf(c, segment)];
        if (!secondVisit)
          block = findContent(layer, layerOrder, c, segment);
        else if (!block.even)
          convert(c, c + 1);
        else if (!(held == block))
          for (int p = 0; p < kFixedPlanes; ++p) fillRows(transmittanceRows(layer, p), c, segment, block);
        held = block;
      }
    }
    for (int c = 0; c < columns_; ++c) shearColumn(layer, c, blocks + blockOf(c, 0));
    for (Values& edge : layer.edge) std::fill_n(edge.get(), shape_.handover() * kFixedPlanes, kOutside);
  }
  void shearColumn(Layer& layer, int c, const Content* blocks) const {
    for (int segment = 0; segment < shape_.segments(); ++segment) {
      const Stretch steps = stepsOf(segment);
      const int firstRow = steps.begin - (shape_.lanes - 1), lastRow = steps.end - 1;
      const int firstBlock = std::max(firstRow, 0) / kSegment, lastBlock = std::min(lastRow, shape_.ny - 1) / kSegment;
      Content content = blocks[firstBlock];
      for (int block = firstBlock + 1; block <= lastBlock; ++block) content = together(content, blocks[block]);
      if (firstRow < 0 || lastRow >= shape_.ny) content = together(content, {true, kClear});
      for (auto& columns : layer.transmitting) {
        Marked& column = columns[static_cast<std::size_t>(c)];
        if (content.even)
          fill(column, segment, content);
        else
          column.held[static_cast<std::size_t>(segment)] = content;
      }
    }
    for (std::size_t k = 0; k < kDiagonals; ++k) {
      Marked& column = layer.transmitting[k][static_cast<std::size_t>(c)];
      forEachUneven(column.held.data(), shape_.segments(), [&](int begin, int end) {
        for (int p = 0; p < kFixedPlanes; ++p)
          shearRows(transmittanceRows(layer, p) + static_cast<std::ptrdiff_t>(c) * shape_.lanes, stride_, shape_,
                    k == kRising, {stepsOf(begin).begin, stepsOf(end - 1).end}, layer.scratch.get(),
                    inColumn(column, p));
      });
    }
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
      const Marked& transmitting = layer.transmitting[diagonal][column];
      Merged& merged = layer.merged[diagonal][column];
      Marked& carried = carried_[octant][column];
      return FixedColumn{transmitting.values.get(),
                         transmitting.held.data(),
                         request_.parts[static_cast<std::size_t>(number_ * kOctantsOfWalk) + octant],
                         merged.values.get(),
                         merged.meant.data(),
                         carried.values.get(),
                         carried.held.data(),
                         layer.edge[octant].get(),
                         phase};
    };
    sweepFixedColumns(columnOf(upOctant, upDiagonal, upColumn, upPhase),
                      columnOf(downOctant, downDiagonal, downColumn, downPhase), shape_, weights_, forward);
  }

  // What is meant by a column's merged parts in all rows' segments; where it is not even, the column's buffer is made
  // to hold it.
  std::vector<Content> settle(Merged& merged) const {
    for (std::size_t segment = 0; segment < merged.meant.size(); ++segment)
      if (!merged.meant[segment].even) merged.held[segment] = {};
    std::vector<Content> rows(static_cast<std::size_t>(shape_.rowSegments()));
    for (int segment = 0; segment < shape_.rowSegments(); ++segment) {
      const int last = (rowsOf(segment).end - 1 + shape_.lanes - 1) / kSegment;
      Content& content = rows[static_cast<std::size_t>(segment)];
      content = merged.meant[static_cast<std::size_t>(segment)];
      for (int i = segment + 1; i <= last; ++i) content = together(content, merged.meant[static_cast<std::size_t>(i)]);
      for (int i = segment; !content.even && i <= last; ++i)
        if (merged.meant[static_cast<std::size_t>(i)].even) fill(merged, i, merged.meant[static_cast<std::size_t>(i)]);
    }
    return rows;
  }

  void finish(Layer& layer, int layerOrder, bool secondVisit) const {
    std::array<std::vector<std::vector<Content>>, kDiagonals> contents;
    for (std::size_t k = 0; k < kDiagonals; ++k)
      for (Merged& merged : layer.merged[k]) contents[k].push_back(settle(merged));
    for (int p = 0; p < kFixedPlanes; ++p) {
      const int z = planeOf(layerOrder, p);
      if (z >= size_.z) continue;
      for (std::size_t k = 0; k < kDiagonals; ++k)
        for (int c = 0; c < columns_; ++c) {
          const std::vector<Content>& rows = contents[k][static_cast<std::size_t>(c)];
          Content* held = layer.rows[k].held.data() + blockOf(c, 0);
          for (int segment = 0; segment < shape_.rowSegments(); ++segment) {
            const Content content = rows[static_cast<std::size_t>(segment)];
            if (content.even && !(held[segment] == content)) fillRows(layer.rows[k].values.get(), c, segment, content);
            held[segment] = content;
          }
          forEachUneven(rows.data(), shape_.rowSegments(), [&](int begin, int end) {
            unshearRows(inColumn(layer.merged[k][static_cast<std::size_t>(c)], p), shape_, k == kRising,
                        {rowsOf(begin).begin, rowsOf(end - 1).end}, layer.scratch.get(),
                        layer.rows[k].values.get() + static_cast<std::ptrdiff_t>(c) * shape_.lanes, stride_);
          });
        }
      request_.store(
          {request_.distance.index(0, 0, z),
           number_,
           secondVisit,
           {layer.rows[kRising].values.get(), layer.rows[kFalling].values.get(), size_.x, size_.y, stride_}});
    }
  }

  const Request& request_;
  BlockContents& blocks_;
  int number_;
  glm::ivec3 size_;
  ColumnShape shape_;
  int columns_ = 0;
  std::ptrdiff_t stride_ = 0;
  FixedWeights weights_;
  std::vector<Layer> layers_;
  std::array<std::vector<Marked>, kOctantsOfWalk> carried_;
};

void sweepBothWays(const Request& request) {
  BlockContents blocks;
  std::array<Walk, 2> walks{Walk(request, 0, blocks), Walk(request, 1, blocks)};
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
