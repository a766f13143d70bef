// The camera that the user asked for, in either of two ways: framed by angles, or placed in the world.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "raymarch/camera.h"

namespace isolume {

struct CameraRequest {
  std::optional<double> azimuth, elevation;  ///< degrees: frames the solid
  std::optional<glm::dvec3> eye, target;     ///< world: as placed; both or neither
  std::optional<glm::dvec3> up;
  std::optional<double> roll, fov;  ///< degrees
  std::optional<double> height;     ///< world units, orthographic with eye
  double zoom = 1;
  Projection projection = Projection::perspective;
};

/// UsageError where options exclude each other, say nothing together, or leave the camera without a direction.
void checkCamera(const CameraRequest& request);

/// `corners` as of solidCorners(), `aspect` = width / height.
Camera chooseCamera(const CameraRequest& request, const std::array<glm::dvec3, 8>& corners, double aspect);

/// The camera as options of `isolume render` that give it back to the last bit.
std::string cameraOptions(const Camera& camera);

}  // namespace isolume
