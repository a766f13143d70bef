#include "plane_pass.h"

#include <algorithm>

#include "row_kernels.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// One of the two passes: planes in direction dz, from the first one that has fixed samples on.
class PlanePass {
 public:
  PlanePass(GridView<const float> level, const BitGrid& fixed, int dz, OffsetField& field)
      : level_(level),
        fixed_(fixed),
        field_(field),
        dz_(dz),
        unit_(static_cast<float>(smallestSpacing(level.spacing))),
        step_(level.spacing / smallestSpacing(level.spacing)),
        before_(level.size.x, level.size.y),
        plane_(level.size.x, level.size.y),
        columns_(level.size.y, level.size.x) {}

  // The next plane is z.
  void next(int z, Result result) {
    const glm::ivec3 size = level_.size;
    const PaddedPlane* before = hasBefore_ ? &before_ : nullptr;
    forGroups(size.y, [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        takeFromPlane(rowAt(y, z), before, static_cast<float>(-dz_) * step_.z, step_, size.x, y, plane_);
    });
    takeBothWays(plane_, step_, size.x, size.y);
    forGroups(size.x, [&](int begin, int) { transposeRows(plane_, size.y, begin, columns_); });
    takeBothWays(columns_, {step_.y, step_.x, step_.z}, size.y, size.x);
    forGroups(size.y, [&](int begin, int end) {
      transposeRows(columns_, size.x, begin, plane_);
      for (int y = begin; y < end; ++y)
        finishRow(rowAt(y, z), result, level_.data + level_.index(0, y, z), unit_, size.x, y, plane_);
    });
    std::swap(before_, plane_);
    hasBefore_ = true;
  }

 private:
  // Calls visit(begin, end) for groups of rows.
  template <class Visit>
  static void forGroups(int rows, const Visit& visit) {
    parallelFor(static_cast<std::size_t>(PaddedPlane::roundUp(rows) / kRowGroup), [&](std::size_t group) {
      const int begin = static_cast<int>(group) * kRowGroup;
      visit(begin, std::min(begin + kRowGroup, rows));
    });
  }
  static void takeBothWays(PaddedPlane& plane, glm::vec3 step, int nx, int ny) {
    takeFromRows(plane, step, nx, 1, 1, ny - 1);
    takeFromRows(plane, step, nx, ny - 2, -1, ny - 1);
  }
  FixedRow rowAt(int y, int z) const {
    FixedRow row{fixed_.row(y, z), {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      row.component[axis] = field_.component[axis].data() + level_.index(0, y, z);
    return row;
  }

  GridView<const float> level_;
  const BitGrid& fixed_;
  OffsetField& field_;
  int dz_;
  float unit_;
  glm::vec3 step_;
  PaddedPlane before_, plane_, columns_;
  bool hasBefore_ = false;
};

}  // namespace

void carryOffsets(GridView<const float> level, const BitGrid& fixed, OffsetField& field) {
  int first = 0, last = level.size.z - 1;
  while (!fixed.anyInPlane(first)) ++first;
  while (!fixed.anyInPlane(last)) --last;
  PlanePass rising(level, fixed, 1, field), falling(level, fixed, -1, field);
  // Towards each other up to the middle, then on through what the other has kept.
  const int middle = (first + last + 1) / 2;
  parallelFor(2, [&](std::size_t pass) {
    if (pass == 0) {
      for (int z = first; z < middle; ++z) rising.next(z, Result::kept);
    } else {
      for (int z = last; z >= middle; --z) falling.next(z, Result::kept);
    }
  });
  parallelFor(2, [&](std::size_t pass) {
    if (pass == 0) {
      for (int z = middle; z < level.size.z; ++z) rising.next(z, z <= last ? Result::compared : Result::alone);
    } else {
      for (int z = middle - 1; z >= 0; --z) falling.next(z, z >= first ? Result::compared : Result::alone);
    }
  });
}

}  // namespace isolume
