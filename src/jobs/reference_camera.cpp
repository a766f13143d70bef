#include "src/jobs/reference_camera.h"

#include <cmath>
#include <glm/trigonometric.hpp>

namespace isolume {

PixelRays pixelRays(const Camera& camera, glm::ivec2 imageSize, const GridFrame& frame) {
  const CameraAxes axes = cameraAxes(camera);
  const glm::dmat3 gridFromWorld(frame.gridFromWorld);
  const bool perspective = camera.projection == Projection::perspective;
  // Of the picture: at depth 1 in perspective, at any depth otherwise.
  const double height =
      (perspective ? 2 * std::tan(glm::radians(camera.fovDegrees) / 2) : camera.heightWorld) / camera.zoom;
  const double pixel = height / imageSize.y;
  const glm::dvec3 right = gridFromWorld * (axes.right * pixel), down = gridFromWorld * (axes.up * -pixel);

  PixelRays rays;
  rays.size = imageSize;
  rays.origin = glm::dvec3(frame.gridFromWorld * glm::dvec4(camera.eye, 1));
  rays.direction = gridFromWorld * axes.forward;
  (perspective ? rays.directionX : rays.originX) = right;
  (perspective ? rays.directionY : rays.originY) = down;
  return rays;
}

}  // namespace isolume
