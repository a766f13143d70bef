#include "tests/bench/rays/ray_judge.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "tests/reference/brute_force.h"

namespace isolume::bench {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// Voxels: a float position near 500 is good to 3e-5.
constexpr double kOnBorder = 1e-4;

}  // namespace

RayJudge::RayJudge(GridView<const float> level) : tracer_(level), high_(level.size - 1) {
  scale_ = level.spacing / smallestSpacing(level.spacing);
  const glm::dvec3 sides = high_ * scale_;
  sideways_ = kSidewaysRounding * std::max({sides.x, sides.y, sides.z});
}

bool RayJudge::isCap(glm::dvec3 position) const {
  for (int axis = 0; axis < 3; ++axis)
    if (std::min(position[axis], high_[axis] - position[axis]) * scale_[axis] < kOnBorder) return true;
  return false;
}

HitQuality RayJudge::quality(const GridRay& ray, glm::dvec3 found) const {
  HitQuality quality;
  quality.cap = isCap(found);
  if (quality.cap) return quality;
  const double level = std::abs(tracer_.levelAt(found));
  quality.across = level > 0 ? level / glm::length(cellGradient(found)) : 0;
  const auto at = [&](double s) { return glm::clamp(found + s * ray.direction, glm::dvec3(0), high_); };
  // Newton's method on the line, which is within a few cells of the root or not near one at all.
  constexpr int kSteps = 20;
  constexpr double kNear = 0.1, kConverged = 1e-10;
  double s = 0;
  for (int step = 0; step < kSteps; ++step) {
    const double slope = glm::dot(tracer_.cellGradient(at(s)), ray.direction);
    const double move = -tracer_.levelAt(at(s)) / slope;
    if (!(std::abs(s + move) < kNear)) break;
    s += move;
    if (std::abs(move) < kConverged) {
      quality.distance = std::abs(s);
      return quality;
    }
  }
  quality.tangent = true;
  quality.distance = quality.across;
  return quality;
}

bool RayJudge::isOnSurface(const GridRay& ray, glm::dvec3 found) const {
  const double level = tracer_.levelAt(found);
  if (isCap(found) && level > 0) return true;
  // Not a NaN where level and gradient are both 0, a plateau.
  if (std::abs(level) <= kOnSurface * glm::length(cellGradient(found))) return true;
  const auto at = [&](double s) { return glm::clamp(found + s * ray.direction, glm::dvec3(0), high_); };
  return (tracer_.levelAt(at(-kOnSurface)) > 0) != (tracer_.levelAt(at(kOnSurface)) > 0);
}

double RayJudge::farthestHit(const GridRay& ray) const {
  const glm::dvec3 forward = ray.direction * scale_;
  const glm::dvec3 any = std::abs(forward.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, any)), down = glm::cross(forward, right);
  constexpr int kAround = 16;
  double farthest = 0;
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2 * M_PI * i / kAround;
    GridRay displaced = ray;
    displaced.origin += sideways_ * (std::cos(angle) * right + std::sin(angle) * down) / scale_;
    const auto hit = tracer_.firstHit(displaced);
    farthest = std::max(farthest, hit ? hit->t : kNever);
  }
  return farthest;
}

bool RayJudge::passesByRounding(const GridRay& ray, double from, double to) const {
  const auto level = tracer_.level();
  const auto span = test::boxSpan(level.size, ray);
  if (!span) return true;
  const glm::dvec3 start = ray.origin + static_cast<double>(span->begin) * ray.direction;
  const bool leaving = tracer_.levelAt(glm::clamp(start, glm::dvec3(0), high_)) > 0;
  const long double first = std::clamp<long double>(from, span->begin, span->end);
  const long double last = std::min<long double>(to - kSamePlace, span->end);
  return test::maximumBetween(level, ray, first, std::max(first, last), leaving) <= kLevelRounding;
}

double RayJudge::largestCorner(glm::dvec3 position) const {
  const auto level = tracer_.level();
  const glm::ivec3 cell = glm::clamp(glm::ivec3(position), glm::ivec3(0), level.size - 2);
  double largest = 0;
  for (int c = 0; c < 8; ++c) {
    const double corner = level(cell.x + (c & 1), cell.y + ((c >> 1) & 1), cell.z + (c >> 2));
    largest = std::max(largest, std::abs(corner));
  }
  return largest;
}

Verdict RayJudge::judge(const GridRay& ray, const std::optional<glm::dvec3>& found) const {
  const auto hit = tracer_.firstHit(ray);
  const glm::dvec3 direction = ray.direction * scale_;
  const double wanted = hit ? hit->t : kNever;
  const double got = found ? glm::dot((*found - ray.origin) * scale_, direction) : kNever;
  if (hit.has_value() == found.has_value() && (!hit || std::abs(got - wanted) <= kSamePlace)) return Verdict::agrees;
  if (found && glm::clamp(*found, glm::dvec3(0), high_) != *found) return Verdict::falseHit;
  if (found && glm::length((*found - ray.origin) * scale_ - got * direction) > kSamePlace) return Verdict::falseHit;
  if ((!found || isOnSurface(ray, *found)) && farthestHit(ray) >= got - kSamePlace) return Verdict::grazing;
  if (wanted < got) return passesByRounding(ray, wanted, got) ? Verdict::tie : Verdict::missed;
  return std::abs(tracer_.levelAt(*found)) <= kLevelRounding * largestCorner(*found) ? Verdict::tie : Verdict::falseHit;
}

}  // namespace isolume::bench
