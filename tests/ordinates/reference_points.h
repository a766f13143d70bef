// Points of a surface where sweeps are compared with the reference.
#pragma once

#include <cmath>
#include <vector>

#include "support/random_numbers.h"
#include "sweep/level.h"
#include "sweep/reference/reference.h"
#include "volumes/scenes.h"

namespace isolume::test {

/// The level of a sample scene, solid below 0.
inline Grid<float> sceneLevel(const char* name, int size) {
  Grid<float> level = sampleScene(*findScene(name), size);
  makeLevel(level.view(), 0, Inside::below);
  return level;
}

/// Where random rays from outside the solid, within the grid (a cube), first meet its isosurface; none on caps.
inline std::vector<ShadedPoint> randomSurfacePoints(const SurfaceTracer& tracer, std::size_t count) {
  RandomNumbers numbers(17);
  std::vector<ShadedPoint> points;
  while (points.size() < count) {
    const glm::dvec3 origin = numbers.inCube() * (tracer.level().size.x - 1.0), direction = numbers.direction();
    if (tracer.levelAt(origin) > 0) continue;
    const auto hit = tracer.firstHit({origin, direction});
    if (!hit || hit->capAxis >= 0) continue;
    points.push_back({*hit, shadingNormal(tracer, *hit, ReferenceNormals::data, -direction)});
  }
  return points;
}

inline double rmsDifference(const std::vector<double>& one, const std::vector<double>& other) {
  double sum = 0;
  for (std::size_t i = 0; i < one.size(); ++i) sum += (one[i] - other[i]) * (one[i] - other[i]);
  return std::sqrt(sum / static_cast<double>(one.size()));
}

}  // namespace isolume::test
