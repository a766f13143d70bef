#include "tests/bench/report/surface_sample.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <optional>

#include "sweep/parallel.h"
#include "sweep/reference/reference.h"
#include "tests/support/random_numbers.h"

namespace isolume::bench {
namespace {

std::vector<glm::ivec3> crossedCells(GridView<const float> level) {
  std::vector<glm::ivec3> cells;
  for (int z = 0; z + 1 < level.size.z; ++z)
    for (int y = 0; y + 1 < level.size.y; ++y)
      for (int x = 0; x + 1 < level.size.x; ++x) {
        int inside = 0;
        for (int corner = 0; corner < 8; ++corner)
          inside += level(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2)) > 0 ? 1 : 0;
        if (inside > 0 && inside < 8) cells.push_back({x, y, z});
      }
  return cells;
}

// From a point near the surface, straight at it from outside; none if it is not met close by.
std::optional<ShadedPoint> surfacePointNear(const SurfaceTracer& tracer, glm::dvec3 p) {
  constexpr double kReach = 0.7;  // voxels
  const glm::dvec3 gradient = tracer.cellGradient(p);
  const double steepness = glm::length(gradient);
  if (!(steepness > 0)) return std::nullopt;
  const glm::dvec3 normal = -gradient / steepness, foot = p + tracer.levelAt(p) / steepness * normal;
  const glm::dvec3 from = foot + kReach * normal, last(tracer.level().size - 1);
  if (glm::any(glm::lessThan(from, glm::dvec3(0))) || glm::any(glm::greaterThan(from, last))) return std::nullopt;
  if (tracer.levelAt(from) > 0) return std::nullopt;
  const auto hit = tracer.firstHit({from, -normal, 0, 2 * kReach});
  if (!hit || hit->capAxis >= 0) return std::nullopt;
  return ShadedPoint{*hit, shadingNormal(tracer, *hit, ReferenceNormals::data, normal)};
}

}  // namespace

std::vector<JudgedPoint> judgedPoints(GridView<const float> level, int count, int rays) {
  const SurfaceTracer tracer(level);
  const std::vector<glm::ivec3> cells = crossedCells(level);
  test::RandomNumbers numbers(7);
  std::vector<ShadedPoint> points;
  while (static_cast<int>(points.size()) < count) {
    const auto cell = static_cast<std::size_t>(numbers.below(static_cast<int>(cells.size())));
    if (const auto point = surfacePointNear(tracer, glm::dvec3(cells[cell]) + numbers.inCube()))
      points.push_back(*point);
  }
  std::vector<JudgedPoint> judged(points.size());
  parallelFor(points.size(), [&](std::size_t i) {
    const PointEstimate estimate = estimateAt({tracer, glm::dmat3(1)}, {}, {.rays = rays}, points[i], i);
    judged[i] = {points[i].hit.position, points[i].normal, estimate.channels.value[0]};
  });
  return judged;
}

}  // namespace isolume::bench
