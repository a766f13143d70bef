#include "tests/bench/rays/sphere_tracers.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "sweep/reference/cell_cubic.h"
#include "sweep/reference/ray_walk.h"

namespace isolume::bench {
namespace {

/// Where a ray is: never back in t, and in a cell known by integers, as the shader's.
class Position {
 public:
  Position(const GridRay& ray, glm::ivec3 size, double t) : ray_(ray), lastCell_(size - 2), t_(t) { locate(); }

  double t() const { return t_; }
  glm::ivec3 cell() const { return cell_; }
  glm::dvec3 point() const { return at(t_); }
  glm::dvec3 at(double t) const {
    return glm::clamp(ray_.origin + t * ray_.direction, glm::dvec3(0), glm::dvec3(lastCell_ + 1));
  }

  /// To a parameter within the box.
  void goTo(double t) {
    t_ = t;
    locate();
  }
  /// Parameter at which the ray leaves the cell.
  double exit() const {
    int axis;
    return exit(axis);
  }
  /// Into the next cell; false if that is out of the grid.
  bool leaveCell() {
    int axis;
    t_ = std::max(t_, exit(axis));
    cell_[axis] += ray_.direction[axis] > 0 ? 1 : -1;
    return cell_[axis] >= 0 && cell_[axis] <= lastCell_[axis];
  }

 private:
  void locate() { cell_ = glm::clamp(glm::ivec3(glm::floor(point())), glm::ivec3(0), lastCell_); }
  double exit(int& axis) const {
    double leave = std::numeric_limits<double>::infinity();
    axis = 0;
    for (int i = 0; i < 3; ++i) {
      if (ray_.direction[i] == 0) continue;
      const double face = cell_[i] + (ray_.direction[i] > 0 ? 1 : 0);
      const double t = (face - ray_.origin[i]) / ray_.direction[i];
      if (t < leave) leave = t, axis = i;
    }
    return leave;
  }

  const GridRay& ray_;
  glm::ivec3 lastCell_;
  glm::ivec3 cell_{0};
  double t_;
};

bool isMixed(GridView<const float> level, glm::ivec3 cell) {
  constexpr int kCorners = 8;
  int inside = 0;
  for (int c = 0; c < kCorners; ++c) inside += level(cell.x + (c & 1), cell.y + ((c >> 1) & 1), cell.z + (c >> 2)) > 0;
  return inside != 0 && inside != kCorners;
}

/// The beginning that all have in common: the part of the ray within the box, and the side on which it starts.
struct Start {
  std::optional<RayClip> clip;
  bool inside = false;
  std::optional<glm::dvec3> cap;  ///< the ray ends where it begins
};

Start startOf(GridView<const float> level, const GridRay& ray) {
  Start start{clipToBox(ray, level.size), false, {}};
  if (!start.clip) return start;
  const Position position(ray, level.size, start.clip->begin);
  start.inside = interpolate(level, position.point(), position.cell()) > 0;
  if (start.inside && start.clip->entryAxis >= 0) start.cap = position.point();
  return start;
}

// A ray that found no surface: from inside it sees the cap from behind.
std::optional<glm::dvec3> atEnd(const Start& start, const Position& position) {
  return start.inside ? std::optional(position.at(start.clip->end)) : std::nullopt;
}

}  // namespace

double interpolate(GridView<const float> field, glm::dvec3 position, glm::ivec3 cell) {
  return CellCorners(field, cell).valueAt(glm::clamp(position - glm::dvec3(cell), glm::dvec3(0), glm::dvec3(1)));
}

TracedRay traceRaw(GridView<const float> level, GridView<const float> distance, const GridRay& ray) {
  TracedRay traced;
  const Start start = startOf(level, ray);
  if (!start.clip) return traced;
  traced.found = start.cap;
  if (start.cap) return traced;
  Position position(ray, level.size, start.clip->begin);
  for (; traced.steps < kRawSteps; ++traced.steps) {
    const double signedDistance = interpolate(distance, position.point(), position.cell());
    const double left = start.inside ? -signedDistance : signedDistance;
    if (left < kRawHit) {
      traced.found = position.point();
      return traced;
    }
    if (!(position.t() + left < start.clip->end)) break;
    position.goTo(position.t() + left);
  }
  traced.found = atEnd(start, position);
  return traced;
}

PointBound fieldPointBound(GridView<const float> distance, FieldBound bound) {
  return [=](glm::dvec3 position, glm::ivec3 cell) {
    return bound(static_cast<float>(std::abs(interpolate(distance, position, cell))));
  };
}

PointBound cellPointBound(GridView<const float> cells) {
  return [=](glm::dvec3, glm::ivec3 cell) { return cells(cell.x, cell.y, cell.z); };
}

TracedRay traceCertified(GridView<const float> level, const PointBound& bound, const GridRay& ray, double omega) {
  TracedRay traced;
  const Start start = startOf(level, ray);
  if (!start.clip) return traced;
  traced.found = start.cap;
  if (start.cap) return traced;
  Position position(ray, level.size, start.clip->begin);
  double freeUntil = position.t();  // certified up to here
  bool relaxed = false;             // the last step went beyond that
  for (;;) {
    ++traced.steps;
    const double radius = bound(position.point(), position.cell());
    if (relaxed && position.t() - std::max(radius, 0.0) > freeUntil) {
      relaxed = false;
      omega = 1;
      position.goTo(freeUntil);
      continue;
    }
    const double leave = position.exit();
    if (radius > leave - position.t()) {
      freeUntil = position.t() + radius;
      if (!(freeUntil < start.clip->end)) break;
      const double next = position.t() + omega * radius;
      relaxed = omega > 1 && next < start.clip->end;
      position.goTo(relaxed ? next : freeUntil);
      continue;
    }
    relaxed = false;
    if (isMixed(level, position.cell())) {
      ++traced.solves;
      const glm::dvec3 low(position.cell());
      const glm::dvec3 from = glm::clamp(position.point() - low, glm::dvec3(0), glm::dvec3(1));
      const double end = std::min(leave, start.clip->end);
      const glm::dvec3 to = glm::clamp(position.at(end) - low, glm::dvec3(0), glm::dvec3(1));
      const Cubic along = CellCorners(level, position.cell()).along(from, to);
      if (const auto share = firstRise(start.inside ? -along : along)) {
        traced.found = low + from + *share * (to - from);
        return traced;
      }
    }
    if (!(leave < start.clip->end) || !position.leaveCell()) break;
    freeUntil = position.t();
  }
  traced.found = atEnd(start, position);
  return traced;
}

}  // namespace isolume::bench
