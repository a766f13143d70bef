#include "camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <stdexcept>

namespace isolume {
namespace {

// Share of the half picture that the framed corners may fill: the margin of 5 %.
constexpr double kFill = 0.95;
// Where the sine of the angle between `up` and the view is below this, `up` says nothing.
constexpr double kParallel = 1e-9;

// The smallest rotation that takes +z to `up`, applied to v; for up = -z half a turn about x.
glm::dvec3 rotateFromZ(glm::dvec3 up, glm::dvec3 v) {
  const glm::dvec3 to = glm::normalize(up);
  if (to.z < -1 + kParallel) return {v.x, -v.y, -v.z};
  // Rodrigues' formula with the axis z x to, whose length is the sine, and 1 + cosine in place of the division by it.
  const glm::dvec3 axis(-to.y, to.x, 0);
  const glm::dvec3 turned = glm::cross(axis, v);
  return v + turned + glm::cross(axis, turned) / (1 + to.z);
}

}  // namespace

CameraAxes cameraAxes(const Camera& camera) {
  const glm::dvec3 view = camera.target - camera.eye;
  const double distance = glm::length(view);
  if (!(distance > 0)) throw std::invalid_argument("camera: expected an eye away from the target, found them equal");
  const glm::dvec3 forward = view / distance;
  const glm::dvec3 side = glm::cross(forward, camera.up);
  if (!(glm::length(side) > kParallel * glm::length(camera.up)) || !(glm::length(camera.up) > 0)) {
    throw std::invalid_argument("camera: expected an up direction across the view, found one along it");
  }
  const glm::dvec3 right = glm::normalize(side);
  const glm::dvec3 up = glm::cross(right, forward);
  const double roll = glm::radians(camera.rollDegrees);
  return {std::cos(roll) * right - std::sin(roll) * up, std::cos(roll) * up + std::sin(roll) * right, forward};
}

std::array<glm::dvec3, 8> boxCorners(const glm::dmat4& worldFromGrid, glm::dvec3 gridMin, glm::dvec3 gridMax) {
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec4 corner((i & 1) ? gridMax.x : gridMin.x, (i & 2) ? gridMax.y : gridMin.y,
                            (i & 4) ? gridMax.z : gridMin.z, 1);
    corners[static_cast<std::size_t>(i)] = glm::dvec3(worldFromGrid * corner);
  }
  return corners;
}

Camera frameCorners(const std::array<glm::dvec3, 8>& corners, double aspect, const Framing& framing) {
  const double azimuth = glm::radians(framing.azimuthDegrees);
  const double elevation = glm::radians(framing.elevationDegrees);
  const glm::dvec3 horizontal(std::sin(azimuth), -std::cos(azimuth), 0);
  const glm::dvec3 z(0, 0, 1);

  Camera camera;
  camera.target = glm::dvec3(0);
  for (const glm::dvec3& corner : corners) camera.target += corner / static_cast<double>(corners.size());
  double radius = 0;
  for (const glm::dvec3& corner : corners) radius = std::max(radius, glm::length(corner - camera.target));
  if (!(radius > 0)) radius = 1;
  const glm::dvec3 towardsEye = rotateFromZ(framing.up, std::cos(elevation) * horizontal + std::sin(elevation) * z);
  // Perpendicular to the view at every elevation, also straight from above, where `up` itself would say nothing.
  camera.up = rotateFromZ(framing.up, std::cos(elevation) * z - std::sin(elevation) * horizontal);
  camera.rollDegrees = framing.rollDegrees;
  camera.projection = framing.projection;
  camera.fovDegrees = framing.fovDegrees;
  camera.zoom = framing.zoom;
  camera.eye = camera.target + radius * towardsEye;

  const CameraAxes axes = cameraAxes(camera);
  const double tanY = std::tan(glm::radians(framing.fovDegrees) / 2) * kFill;
  const double tanX = tanY * aspect;
  double distance = 0, halfHeight = 0;
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 offset = corner - camera.target;
    const double x = std::abs(glm::dot(offset, axes.right)), y = std::abs(glm::dot(offset, axes.up));
    distance = std::max(distance, std::max(x / tanX, y / tanY) - glm::dot(offset, axes.forward));
    halfHeight = std::max(halfHeight, std::max(y, x / aspect) / kFill);
  }
  // Orthographic: anywhere outside the box; twice the radius leaves no doubt.
  if (framing.projection == Projection::orthographic) distance = 2 * radius;
  camera.heightWorld = halfHeight > 0 ? 2 * halfHeight : 2 * radius;
  camera.eye = camera.target + (distance > 0 ? distance : radius) * towardsEye;
  return camera;
}

}  // namespace isolume
