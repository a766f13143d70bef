#include "plane_pass.h"

#include <algorithm>
#include <cstring>

#include "row_kernels.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

class PlanePass {
 public:
  PlanePass(const BitGrid& fixed, OffsetField& field)
      : fixed_(fixed),
        field_(field),
        size_(field.component[0].size()),
        step_(field.component[0].view().spacing / smallestSpacing(field.component[0].view().spacing)),
        before_(size_.x, size_.y),
        plane_(size_.x, size_.y),
        copy_(size_.x, size_.y) {
    while (!fixed_.anyInPlane(firstSet_)) ++firstSet_;
  }

  // The first pass of all, upwards: nothing but the fixed samples is read from the field.
  template <class FinishRow>
  void runFirst(const FinishRow& finishRow) {
    for (int z = firstSet_; z < size_.z; ++z) nextPlane(z, z == firstSet_ ? 0 : 1, true, finishRow);
  }

  // Planes in direction dz. Those from `unsetBelow` down have no points yet. finishRow(z, y, plane) takes over a row of
  // points.
  template <class FinishRow>
  void run(int dz, int unsetBelow, const FinishRow& finishRow) {
    for (int i = 0; i < size_.z; ++i) {
      const int z = dz > 0 ? i : size_.z - 1 - i;
      nextPlane(z, i == 0 ? 0 : dz, z < unsetBelow, finishRow);
    }
  }
  int firstSet() const { return firstSet_; }

  // Row y of plane z from the scratch plane into the field.
  void storeRow(int z, int y, const PaddedPlane& plane) {
    const std::size_t at = field_.component[0].view().index(0, y, z);
    for (int axis = 0; axis < 3; ++axis)
      std::memcpy(component(axis) + at, plane.row(axis, y), sizeof(float) * static_cast<std::size_t>(size_.x));
  }

 private:
  // `dz` is also minus the step to the plane before; 0 if there is none. `fixedOnly`: nothing but the fixed samples is
  // read from the field.
  template <class FinishRow>
  void nextPlane(int z, int dz, bool fixedOnly, const FinishRow& finishRow) {
    const std::size_t groups = static_cast<std::size_t>(PaddedPlane::roundUp(size_.y) / kRowGroup);
    parallelFor(groups, [&](std::size_t group) {
      for (int y = static_cast<int>(group) * kRowGroup; y < rowEnd(group); ++y) {
        loadRow(z, y, fixedOnly);
        if (dz != 0) {
          takeFromPlane(before_, static_cast<float>(-dz) * step_.z, step_, size_.x, y, plane_, copy_);
        } else {
          for (int axis = 0; axis < 3; ++axis) std::copy_n(plane_.row(axis, y), size_.x, copy_.row(axis, y));
        }
      }
    });
    parallelFor(2, [&](std::size_t falling) {
      if (falling != 0) {
        takeFromRows(copy_, step_, size_.x, size_.y - 2, -1, size_.y - 1);
      } else {
        takeFromRows(plane_, step_, size_.x, 1, 1, size_.y - 1);
      }
    });
    parallelFor((groups + kAlongGroups - 1) / kAlongGroups, [&](std::size_t i) {
      const std::size_t first = i * kAlongGroups, end = std::min(first + kAlongGroups, groups);
      const int begin = static_cast<int>(first) * kRowGroup;
      takeAlongRows(copy_, step_.x, size_.x, begin, static_cast<int>(end - first), plane_);
      for (int y = begin; y < rowEnd(end - 1); ++y) {
        loadFixed(z, y);
        finishRow(z, y, plane_);
      }
    });
    std::swap(before_, plane_);
  }

  int rowEnd(std::size_t group) const { return std::min(static_cast<int>(group + 1) * kRowGroup, size_.y); }
  float* component(int axis) { return field_.component[static_cast<std::size_t>(axis)].data(); }

  // Row y of plane z from the field into the scratch plane.
  void loadRow(int z, int y, bool fixedOnly) {
    const std::size_t at = field_.component[0].view().index(0, y, z);
    for (int axis = 0; axis < 3; ++axis) {
      if (fixedOnly) {
        std::fill_n(plane_.row(axis, y), size_.x, axis == 0 ? kUnsetOffset : 0.0F);
      } else {
        std::memcpy(plane_.row(axis, y), component(axis) + at, sizeof(float) * static_cast<std::size_t>(size_.x));
      }
    }
    if (fixedOnly) loadFixed(z, y);
  }
  void loadFixed(int z, int y) {
    const std::size_t at = field_.component[0].view().index(0, y, z);
    forEachRun(fixed_.row(y, z), fixed_.words(), [&](int begin, int end) {
      for (int axis = 0; axis < 3; ++axis)
        std::copy(component(axis) + at + begin, component(axis) + at + end, plane_.row(axis, y) + begin);
    });
  }

  const BitGrid& fixed_;
  int firstSet_ = 0;  // the first plane with fixed samples
  OffsetField& field_;
  glm::ivec3 size_;
  glm::vec3 step_;
  PaddedPlane before_, plane_, copy_;
};

}  // namespace

void carryOffsets(GridView<const float> level, const BitGrid& fixed, int rounds, OffsetField& field) {
  PlanePass pass(fixed, field);
  const auto store = [&](int z, int y, const PaddedPlane& plane) { pass.storeRow(z, y, plane); };
  const auto unit = static_cast<float>(smallestSpacing(level.spacing));
  const auto finish = [&](int z, int y, const PaddedPlane& plane) {
    const std::size_t at = level.index(0, y, z);
    offsetsToDistance(plane.row(0, y), plane.row(1, y), plane.row(2, y), level.data + at, unit,
                      static_cast<std::size_t>(level.size.x), field.component[0].data() + at);
  };
  for (int round = 0; round < rounds; ++round) {
    const bool first = round == 0, last = round + 1 == rounds;
    if (first) {
      pass.runFirst(store);
    } else {
      pass.run(1, 0, store);
    }
    const int unsetBelow = first ? pass.firstSet() : 0;
    if (last) {
      pass.run(-1, unsetBelow, finish);
    } else {
      pass.run(-1, unsetBelow, store);
    }
  }
}

}  // namespace isolume
