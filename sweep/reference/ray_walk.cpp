#include "sweep/reference/ray_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace isolume {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Also where the direction is so small that no double tells when the ray gets anywhere along that axis.
bool isParallel(double component) { return std::isinf(1 / component); }

}  // namespace

std::optional<RayClip> clipToBox(const GridRay& ray, glm::ivec3 size) {
  RayClip clip{ray.start, ray.end, -1, -1};
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis], high = size[axis] - 1;
    if (isParallel(ray.direction[axis])) {
      if (origin < 0 || origin > high) return std::nullopt;
      continue;
    }
    const double inverse = 1 / ray.direction[axis];
    const double toLow = -origin * inverse, toHigh = (high - origin) * inverse;
    const double enter = std::min(toLow, toHigh), leave = std::max(toLow, toHigh);
    if (enter >= clip.begin) {
      clip.begin = enter;
      clip.entryAxis = axis;
    }
    if (leave <= clip.end) {
      clip.end = leave;
      clip.exitAxis = axis;
    }
  }
  if (!(clip.begin < clip.end)) return std::nullopt;
  return clip;
}

RayWalk::RayWalk(const GridRay& ray, glm::ivec3 size, double t, int entryAxis) : t_(t), axis_(entryAxis) {
  for (int i = 0; i < 3; ++i) {
    origin_[i] = ray.origin[i];
    direction_[i] = ray.direction[i];
    const bool parallel = isParallel(direction_[i]);
    // No plane of the grid is below 0, so that a parallel ray meets them all at (plane + 1) * inf.
    planeOrigin_[i] = parallel ? -1 : origin_[i];
    inverse_[i] = parallel ? kInfinity : 1 / direction_[i];
    upper_[i] = inverse_[i] > 0 ? 1 : 0;
    cells_[i] = size[i] - 1;
    const double along = std::clamp(origin_[i] + t * direction_[i], 0.0, static_cast<double>(cells_[i]));
    // On a face the upper cell: a ray that goes down leaves it with its first step, at the same t.
    cell_[i] = static_cast<int>(along);
    if (i == entryAxis) cell_[i] = upper_[i] != 0 ? 0 : cells_[i] - 1;
    cell_[i] = std::clamp(cell_[i], 0, cells_[i] - 1);
  }
}

}  // namespace isolume
