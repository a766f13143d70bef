#include "src/jobs/camera_choice.h"

#include <fmt/core.h>

#include <glm/geometric.hpp>

#include "src/errors.h"

namespace isolume {
namespace {

/// Below this sine of the angle between them, `up` and the view axis count as parallel: the picture's axes would be
/// rounding errors.
constexpr double kLeastSine = 1e-6;

bool parallel(glm::dvec3 a, glm::dvec3 b) {
  return glm::length(glm::cross(a, b)) <= kLeastSine * glm::length(a) * glm::length(b);
}

std::string text(glm::dvec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

constexpr glm::dvec3 kDefaultUp{0, 0, 1};

void checkPlaced(const CameraRequest& request) {
  if (request.azimuth || request.elevation)
    throw UsageError(fmt::format("{}: expected angles or a place for the camera, found it with --eye and --target",
                                 request.azimuth ? "--azimuth" : "--elevation"));
  if (!request.eye || !request.target)
    throw UsageError(
        fmt::format("{}: expected --eye and --target together, found it alone", request.eye ? "--eye" : "--target"));
  const glm::dvec3 axis = *request.target - *request.eye;
  if (!(glm::length(axis) > 0))
    throw UsageError(fmt::format("--target: expected a place other than --eye, found {}", text(*request.target)));
  const glm::dvec3 up = request.up.value_or(kDefaultUp);
  if (parallel(axis, up))
    throw UsageError(fmt::format("--up: expected a direction across the view axis, found {}{}", text(up),
                                 request.up ? "" : " (the default)"));
  if (request.projection == Projection::orthographic && !request.height)
    throw UsageError("--height: expected with --projection orthographic and --eye, found none");
}

}  // namespace

void checkCamera(const CameraRequest& request) {
  const bool placed = request.eye || request.target;
  if (request.up && !(glm::length(*request.up) > 0))
    throw UsageError(fmt::format("--up: expected a direction, found {}", text(*request.up)));
  if (request.projection == Projection::orthographic && request.fov)
    throw UsageError("--fov: expected --projection perspective, found orthographic");
  if (request.height && (!placed || request.projection != Projection::orthographic))
    throw UsageError("--height: expected only with --projection orthographic and --eye");
  if (placed) checkPlaced(request);
}

Camera chooseCamera(const CameraRequest& request, const std::array<glm::dvec3, 8>& corners, double aspect) {
  const Framing defaults;
  if (!request.eye)
    return frameCorners(corners, aspect,
                        {.azimuthDegrees = request.azimuth.value_or(defaults.azimuthDegrees),
                         .elevationDegrees = request.elevation.value_or(defaults.elevationDegrees),
                         .rollDegrees = request.roll.value_or(defaults.rollDegrees),
                         .zoom = request.zoom,
                         .fovDegrees = request.fov.value_or(defaults.fovDegrees),
                         .projection = request.projection,
                         .up = request.up.value_or(kDefaultUp)});
  Camera camera;
  camera.eye = *request.eye;
  camera.target = *request.target;
  camera.up = request.up.value_or(kDefaultUp);
  camera.rollDegrees = request.roll.value_or(defaults.rollDegrees);
  camera.projection = request.projection;
  camera.fovDegrees = request.fov.value_or(defaults.fovDegrees);
  camera.heightWorld = request.height.value_or(camera.heightWorld);
  camera.zoom = request.zoom;
  return camera;
}

std::string cameraOptions(const Camera& camera) {
  const std::string lens = camera.projection == Projection::perspective
                               ? fmt::format("--projection perspective --fov {}", camera.fovDegrees)
                               : fmt::format("--projection orthographic --height {}", camera.heightWorld);
  return fmt::format("--eye {} --target {} --up {} --roll {} --zoom {} {}", text(camera.eye), text(camera.target),
                     text(camera.up), camera.rollDegrees, camera.zoom, lens);
}

}  // namespace isolume
