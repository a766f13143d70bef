#include "plane_pass.h"

#include <algorithm>
#include <cstring>

#include "row_kernels.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

class PlanePass {
 public:
  explicit PlanePass(OffsetField& field)
      : field_(field),
        size_(field.component[0].size()),
        step_(field.component[0].view().spacing / smallestSpacing(field.component[0].view().spacing)),
        before_(size_.x, size_.y),
        plane_(size_.x, size_.y),
        copy_(size_.x, size_.y) {}

  // Planes in direction dz; `dz` is also minus the step to the plane before.
  void run(int dz) {
    for (int i = 0; i < size_.z; ++i) {
      onPlane(dz > 0 ? i : size_.z - 1 - i, i == 0 ? 0 : dz);
      std::swap(before_, plane_);
    }
  }

 private:
  void onPlane(int z, int dz) {
    const std::size_t groups = static_cast<std::size_t>(PaddedPlane::roundUp(size_.y) / kRowGroup);
    parallelFor(groups, [&](std::size_t group) {
      for (int y = static_cast<int>(group) * kRowGroup; y < rowEnd(group); ++y) {
        moveRow(z, y, true);
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
    parallelFor(groups, [&](std::size_t group) {
      takeAlongRows(copy_, step_.x, size_.x, static_cast<int>(group) * kRowGroup, plane_);
      for (int y = static_cast<int>(group) * kRowGroup; y < rowEnd(group); ++y) moveRow(z, y, false);
    });
  }

  int rowEnd(std::size_t group) const { return std::min(static_cast<int>(group + 1) * kRowGroup, size_.y); }

  // Row y of plane z from the field into the scratch plane, or back.
  void moveRow(int z, int y, bool load) {
    const std::size_t at = field_.component[0].view().index(0, y, z);
    for (int axis = 0; axis < 3; ++axis) {
      float* row = field_.component[static_cast<std::size_t>(axis)].data() + at;
      float* scratch = plane_.row(axis, y);
      std::memcpy(load ? scratch : row, load ? row : scratch, sizeof(float) * static_cast<std::size_t>(size_.x));
    }
  }

  OffsetField& field_;
  glm::ivec3 size_;
  glm::vec3 step_;
  PaddedPlane before_, plane_, copy_;
};

}  // namespace

void carryOffsets(OffsetField& field) {
  PlanePass pass(field);
  pass.run(1);
  pass.run(-1);
}

}  // namespace isolume
