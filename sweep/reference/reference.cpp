#include "sweep/reference/reference.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "sweep/parallel.h"
#include "sweep/reference/low_discrepancy.h"

namespace isolume {
namespace {

/// Replicates stay so long that their sequences stratify at all, however lax the target.
constexpr int kLeastAdaptiveRays = 4 * kReplicates;

int firstRays(const SamplingSettings& sampling) {
  if (!sampling.targetError) return sampling.rays;
  const double wanted =
      std::min(std::ceil(1 / *sampling.targetError / kReplicates) * kReplicates, static_cast<double>(sampling.maxRays));
  return std::min(std::max(static_cast<int>(wanted), kLeastAdaptiveRays), sampling.maxRays);
}

ReferencePixel tracePixel(const ReferenceScene& scene, const PixelRays& rays, glm::ivec2 pixel,
                          const IntegrandSettings& settings, const SamplingSettings& sampling) {
  const glm::dvec2 p = glm::dvec2(pixel) + 0.5 - 0.5 * glm::dvec2(rays.size);
  const GridRay ray{rays.origin + rays.originX * p.x + rays.originY * p.y,
                    rays.direction + rays.directionX * p.x + rays.directionY * p.y};
  ReferencePixel result;
  const std::optional<SurfacePoint> hit = scene.tracer.firstHit(ray);
  if (!hit) return result;
  result.hit = true;
  const glm::dvec3 viewer = -glm::normalize(ray.direction * scene.tracer.level().spacing);
  result.point = {*hit, shadingNormal(scene.tracer, *hit, settings.normals, viewer)};
  const std::uint64_t stream = mixKey(static_cast<std::uint64_t>(pixel.x), static_cast<std::uint64_t>(pixel.y));
  result.estimate = estimateAt(scene, settings, sampling, result.point, stream);
  return result;
}

}  // namespace

PointEstimate estimateAt(const ReferenceScene& scene, const IntegrandSettings& settings,
                         const SamplingSettings& sampling, const ShadedPoint& point, std::uint64_t stream) {
  PointEstimate result;
  if (isExact(settings.integrand)) {
    result.rays = 1;
    result.channels.value = shownChannels(settings.integrand, sampleIntegrand(scene, settings, point, 0, 0));
    return result;
  }
  const std::uint64_t pointKey = mixKey(mixBits(sampling.seed), stream);
  std::array<Channels, kReplicates> sums{};
  int done = 0, wanted = firstRays(sampling) / kReplicates;  // per replicate
  for (;;) {
    assert(wanted > 0);
    for (int replicate = 0; replicate < kReplicates; ++replicate) {
      const std::uint64_t key = mixKey(pointKey, static_cast<std::uint64_t>(replicate));
      for (int i = done; i < wanted; ++i)
        add(sums[replicate], sampleIntegrand(scene, settings, point, key, static_cast<std::uint32_t>(i)));
    }
    done = wanted;
    result.rays = done * kReplicates;
    result.channels =
        estimateOf(sums, done, [&settings](const Channels& mean) { return shownChannels(settings.integrand, mean); });
    if (!sampling.targetError) return result;
    const Channels& errors = result.channels.standardError;
    result.converged = *std::max_element(errors.begin(), errors.end()) * kStopMargin <= *sampling.targetError;
    if (result.converged || result.rays >= sampling.maxRays) return result;
    wanted = std::min(2 * done, sampling.maxRays / kReplicates);
  }
}

std::vector<ReferencePixel> traceReference(const ReferenceScene& scene, const PixelRays& rays, const PixelRect& rect,
                                           const IntegrandSettings& settings, const SamplingSettings& sampling) {
  constexpr int kRun = 16;  // pixels per piece of work: some ten thousand rays
  const glm::ivec2 size = rect.end - rect.begin;
  const int runsPerRow = (size.x + kRun - 1) / kRun;
  std::vector<ReferencePixel> pixels(static_cast<std::size_t>(size.x) * size.y);
  parallelFor(static_cast<std::size_t>(runsPerRow) * size.y, [&](std::size_t run) {
    const int y = static_cast<int>(run / runsPerRow), first = static_cast<int>(run % runsPerRow) * kRun;
    for (int x = first; x < std::min(first + kRun, size.x); ++x)
      pixels[static_cast<std::size_t>(y) * size.x + x] =
          tracePixel(scene, rays, rect.begin + glm::ivec2(x, y), settings, sampling);
  });
  return pixels;
}

}  // namespace isolume
