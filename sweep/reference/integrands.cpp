#include "sweep/reference/integrands.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>

#include "sweep/reference/directions.h"
#include "sweep/reference/low_discrepancy.h"

namespace isolume {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// From a point of the surface along a unit direction of the axes; the parameter is the length in world units.
GridRay rayFrom(const ReferenceScene& scene, const SurfacePoint& from, glm::dvec3 direction, double end) {
  return {from.position, direction / scene.tracer.level().spacing, 0, end};
}

double visibility(const ReferenceScene& scene, const SurfacePoint& from, glm::dvec3 direction, double end = kFar) {
  return scene.tracer.isBlocked(rayFrom(scene, from, direction, end), from) ? 0 : 1;
}

/// mu of the first thing met, 1 if there is none.
double openness(const ReferenceScene& scene, const IntegrandSettings& settings, const SurfacePoint& from,
                glm::dvec3 direction) {
  if (!settings.radiusWorld) return visibility(scene, from, direction);
  const double radius = *settings.radiusWorld;
  if (settings.membership == Membership::classical) return visibility(scene, from, direction, radius);
  const std::optional<SurfacePoint> met =
      scene.tracer.nextHit(rayFrom(scene, from, direction, isLocal(settings.membership) ? radius : kFar), from);
  return met ? membershipAt(settings.membership, met->t / radius) : 1;
}

struct WeightedDirection {
  glm::dvec3 direction;  ///< axes
  double weight;         ///< (cos / pi) over the density that it was drawn with
};

/// One direction of the mixture of cosine-weighted directions and those drawn from the map.
WeightedDirection drawDirection(const ReferenceScene& scene, const Environment* environment, glm::dvec3 normal,
                                glm::dvec2 u) {
  const double drawn = environment ? environment->drawnShare() : 0;
  if (drawn == 0) return {frameAbout(normal) * cosineDirection(u), 1};
  const bool fromMap = u.x < drawn;
  u.x = fromMap ? u.x / drawn : (u.x - drawn) / (1 - drawn);
  const glm::dvec3 direction =
      fromMap ? glm::transpose(scene.worldFromAxes) * environment->draw(u) : frameAbout(normal) * cosineDirection(u);
  const double cosine = std::max(glm::dot(normal, direction), 0.0) / std::numbers::pi;
  const double mixture = (1 - drawn) * cosine + drawn * environment->density(scene.worldFromAxes * direction);
  return {direction, cosine > 0 ? cosine / mixture : 0};
}

/// E / pi along one path.
Channels samplePath(const ReferenceScene& scene, const IntegrandSettings& settings, const ShadedPoint& start,
                    std::uint64_t key, std::uint32_t index, int bounces) {
  ShadedPoint point = start;
  glm::dvec3 throughput(1);
  for (int bounce = 0;; ++bounce) {
    const auto [direction, weight] = drawDirection(scene, settings.environment, point.normal,
                                                   scrambledSobol(key, static_cast<std::uint32_t>(bounce), index));
    if (weight == 0) return {};
    throughput *= weight;
    const GridRay ray = rayFrom(scene, point.hit, direction, kFar);
    std::optional<SurfacePoint> met;
    if (bounce < bounces)
      met = scene.tracer.nextHit(ray, point.hit);
    else if (scene.tracer.isBlocked(ray, point.hit))
      return {};
    if (!met) {
      const glm::dvec3 sky =
          settings.environment ? settings.environment->radiance(scene.worldFromAxes * direction) : glm::dvec3(1);
      const glm::dvec3 light = throughput * sky;
      return {light.x, light.y, light.z, 0};
    }
    throughput *= settings.albedo;
    point = {*met, shadingNormal(scene.tracer, *met, settings.normals, -direction)};
  }
}

Channels sampleLight(const ReferenceScene& scene, const IntegrandSettings& settings, const ShadedPoint& point,
                     glm::dvec2 u) {
  glm::dvec3 direction = glm::normalize(settings.lightDirection);
  if (settings.integrand == Integrand::light) {
    const double sine = std::sin(glm::radians(settings.lightRadiusDegrees) / 2);
    direction = frameAbout(direction) * capDirection(u, 2 * sine * sine);
  }
  direction = glm::transpose(scene.worldFromAxes) * direction;
  const double visible = visibility(scene, point.hit, direction);
  return {visible, visible * std::max(glm::dot(point.normal, direction), 0.0), 0, 0};
}

Channels sampleBent(const ReferenceScene& scene, const ShadedPoint& point, glm::dvec2 u) {
  const glm::dvec3 direction = frameAbout(point.normal) * hemisphereDirection(u);
  const double visible = visibility(scene, point.hit, direction);
  const glm::dvec3 open = visible * (scene.worldFromAxes * direction);
  return {open.x, open.y, open.z, visible};
}

/// T of a way of that length inside the solid, world units.
double transmitted(const ReferenceScene& scene, double opacity, double length) {
  return std::exp(std::log1p(-opacity) * length / smallestSpacing(scene.tracer.level().spacing));
}

Channels sampleTranslucent(const ReferenceScene& scene, const IntegrandSettings& settings, const ShadedPoint& point,
                           glm::dvec2 u) {
  const glm::dvec3 outward = frameAbout(point.normal) * cosineDirection(u);
  const auto lengthInside = [&](glm::dvec3 direction) {
    return scene.tracer.lengthInside(rayFrom(scene, point.hit, direction, kFar));
  };
  const double thickness = lengthInside(-outward);
  double light = 0;
  if (settings.opacity == 1)
    light = visibility(scene, point.hit, outward) + visibility(scene, point.hit, -outward);
  else
    light =
        transmitted(scene, settings.opacity, lengthInside(outward)) + transmitted(scene, settings.opacity, thickness);
  return {light, thickness, 0, 0};
}

/// [Klehm11] Sec. 3.2 from the mean of V w and the mean of V.
Channels bentChannels(const Channels& mean) {
  const glm::dvec3 sum(mean[0], mean[1], mean[2]);
  const double length = glm::length(sum);
  if (!(length > 0)) return {};
  const double meanLength = std::min(length / mean[3], 1.0);
  const glm::dvec3 bent = sum / length;
  return {bent.x, bent.y, bent.z, (1 - std::max(0.0, 2 * meanLength - 1)) * std::numbers::pi / 2};
}

}  // namespace

