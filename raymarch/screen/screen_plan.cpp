#include "raymarch/screen/screen_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "raymarch/screen/bent_plan.h"
#include "raymarch/screen/point_sets.h"
#include "raymarch/screen/repulsion_sets.h"

namespace isolume {
namespace {

constexpr double kCube = 3, kFourth = 4;  // degrees of the volumetric and of the quartic membership

double degreeOf(Membership membership) {
  switch (membership) {
    case Membership::squareRoot:
      return 0.5;
    case Membership::linear:
      return 1;
    case Membership::volumetric:
      return kCube;
    case Membership::quartic:
      return kFourth;
    default:
      return 0;  // classical: all of the measure lies at R
  }
}

struct Weighed {
  glm::dvec3 point;
  double weight;
};

/// [SzirmayGpu] Sec. 4.1, 4.2: (4/3 or 2/3) mu'(r) / r^2 cos+ / n.
Weighed ballPoint(glm::dvec3 p, const ScreenOcclusion& settings) {
  const bool half = settings.estimator == ScreenEstimator::gpuHemisphere;
  if (half) p.z = std::abs(p.z);
  const double r = glm::length(p);
  const double density = (half ? 2 : 4) / 3.0;  // the volume of the (half) ball over pi
  return {p, density * membershipSlope(settings.membership, r) / (r * r) * std::max(p.z / r, 0.0) / settings.samples};
}

/// [SzirmayGpu] Sec. 4.4: (1/6) mu'(r) / r^2 / n, over 2 * integral of mu, its value in the open.
Weighed tangentPoint(glm::dvec3 p, const ScreenOcclusion& settings) {
  p = 0.5 * p + glm::dvec3(0, 0, 0.5);
  const double square = glm::dot(p, p);
  constexpr double kVolumeOverPi = 1.0 / 6;
  const double open = 2 / (degreeOf(settings.membership) + 1);
  return {p,
          kVolumeOverPi * membershipSlope(settings.membership, std::sqrt(square)) / square / settings.samples / open};
}

/// [SzirmayGpu] Sec. 4.3 draws its numbers independently, [Szirmay10] Eq. 5 takes Poisson-disk samples.
std::vector<Weighed> importancePoints(const ScreenOcclusion& settings) {
  const bool independent = settings.estimator == ScreenEstimator::gpuImportance;
  const std::vector<glm::dvec2> disk = independent ? randomDisk(settings.samples) : poissonDisk(settings.samples);
  const std::vector<double> strata = independent ? randomNumbers(settings.samples) : shuffledStrata(settings.samples);
  std::vector<Weighed> points;
  for (std::size_t i = 0; i < disk.size(); ++i) {
    const glm::dvec3 direction(disk[i], std::sqrt(1 - glm::dot(disk[i], disk[i])));
    points.push_back({membershipInverse(settings.membership, strata[i]) * direction, 1.0 / settings.samples});
  }
  return points;
}

/// [Ritschel09]: V cos dw / pi, dw = 2 pi / n, at distances that are even in [0, 1].
std::vector<Weighed> hemispherePoints(const ScreenOcclusion& settings) {
  const std::vector<glm::dvec2> disk = poissonDisk(settings.samples);
  const std::vector<double> strata = shuffledStrata(settings.samples);
  std::vector<Weighed> points;
  for (std::size_t i = 0; i < disk.size(); ++i) {
    // Lambert's map: equal areas of the disk and of the hemisphere.
    const double height = 1 - glm::dot(disk[i], disk[i]);
    const glm::dvec3 direction(disk[i] * std::sqrt(1 + height), height);
    points.push_back({strata[i] * direction, 2 * height / settings.samples});
  }
  return points;
}

std::vector<Weighed> weighedPoints(const ScreenOcclusion& settings) {
  std::vector<Weighed> points;
  switch (settings.estimator) {
    case ScreenEstimator::gpuImportance:
    case ScreenEstimator::szirmayContainment:
      return importancePoints(settings);
    case ScreenEstimator::ssdo:
      return hemispherePoints(settings);
    case ScreenEstimator::loosPoint:
      for (const WeighedPoint& each : repulsionBall(settings.samples)) {
        glm::dvec3 p = each.point;
        if (settings.clampedToTangent) p.z = std::abs(p.z);
        points.push_back({p, each.weight});
      }
      return points;
    case ScreenEstimator::crytek:
      for (const glm::dvec3& p : poissonBall(settings.samples)) points.push_back({p, 1.0 / settings.samples});
      return points;
    default:
      for (const glm::dvec3& p : poissonBall(settings.samples))
        points.push_back(settings.estimator == ScreenEstimator::gpuTangent ? tangentPoint(p, settings)
                                                                           : ballPoint(p, settings));
      return points;
  }
}

/// Where an open point gives 1, so that the weights may be scaled to that.
bool sumsToOne(ScreenEstimator estimator) {
  return estimator == ScreenEstimator::gpuSphere || estimator == ScreenEstimator::gpuHemisphere ||
         estimator == ScreenEstimator::gpuTangent || estimator == ScreenEstimator::ssdo;
}

}  // namespace

double membershipSlope(Membership membership, double r) {
  const double degree = degreeOf(membership);
  return degree * std::pow(r, degree - 1);
}

double membershipInverse(Membership membership, double share) {
  const double degree = degreeOf(membership);
  return degree > 0 ? std::pow(share, 1 / degree) : 1;
}

std::vector<glm::vec4> pointSamples(const ScreenOcclusion& settings) {
  const std::vector<Weighed> points = weighedPoints(settings);
  double sum = 0;
  for (const Weighed& each : points) sum += each.weight;
  const double scale = settings.normalisedBySamples && sumsToOne(settings.estimator) && sum > 0 ? 1 / sum : 1;
  std::vector<glm::vec4> samples;
  for (const Weighed& each : points)
    samples.emplace_back(glm::vec3(each.point), static_cast<float>(scale * each.weight));
  return samples;
}

std::vector<glm::vec4> diskSamples(const ScreenOcclusion& settings) {
  std::vector<glm::dvec4> samples;
  if (isLoos10(settings.estimator)) {
    for (const WeighedPoint& each : repulsionDisk(settings.samples)) {
      const double half = std::sqrt(1 - glm::dot(each.point, each.point));
      samples.emplace_back(each.point.x, each.point.y, half, each.weight / (2 * half));
    }
  } else {
    for (const glm::dvec2& p : poissonDisk(settings.samples)) samples.emplace_back(p, std::sqrt(1 - glm::dot(p, p)), 0);
    // [Szirmay10] Eq. 7 with R = 1: F = sum of the half chords, or 2 n / 3.
    double chords = 0;
    for (const glm::dvec4& each : samples) chords += each.z;
    const double divisor = settings.normalisedBySamples ? chords : 2.0 * settings.samples / 3;
    for (glm::dvec4& each : samples) each.w = 1 / divisor;
  }
  return {samples.begin(), samples.end()};
}

std::vector<glm::vec4> indirectSamples(const ScreenOcclusion& settings) {
  std::vector<glm::vec4> samples;
  for (const glm::dvec2& p : poissonDisk(settings.samples)) samples.emplace_back(p, 0, 0);
  return samples;
}

glm::ivec2 marchCounts(ScreenEstimator estimator, int samples) {
  const int sides = estimator == ScreenEstimator::gtao || estimator == ScreenEstimator::bitmask ? 2 : 1;
  const int directions = std::max(1, static_cast<int>(std::lround(std::sqrt(samples / sides))));
  return {directions, std::max(1, samples / (sides * directions))};
}

ScreenPlan planScreen(const ScreenOcclusion& settings) {
  switch (settings.estimator) {
    case ScreenEstimator::hbao:
      return {"screen_hbao", {}, marchCounts(settings.estimator, settings.samples), false};
    case ScreenEstimator::gtao:
      return {"screen_gtao", {}, marchCounts(settings.estimator, settings.samples), false};
    case ScreenEstimator::bitmask:
      return {"screen_bitmask", {}, marchCounts(settings.estimator, settings.samples), false};
    case ScreenEstimator::szirmayVolumetric:
      return {"screen_volumetric", diskSamples(settings), {}, false};
    case ScreenEstimator::gpuDisk:
      return {"screen_disk", diskSamples(settings), {}, false};
    case ScreenEstimator::loosArea:
      return {"screen_area", diskSamples(settings), {}, true};
    case ScreenEstimator::loosLine:
      return {"screen_line", diskSamples(settings), {}, false};
    case ScreenEstimator::klehm11:
      return planBent(settings);
    case ScreenEstimator::ssdo:
      if (!settings.sky) return {"screen_points", pointSamples(settings), {}, false};
      return {"screen_ssdo", pointSamples(settings), {}, false, false, {.radiance = true}};
    case ScreenEstimator::envImportance:
      return {"screen_importance", {}, {settings.samples, 0}, false, false, {.cones = 1, .draws = true}};
    default:
      return {"screen_points", pointSamples(settings), {}, false};
  }
}

}  // namespace isolume
