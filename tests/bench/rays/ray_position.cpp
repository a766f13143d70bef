#include "tests/bench/rays/ray_position.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

#include "sweep/reference/cell_cubic.h"

namespace isolume::bench {

RayPosition::RayPosition(const GridRay& ray, glm::ivec3 size, double t) : ray_(ray), lastCell_(size - 2), t_(t) {
  locate();
}

glm::dvec3 RayPosition::at(double t) const {
  return glm::clamp(ray_.origin + t * ray_.direction, glm::dvec3(0), glm::dvec3(lastCell_ + 1));
}

void RayPosition::goTo(double t) {
  t_ = t;
  locate();
}

void RayPosition::locate() { cell_ = glm::clamp(glm::ivec3(point()), glm::ivec3(0), lastCell_); }

RayPosition::Face RayPosition::faceOf(const CellBox& box) const {
  Face face{std::numeric_limits<double>::infinity(), 0};
  for (int axis = 0; axis < 3; ++axis) {
    if (ray_.direction[axis] == 0) continue;
    const double plane = ray_.direction[axis] > 0 ? box.high[axis] + 1 : box.low[axis];
    const double t = (plane - ray_.origin[axis]) / ray_.direction[axis];
    if (t < face.t) face = {t, axis};
  }
  return face;
}

double RayPosition::exit(const CellBox& box) const { return faceOf(box).t; }

bool RayPosition::leave(const CellBox& box) {
  const Face face = faceOf(box);
  t_ = std::max(t_, face.t);
  // Along the other axes the ray is still within the box, whatever rounding says.
  cell_ = glm::clamp(glm::ivec3(point()), glm::max(box.low, glm::ivec3(0)), glm::min(box.high, lastCell_));
  cell_[face.axis] = ray_.direction[face.axis] > 0 ? box.high[face.axis] + 1 : box.low[face.axis] - 1;
  return cell_[face.axis] >= 0 && cell_[face.axis] <= lastCell_[face.axis];
}

RayStart startOf(GridView<const float> level, const GridRay& ray) {
  RayStart start{clipToBox(ray, level.size), false, {}};
  if (!start.clip) return start;
  const RayPosition position(ray, level.size, start.clip->begin);
  start.inside = interpolate(level, position.point(), position.cell()) > 0;
  if (start.inside && start.clip->entryAxis >= 0) start.cap = position.point();
  return start;
}

std::optional<glm::dvec3> foundAtEnd(const RayStart& start, const RayPosition& position) {
  return start.inside ? std::optional(position.at(start.clip->end)) : std::nullopt;
}

bool isMixed(GridView<const float> level, glm::ivec3 cell) {
  constexpr int kCorners = 8;
  int inside = 0;
  for (int c = 0; c < kCorners; ++c) inside += level(cell.x + (c & 1), cell.y + ((c >> 1) & 1), cell.z + (c >> 2)) > 0;
  return inside != 0 && inside != kCorners;
}

bool isBeyondSurface(GridView<const float> level, glm::ivec3 cell, bool startsInside) {
  return (level(cell.x, cell.y, cell.z) > 0) != startsInside;
}

std::optional<glm::dvec3> surfaceInCell(GridView<const float> level, const RayPosition& position, double end,
                                        bool inside) {
  const glm::dvec3 low(position.cell());
  const auto within = [&](glm::dvec3 point) { return glm::clamp(point - low, glm::dvec3(0), glm::dvec3(1)); };
  const glm::dvec3 from = within(position.point()), to = within(position.at(end));
  const Cubic along = CellCorners(level, position.cell()).along(from, to);
  const auto share = firstRise(inside ? -along : along);
  return share ? std::optional(low + from + *share * (to - from)) : std::nullopt;
}

double interpolate(GridView<const float> field, glm::dvec3 position, glm::ivec3 cell) {
  return CellCorners(field, cell).valueAt(glm::clamp(position - glm::dvec3(cell), glm::dvec3(0), glm::dvec3(1)));
}

}  // namespace isolume::bench
