#include "tests/bench/rays/sphere_tracers.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/rays/ray_position.h"

namespace isolume::bench {
TracedRay traceRaw(GridView<const float> level, GridView<const float> distance, const GridRay& ray) {
  TracedRay traced;
  const RayStart start = startOf(level, ray);
  if (!start.clip) return traced;
  traced.found = start.cap;
  if (start.cap) return traced;
  RayPosition position(ray, level.size, start.clip->begin);
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
  traced.found = foundAtEnd(start, position);
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
  const RayStart start = startOf(level, ray);
  if (!start.clip) return traced;
  traced.found = start.cap;
  if (start.cap) return traced;
  RayPosition position(ray, level.size, start.clip->begin);
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
      traced.found = surfaceInCell(level, position, std::min(leave, start.clip->end), start.inside);
      if (traced.found) return traced;
    } else if (isBeyondSurface(level, position.cell(), start.inside)) {
      traced.found = position.point();
      return traced;
    }
    if (!(leave < start.clip->end) || !position.leave({position.cell(), position.cell()})) break;
    freeUntil = position.t();
  }
  traced.found = foundAtEnd(start, position);
  return traced;
}

}  // namespace isolume::bench
