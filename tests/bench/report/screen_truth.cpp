#include "tests/bench/report/screen_truth.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>

#include "src/jobs/reference_job.h"
#include "sweep/parallel.h"
#include "sweep/reference/directions.h"
#include "sweep/reference/low_discrepancy.h"

namespace isolume::bench {
namespace {

using Sample = std::function<double(const ShadedPoint& point, std::uint64_t key, std::uint32_t index)>;

/// Mean of a sample over each pixel's points.
std::vector<double> meanPicture(const std::vector<ReferencePixel>& hits, int samples, const Sample& sample) {
  std::vector<double> means(hits.size(), std::numeric_limits<double>::quiet_NaN());
  parallelFor(hits.size(), [&](std::size_t i) {
    if (!hits[i].hit) return;
    double sum = 0;
    for (int index = 0; index < samples; ++index)
      sum += sample(hits[i].point, mixKey(0, i), static_cast<std::uint32_t>(index));
    means[i] = sum / samples;
  });
  return means;
}

std::vector<double> opennessPicture(const ReferenceScene& scene, const std::vector<ReferencePixel>& hits,
                                    const IntegrandSettings& settings, int rays) {
  return meanPicture(hits, rays, [&](const ShadedPoint& point, std::uint64_t key, std::uint32_t index) {
    return sampleIntegrand(scene, settings, point, key, index)[0];
  });
}

/// How far its ray gets, in radii, at most 1.
double sampleDirections(const ReferenceScene& scene, double radius, const ShadedPoint& point, glm::dvec2 u) {
  const glm::dvec3 direction = frameAbout(point.normal) * hemisphereDirection(u);
  const GridRay ray{point.hit.position, direction / scene.tracer.level().spacing, 0, radius};
  const std::optional<SurfacePoint> met = scene.tracer.nextHit(ray, point.hit);
  return met ? met->t / radius : 1;
}

/// Uniform in the ball, or in its half above the tangent plane.
double sampleBall(const ReferenceScene& scene, double radius, bool half, const ShadedPoint& point, glm::dvec2 u,
                  double v) {
  glm::dvec3 direction = hemisphereDirection(half ? u : glm::dvec2(2 * u.x, u.y));  // heights 1 - u.x, from 1 to -1
  const glm::dvec3 offset = radius * std::cbrt(v) * (frameAbout(point.normal) * direction);
  const GridView<const float> level = scene.tracer.level();
  const glm::dvec3 position = point.hit.position + offset / level.spacing;
  const glm::dvec3 high(level.size - 1);
  const bool within = std::min({position.x, position.y, position.z}) >= 0 && position.x <= high.x &&
                      position.y <= high.y && position.z <= high.z;
  return within && scene.tracer.levelAt(position) > 0 ? 0 : 1;
}

}  // namespace

ScreenTruth screenTruth(const ScreenOcclusion& settings) {
  switch (settings.estimator) {
    case ScreenEstimator::crytek:
      return {ScreenIntegral::ball};
    case ScreenEstimator::hbao:
      return {ScreenIntegral::directions};
    case ScreenEstimator::loosPoint:
    case ScreenEstimator::loosLine:
    case ScreenEstimator::loosArea:
      return {settings.clampedToTangent ? ScreenIntegral::halfBall : ScreenIntegral::ball};
    case ScreenEstimator::klehm11:
      if (settings.bentFrom == BentSource::crytek3d) return {ScreenIntegral::halfBall};
      return {settings.bentFrom == BentSource::hbao ? ScreenIntegral::directions : ScreenIntegral::openDirections};
    case ScreenEstimator::gtao:
    case ScreenEstimator::bitmask:
    case ScreenEstimator::envImportance:
      return {ScreenIntegral::membership, Membership::classical};
    case ScreenEstimator::ssdo:
      return {ScreenIntegral::membership, Membership::linear};
    case ScreenEstimator::gpuDisk:
      return {ScreenIntegral::membership, Membership::quartic};
    case ScreenEstimator::szirmayVolumetric:
      return {ScreenIntegral::membership, Membership::volumetric};
    default:
      return {ScreenIntegral::membership, settings.membership};
  }
}

std::string screenTruthName(const ScreenTruth& truth) {
  switch (truth.integral) {
    case ScreenIntegral::membership:
      return membershipName(truth.membership);
    case ScreenIntegral::directions:
      return "linear, no cosine";
    case ScreenIntegral::openDirections:
      return "classical, no cosine";
    case ScreenIntegral::ball:
      return "ball";
    case ScreenIntegral::halfBall:
      return "half ball";
  }
  return {};
}

std::vector<double> truthPicture(const ReferenceScene& scene, const std::vector<ReferencePixel>& hits,
                                 const ScreenTruth& truth, double radiusWorld, int rays) {
  if (truth.integral == ScreenIntegral::membership) {
    IntegrandSettings settings;
    settings.radiusWorld = radiusWorld;
    settings.membership = truth.membership;
    return opennessPicture(scene, hits, settings, rays);
  }
  return meanPicture(hits, rays, [&](const ShadedPoint& point, std::uint64_t key, std::uint32_t index) {
    const glm::dvec2 u = scrambledSobol(key, 0, index);
    if (truth.integral == ScreenIntegral::directions) return sampleDirections(scene, radiusWorld, point, u);
    if (truth.integral == ScreenIntegral::openDirections)
      return sampleDirections(scene, radiusWorld, point, u) < 1 ? 0.0 : 1.0;
    return sampleBall(scene, radiusWorld, truth.integral == ScreenIntegral::halfBall, point, u,
                      scrambledSobol(key, 1, index).x);
  });
}

std::vector<double> ambientPicture(const ReferenceScene& scene, const std::vector<ReferencePixel>& hits, int rays) {
  return opennessPicture(scene, hits, {}, rays);
}

}  // namespace isolume::bench
