#include "tests/bench/rays/picture_judge.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "sweep/parallel.h"

namespace isolume::bench {
namespace {

constexpr std::size_t kToldAtMost = 8;

double degreesBetween(glm::dvec3 a, glm::dvec3 b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

std::string text(glm::dvec3 v) { return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z); }

void append(std::vector<std::string>& to, const std::vector<std::string>& from) {
  for (const std::string& line : from)
    if (to.size() < kToldAtMost) to.push_back(line);
}

// What the renderer found at a pixel, in index space.
std::optional<glm::dvec3> foundAt(const Frame& frame, std::size_t i, glm::dvec3 scale, glm::ivec3 size) {
  if (!std::isfinite(frame.depth[i])) return std::nullopt;
  return glm::clamp(glm::dvec3(frame.position[i]) / scale, glm::dvec3(0), glm::dvec3(size - 1));
}

void measureHit(const RayJudge& judge, const GridRay& ray, glm::dvec3 found, glm::dvec3 normal, RayCounts& counts) {
  const HitQuality quality = judge.quality(ray, found);
  if (quality.cap) {
    ++counts.caps;
    return;
  }
  ++counts.hits;
  counts.tangent += quality.tangent;
  counts.distance.push_back(static_cast<float>(quality.distance));
  counts.across.push_back(static_cast<float>(quality.across));
  const glm::dvec3 smooth = judge.smoothGradient(found), cell = judge.cellGradient(found);
  if (quality.distance > kSamePlace && counts.offHit.size() < kToldAtMost) {
    const double along = glm::dot(judge.tracer().cellGradient(found), ray.direction) / glm::length(cell);
    counts.offHit.push_back(fmt::format(
        "{:.2g} voxels along the ray, {:.2g} across, at {}: the ray climbs {:.2g} of the gradient; level {:.2g} of the "
        "largest corner",
        quality.distance, quality.across, text(found), along,
        judge.tracer().levelAt(found) / judge.largestCorner(found)));
  }
  if (smooth == glm::dvec3(0) || cell == glm::dvec3(0)) {
    ++counts.flat;
    return;
  }
  const double off = degreesBetween(normal, -smooth);
  counts.normal.push_back(static_cast<float>(off));
  counts.cellNormal.push_back(static_cast<float>(degreesBetween(normal, -cell)));
  if (off > kNormalTarget && counts.offNormal.size() < kToldAtMost)
    counts.offNormal.push_back(fmt::format("{:.3f} degrees at {}, where the quotient is {} and the cell's gradient {}",
                                           off, text(found), text(smooth), text(cell)));
}

RayCounts judgeRow(const RayJudge& judge, const Frame& frame, const PixelRays& rays, int y) {
  RayCounts counts;
  for (int x = 0; x < frame.size.x; ++x) {
    const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.size.x) + static_cast<std::size_t>(x);
    const GridRay ray = pixelRay(rays, {x, y}, judge.scale());
    const auto found = foundAt(frame, i, judge.scale(), judge.tracer().level().size);
    const Verdict verdict = judge.judge(ray, found);
    ++counts.rays;
    counts.ties += verdict == Verdict::tie;
    counts.grazing += verdict == Verdict::grazing;
    counts.missed += verdict == Verdict::missed;
    counts.falseHits += verdict == Verdict::falseHit;
    if ((verdict == Verdict::missed || verdict == Verdict::falseHit) && counts.wrong.size() < kToldAtMost) {
      const auto want = judge.tracer().firstHit(ray);
      counts.wrong.push_back(fmt::format("{} at pixel {}, {}: ray {} + t {}; found {}, expected {}",
                                         verdict == Verdict::missed ? "missed" : "false hit", x, y, text(ray.origin),
                                         text(ray.direction), found ? text(*found) : "nothing",
                                         want ? text(want->position) : "nothing"));
    }
    if (found) measureHit(judge, ray, *found, glm::dvec3(frame.normal[i]), counts);
  }
  return counts;
}

}  // namespace

void RayCounts::add(const RayCounts& other) {
  rays += other.rays, hits += other.hits, caps += other.caps;
  ties += other.ties, grazing += other.grazing, missed += other.missed, falseHits += other.falseHits;
  tangent += other.tangent, flat += other.flat;
  distance.insert(distance.end(), other.distance.begin(), other.distance.end());
  across.insert(across.end(), other.across.begin(), other.across.end());
  normal.insert(normal.end(), other.normal.begin(), other.normal.end());
  cellNormal.insert(cellNormal.end(), other.cellNormal.begin(), other.cellNormal.end());
  append(offHit, other.offHit);
  append(wrong, other.wrong);
  append(offNormal, other.offNormal);
}

GridRay pixelRay(const PixelRays& rays, glm::ivec2 pixel, glm::dvec3 scale) {
  const glm::dvec2 p = glm::dvec2(pixel) + 0.5 - 0.5 * glm::dvec2(rays.size);
  GridRay ray;
  ray.origin = rays.origin + rays.originX * p.x + rays.originY * p.y;
  const glm::dvec3 direction = rays.direction + rays.directionX * p.x + rays.directionY * p.y;
  ray.direction = direction / glm::length(direction * scale);
  return ray;
}

RayCounts judgePicture(const RayJudge& judge, const Frame& frame, const PixelRays& rays) {
  std::vector<RayCounts> rows(static_cast<std::size_t>(frame.size.y));
  parallelFor(rows.size(), [&](std::size_t y) { rows[y] = judgeRow(judge, frame, rays, static_cast<int>(y)); });
  RayCounts counts;
  for (const RayCounts& row : rows) counts.add(row);
  return counts;
}

double quantile(std::vector<float>& values, double share) {
  if (values.empty()) return 0;
  const auto at = std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

}  // namespace isolume::bench
