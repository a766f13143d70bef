#include "light_sweeps.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <utility>

#include "foot_sums.h"
#include "ordinate_set.h"

namespace isolume {
namespace {

constexpr float kFull = 65535;

std::uint16_t packed(float share) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0F, 1.0F) * kFull));
}

/// Two unit vectors across a unit vector.
std::array<glm::dvec3, 2> across(glm::dvec3 axis) {
  const glm::dvec3 other = std::abs(axis.z) < 0.5 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 first = glm::normalize(glm::cross(axis, other));
  return {first, glm::cross(axis, first)};
}

}  // namespace

SweptLight lightOfFeet(const SurfaceFeet& surface, const float* values) {
  const std::size_t count = surface.count();
  SweptLight light;
  light.full = count == 0 ? 1 : *std::max_element(values, values + count);
  if (!(light.full > 0)) light.full = 1;
  std::vector<std::uint16_t> shares(count);
  forEachFoot(count, [&](std::size_t i) { shares[i] = packed(values[i] / light.full); });
  light.values = surface.spread(shares);
  return light;
}

std::vector<SurfaceLight> sweepSky(const SurfaceRays& rays, const std::vector<Ordinate>& sky, int channels) {
  const std::vector<float> sums = rays.sum(sky, channels, SurfaceRays::Count::visible);
  std::vector<SurfaceLight> lights;
  for (int c = 0; c < channels; ++c) {
    const float* light = sums.data() + static_cast<std::size_t>(c) * rays.count();
    lights.push_back({lightOfFeet(rays.surface(), light), {light, light + rays.count()}});
  }
  return lights;
}

std::vector<glm::dvec3> capDirections(glm::dvec3 axis, double radiusDegrees, int count) {
  const std::array<glm::dvec3, 2> side = across(axis);
  const double height = 1 - std::cos(glm::radians(radiusDegrees));
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - height * (i + 0.5) / count, radius = std::sqrt(std::max(1 - z * z, 0.0));
    const double angle = 2 * std::numbers::pi * i / std::numbers::phi;
    directions.push_back(radius * std::cos(angle) * side[0] + radius * std::sin(angle) * side[1] + z * axis);
  }
  return directions;
}

SurfaceLight sweepDisc(const SurfaceRays& rays, glm::dvec3 direction, double radiusDegrees, int ordinates) {
  assert(radiusDegrees > 0 && radiusDegrees <= 90 && ordinates >= 1);
  const std::vector<glm::dvec3> directions = capDirections(glm::normalize(direction), radiusDegrees, ordinates);
  std::vector<Ordinate> disc;
  for (const glm::dvec3& each : directions) disc.push_back({each});
  std::vector<float> visible = rays.sum(disc, 1, SurfaceRays::Count::visible);
  const std::vector<SurfaceFoot> feet = rays.surface().makeFeet();
  std::vector<std::uint16_t> shares(feet.size());
  std::vector<std::uint8_t> known(feet.size());
  forEachFoot(feet.size(), [&](std::size_t i) {
    float all = 0;
    for (const glm::dvec3& each : directions) all += std::max(glm::dot(feet[i].normal, glm::vec3(each)), 0.0F);
    known[i] = all > 0 ? 1 : 0;
    shares[i] = all > 0 ? packed(visible[i] / all) : 0;
    visible[i] /= static_cast<float>(ordinates);
  });
  rays.surface().fillUnknown(shares, known);
  return {{rays.surface().spread(shares, &known), 1}, std::move(visible)};
}

BentNormal bentNormal(glm::vec3 mean) {
  const float length = glm::length(mean);
  if (!(length > 0)) return {};
  return {mean / length, (1 - std::clamp(2 * length - 1, 0.0F, 1.0F)) * std::numbers::pi_v<float> / 2};
}

std::array<SurfaceField, 3> sweepBentNormals(const SurfaceRays& rays, int ordinates, glm::dmat3 worldFromAxes) {
  std::vector<Ordinate> sky;
  for (const glm::dvec3& direction : ordinateDirections(ordinates)) {
    const glm::vec3 world(worldFromAxes * direction);
    sky.push_back({direction, {world.x, world.y, world.z, 1}});
  }
  const std::vector<float> sums = rays.sum(sky, 4, SurfaceRays::Count::visible);
  const std::size_t count = rays.count();
  std::array<SurfaceField, 3> bent;
  std::vector<std::uint16_t> values(count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    forEachFoot(count, [&](std::size_t i) {
      const float open = sums[3 * count + i];
      values[i] = packed(0.5F * (1 + (open > 0 ? sums[axis * count + i] / open : 0)));
    });
    bent[axis] = rays.surface().spread(values);
  }
  return bent;
}

}  // namespace isolume
