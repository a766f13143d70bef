// A ray's way through the cells of a grid, in index space: from cell to cell or over aligned cubes of cells.
//
// The point where the ray leaves a cell is worked out once, put exactly onto the face and clamped to it, and is also
// the point where it enters the next: the segments of successive cells join bit for bit, so that nothing slips between
// two cells, at edges and corners either. [Amanatides87], but with every plane's parameter from the plane itself: no
// error accumulates.
#pragma once

#include <algorithm>
#include <glm/vec3.hpp>
#include <optional>

#include "sweep/reference/grid_ray.h"

namespace isolume {

/// The part of a ray within the box [0, size - 1].
struct RayClip {
  double begin = 0, end = 0;  ///< begin < end
  int entryAxis = -1;         ///< axis of the face through which it enters at `begin`; -1: it starts within the box
  int exitAxis = -1;          ///< axis of the face through which it leaves at `end`; -1: it ends within the box
};
/// Nothing if the ray misses the box or only touches it in a point. A ray that starts on a face and goes inward enters
/// through it.
std::optional<RayClip> clipToBox(const GridRay& ray, glm::ivec3 size);

/// Where a ray is: its parameter, and the cell that it goes into from there. No index below is known at run time only,
/// and the steps are inline, so that a loop over cells keeps the walk in registers.
class RayWalk {
 public:
  /// At parameter t, where the ray is within the box; entryAxis as of RayClip.
  RayWalk(const GridRay& ray, glm::ivec3 size, double t, int entryAxis);

  double t() const { return t_; }
  glm::ivec3 cell() const { return {cell_[0], cell_[1], cell_[2]}; }
  /// The point at t: within the closed cell, and exactly on the face that the last step went through.
  glm::dvec3 point() const { return pointIn(cell(), false); }
  /// The same point, seen from the cell that leaveCell() came from: the same bits.
  glm::dvec3 exitPoint(glm::ivec3 from) const { return pointIn(from, true); }

  /// Goes on to where the ray leaves the cell, never back in t. False if that is out of the grid.
  bool leaveCell();
  /// The same for the aligned cube of that side (a power of two) around the cell.
  bool leaveCube(int side);

 private:
  glm::dvec3 pointIn(glm::ivec3 cell, bool leaving) const;
  void findExit(int side);

  double origin_[3], direction_[3];
  double planeOrigin_[3], inverse_[3];  ///< plane i is met at (plane - planeOrigin) * inverse: +inf where parallel
  int upper_[3];                        ///< 1 where the ray leaves a cell through its upper face, else 0
  int cells_[3];
  int cell_[3];
  double t_;
  int axis_;  ///< of the face that the last step went through, or -1
};

inline glm::dvec3 RayWalk::pointIn(glm::ivec3 cell, bool leaving) const {
  glm::dvec3 point;
  for (int i = 0; i < 3; ++i) {
    const double low = cell[i], high = low + 1, along = origin_[i] + t_ * direction_[i];
    const double clamped = std::min(std::max(along, low), high);
    point[i] = i != axis_ ? clamped : (upper_[i] != 0) == leaving ? high : low;
  }
  return point;
}

// Where the ray leaves the cube, in t_ and axis_.
inline void RayWalk::findExit(int side) {
  double meets[3];
  for (int i = 0; i < 3; ++i) meets[i] = ((cell_[i] & -side) + side * upper_[i] - planeOrigin_[i]) * inverse_[i];
  const double nearest = std::min(meets[0], meets[1]);
  axis_ = meets[1] < meets[0] ? 1 : 0;
  axis_ = meets[2] < nearest ? 2 : axis_;
  t_ = std::max(t_, std::min(nearest, meets[2]));
}

inline bool RayWalk::leaveCell() {
  findExit(1);
  bool inGrid = true;
  for (int i = 0; i < 3; ++i) {
    cell_[i] += i == axis_ ? 2 * upper_[i] - 1 : 0;
    inGrid &= static_cast<unsigned>(cell_[i]) < static_cast<unsigned>(cells_[i]);
  }
  return inGrid;
}

inline bool RayWalk::leaveCube(int side) {
  if (side == 1) return leaveCell();
  findExit(side);
  bool inGrid = true;
  for (int i = 0; i < 3; ++i) {
    const int first = cell_[i] & -side, last = first + side - 1;
    const int along = static_cast<int>(origin_[i] + t_ * direction_[i]);
    const int beyond = upper_[i] != 0 ? last + 1 : first - 1;
    // A ray within the upper face of the box stays in the last cells.
    cell_[i] = i == axis_ ? beyond : std::min(std::max(along, first), std::min(last, cells_[i] - 1));
    inGrid &= static_cast<unsigned>(cell_[i]) < static_cast<unsigned>(cells_[i]);
  }
  return inGrid;
}

}  // namespace isolume
