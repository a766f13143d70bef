#include "fixed_layer.h"

#include <algorithm>

namespace isolume {
namespace {

constexpr Content kClearContent{true, kClear}, kNoContent{true, 0};

// Calls visit(begin, end) for the runs of segments that are not even.
template <class Visit>
void forEachUneven(const Content* contents, int count, const Visit& visit) {
  for (int begin = 0; begin < count; ++begin) {
    if (contents[begin].even) continue;
    int end = begin + 1;
    while (end < count && !contents[end].even) ++end;
    visit(begin, end);
    begin = end;
  }
}

}  // namespace

FixedValues makeFixedValues(std::size_t count, std::int16_t value) {
  FixedValues values = makeLargeArray<std::int16_t>(count);
  std::fill_n(values.get(), count, value);
  return values;
}

LayerShape::LayerShape(glm::ivec3 gridSize) : size(gridSize), column{gridSize.y, columnLanes()} {
  columns = (size.x + column.lanes - 1) / column.lanes;
  stride = static_cast<std::ptrdiff_t>(columns) * column.lanes;
}

FixedLayer::FixedLayer(const LayerShape& shape) : shape_(shape) {
  const ColumnShape& column = shape_.column;
  transmittance_ = {makeFixedValues(planeRows() * kFixedPlanes, kClear),
                    std::vector<Content>(shape_.blocks(), kClearContent)};
  for (std::size_t k = 0; k < kDiagonals; ++k) {
    for (int c = 0; c < shape_.columns; ++c) {
      transmitting_[k].push_back({makeFixedValues(column.column(), kClear), shape_.segments(kClearContent)});
      merged_[k].push_back(
          {{makeFixedValues(column.column(), 0), shape_.segments(kNoContent)}, shape_.segments(kNoContent)});
    }
    rows_[k] = {makeFixedValues(static_cast<std::size_t>(column.ny * shape_.stride), 0),
                std::vector<Content>(shape_.blocks(), kNoContent)};
  }
  for (FixedValues& edge : edge_) edge = makeFixedValues(column.handover() * kFixedPlanes, kOutside);
  scratch_ = makeFixedValues(shearScratch(column), 0);
}

std::size_t FixedLayer::planeRows() const {
  return static_cast<std::size_t>(shape_.stride) * static_cast<std::size_t>(shape_.size.y + 2 * shape_.column.lanes);
}

// Row 0 of the p-th plane.
std::int16_t* FixedLayer::transmittanceRows(int p) const {
  return transmittance_.values.get() + static_cast<std::size_t>(p) * planeRows() + shape_.column.lanes * shape_.stride;
}

// Step 0 of a plane of a column.
std::int16_t* FixedLayer::inColumn(MarkedValues& column, int p) const {
  return column.values.get() + static_cast<std::size_t>(p) * shape_.column.plane();
}

// A segment of a column, if it is not so already.
void FixedLayer::fill(MarkedValues& column, int segment, Content content) const {
  Content& held = column.held[static_cast<std::size_t>(segment)];
  if (held == content) return;
  const Stretch steps = shape_.steps(segment);
  const int lanes = shape_.column.lanes;
  for (int p = 0; p < kFixedPlanes; ++p)
    std::fill_n(inColumn(column, p) + steps.begin * lanes, (steps.end - steps.begin) * lanes, content.value);
  held = content;
}

// The same of a column's part of some rows.
void FixedLayer::fillRows(std::int16_t* rows, int c, int segment, Content content) const {
  const Stretch stretch = shape_.rows(segment);
  const int lanes = shape_.column.lanes;
  for (int y = stretch.begin; y < stretch.end; ++y)
    std::fill_n(rows + y * shape_.stride + c * lanes, lanes, content.value);
}

// What a block of the rows is; planes beyond the grid are clear.
Content FixedLayer::findContent(const LayerPlanes& planes, int c, int segment) const {
  const Stretch rows = shape_.rows(segment);
  Content content;
  for (int p = 0; p < kFixedPlanes; ++p) {
    const std::int16_t* start = transmittanceRows(p) + rows.begin * shape_.stride + c * shape_.column.lanes;
    const bool exists = planes[static_cast<std::size_t>(p)] < shape_.size.z;
    const Content plane = exists ? contentOfRows(start, shape_.stride, rows.end - rows.begin) : kClearContent;
    content = p == 0 ? plane : together(content, plane);
  }
  return content;
}

void FixedLayer::prepare(GridView<const float> distance, float opacity, const LayerPlanes& planes, bool known,
                         Content* blocks) {
  const auto perSmallest = 1 / static_cast<float>(smallestSpacing(distance.spacing));
  const TransmittanceRamp ramp = centredRamp(opacity);
  for (int segment = 0; segment < shape_.column.rowSegments(); ++segment) {
    const Stretch rows = shape_.rows(segment);
    const auto convert = [&](int firstColumn, int endColumn) {
      const int x = firstColumn * shape_.column.lanes;
      const int count = std::min(endColumn * shape_.column.lanes, shape_.size.x) - x;
      for (int p = 0; p < kFixedPlanes; ++p) {
        const int z = planes[static_cast<std::size_t>(p)];
        // Beyond the grid all is clear as the layer was made.
        for (int y = rows.begin; z < shape_.size.z && y < rows.end; ++y)
          transmittanceRow(&distance(x, y, z), count, perSmallest, ramp, transmittanceRows(p) + y * shape_.stride + x);
      }
    };
    if (!known) convert(0, shape_.columns);
    for (int c = 0; c < shape_.columns; ++c) {
      Content& block = blocks[shape_.block(c, segment)];
      Content& held = transmittance_.held[shape_.block(c, segment)];
      if (!known)
        block = findContent(planes, c, segment);
      else if (!block.even)
        convert(c, c + 1);
      else if (!(held == block))
        for (int p = 0; p < kFixedPlanes; ++p) fillRows(transmittanceRows(p), c, segment, block);
      held = block;
    }
  }
  for (int c = 0; c < shape_.columns; ++c) shearColumn(c, blocks + shape_.block(c, 0));
  for (FixedValues& edge : edge_) std::fill_n(edge.get(), shape_.column.handover() * kFixedPlanes, kOutside);
}

void FixedLayer::shearColumn(int c, const Content* blocks) {
  const ColumnShape& shape = shape_.column;
  for (int segment = 0; segment < shape.segments(); ++segment) {
    const Stretch steps = shape_.steps(segment);
    const int firstRow = steps.begin - (shape.lanes - 1), lastRow = steps.end - 1;
    const int firstBlock = std::max(firstRow, 0) / kSegment, lastBlock = std::min(lastRow, shape.ny - 1) / kSegment;
    Content content = blocks[firstBlock];
    for (int block = firstBlock + 1; block <= lastBlock; ++block) content = together(content, blocks[block]);
    if (firstRow < 0 || lastRow >= shape.ny) content = together(content, kClearContent);
    for (auto& columns : transmitting_) {
      MarkedValues& column = columns[static_cast<std::size_t>(c)];
      if (content.even)
        fill(column, segment, content);
      else
        column.held[static_cast<std::size_t>(segment)] = content;
    }
  }
  for (std::size_t k = 0; k < kDiagonals; ++k) {
    MarkedValues& column = transmitting_[k][static_cast<std::size_t>(c)];
    forEachUneven(column.held.data(), shape.segments(), [&](int begin, int end) {
      for (int p = 0; p < kFixedPlanes; ++p)
        shearRows(transmittanceRows(p) + static_cast<std::ptrdiff_t>(c) * shape.lanes, shape_.stride, shape,
                  k == kRising, {shape_.steps(begin).begin, shape_.steps(end - 1).end}, scratch_.get(),
                  inColumn(column, p));
    });
  }
}

// What is meant by a column's merged parts in all rows' segments; where it is not even, the column's buffer is made to
// hold it.
std::vector<Content> FixedLayer::settle(MergedValues& merged) const {
  const ColumnShape& shape = shape_.column;
  for (std::size_t segment = 0; segment < merged.meant.size(); ++segment)
    if (!merged.meant[segment].even) merged.held[segment] = {};
  std::vector<Content> rows(static_cast<std::size_t>(shape.rowSegments()));
  for (int segment = 0; segment < shape.rowSegments(); ++segment) {
    const int last = (shape_.rows(segment).end - 1 + shape.lanes - 1) / kSegment;
    Content& content = rows[static_cast<std::size_t>(segment)];
    content = merged.meant[static_cast<std::size_t>(segment)];
    for (int i = segment + 1; i <= last; ++i) content = together(content, merged.meant[static_cast<std::size_t>(i)]);
    for (int i = segment; !content.even && i <= last; ++i)
      if (merged.meant[static_cast<std::size_t>(i)].even) fill(merged, i, merged.meant[static_cast<std::size_t>(i)]);
  }
  return rows;
}

// A column's part of the p-th plane; `contents`: what settle() says of it.
void FixedLayer::layInRows(std::size_t diagonal, int c, int p, const std::vector<Content>& contents) {
  const ColumnShape& shape = shape_.column;
  std::int16_t* rows = rows_[diagonal].values.get();
  Content* held = rows_[diagonal].held.data() + shape_.block(c, 0);
  for (int segment = 0; segment < shape.rowSegments(); ++segment) {
    const Content content = contents[static_cast<std::size_t>(segment)];
    if (content.even && !(held[segment] == content)) fillRows(rows, c, segment, content);
    held[segment] = content;
  }
  forEachUneven(contents.data(), shape.rowSegments(), [&](int begin, int end) {
    unshearRows(inColumn(merged_[diagonal][static_cast<std::size_t>(c)], p), shape, diagonal == kRising,
                {shape_.rows(begin).begin, shape_.rows(end - 1).end}, scratch_.get(),
                rows + static_cast<std::ptrdiff_t>(c) * shape.lanes, shape_.stride);
  });
}

void FixedLayer::finish(const LayerPlanes& planes, const std::function<void(int z, const MergedRows& rows)>& store) {
  std::array<std::vector<std::vector<Content>>, kDiagonals> contents;
  for (std::size_t k = 0; k < kDiagonals; ++k)
    for (MergedValues& merged : merged_[k]) contents[k].push_back(settle(merged));
  for (int p = 0; p < kFixedPlanes; ++p) {
    const int z = planes[static_cast<std::size_t>(p)];
    if (z >= shape_.size.z) continue;
    for (std::size_t k = 0; k < kDiagonals; ++k)
      for (int c = 0; c < shape_.columns; ++c) layInRows(k, c, p, contents[k][static_cast<std::size_t>(c)]);
    store(z, {rows_[kRising].values.get(), rows_[kFalling].values.get(), shape_.size.x, shape_.size.y, shape_.stride});
  }
}

}  // namespace isolume