glm::dvec3 shadingNormal(const SurfaceTracer& tracer, const SurfacePoint& hit, ReferenceNormals normals,
                         glm::dvec3 viewer) {
  if (hit.capAxis >= 0) {
    glm::dvec3 face(0);
    face[hit.capAxis] = hit.position[hit.capAxis] > 0.5 ? 1 : -1;  // the faces lie at 0 and at 1 or more
    return face;
  }
  const glm::dvec3 perSample =
      normals == ReferenceNormals::data ? tracer.smoothGradient(hit.position) : tracer.cellGradient(hit.position);
  const glm::dvec3 gradient = perSample / tracer.level().spacing;
  // Scaled first: the squares of denormal levels vanish.
  const double largest = std::max({std::abs(gradient.x), std::abs(gradient.y), std::abs(gradient.z)});
  return largest > 0 ? -glm::normalize(gradient / largest) : viewer;
}

Channels sampleIntegrand(const ReferenceScene& scene, const IntegrandSettings& settings, const ShadedPoint& point,
                         std::uint64_t key, std::uint32_t index) {
  switch (settings.integrand) {
    case Integrand::ambient: {
      const glm::dvec3 direction = frameAbout(point.normal) * cosineDirection(scrambledSobol(key, 0, index));
      return {openness(scene, settings, point.hit, direction), 0, 0, 0};
    }
    case Integrand::shadow:
    case Integrand::light:
      return sampleLight(scene, settings, point, scrambledSobol(key, 0, index));
    case Integrand::environment:
      return samplePath(scene, settings, point, key, index, 0);
    case Integrand::bounce:
      return samplePath(scene, settings, point, key, index, settings.bounces);
    case Integrand::bent:
      return sampleBent(scene, point, scrambledSobol(key, 0, index));
    case Integrand::translucent:
      return sampleTranslucent(scene, settings, point, scrambledSobol(key, 0, index));
  }
  return {};
}

Channels shownChannels(Integrand integrand, const Channels& mean) {
  return integrand == Integrand::bent ? bentChannels(mean) : mean;
}

std::vector<std::string> channelNames(Integrand integrand) {
  switch (integrand) {
    case Integrand::ambient:
      return {"ambient.Y"};
    case Integrand::shadow:
    case Integrand::light:
      return {"shadow.Y", "direct.Y"};
    case Integrand::environment:
    case Integrand::bounce:
      return {"irradiance.R", "irradiance.G", "irradiance.B"};
    case Integrand::bent:
      return {"bent.X", "bent.Y", "bent.Z", "cone.Y"};
    case Integrand::translucent:
      return {"translucent.Y", "thickness.Y"};
  }
  return {};
}

}  // namespace isolume
