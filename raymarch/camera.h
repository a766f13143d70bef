// Pinhole and orthographic cameras in world space, and automatic framing of a box.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace isolume {

enum class Projection { perspective, orthographic };

/// Where the picture is taken from. World space, right-handed, y of the picture up.
struct Camera {
  glm::dvec3 eye{0, -1, 0};
  glm::dvec3 target{0};
  glm::dvec3 up{0, 0, 1};  ///< any length; not parallel to target - eye
  double rollDegrees = 0;  ///< turns the camera clockwise about its axis (the picture turns the other way)
  Projection projection = Projection::perspective;
  double fovDegrees = 30;  ///< vertical field of view, perspective; in (0, 180)
  double heightWorld = 1;  ///< height of the picture at any depth, orthographic; > 0
  double zoom = 1;         ///< magnifies the picture about its centre; > 0
};

/// Orthonormal axes of the picture: right, up, forward.
struct CameraAxes {
  glm::dvec3 right, up, forward;
};
/// std::invalid_argument, one line, if the eye is the target or `up` is parallel to the view.
CameraAxes cameraAxes(const Camera& camera);

/// How to look at something without knowing where it is. Azimuth 0 looks along +y (on LPS medical data: at the face),
/// 90 looks along -x, so that the camera moves counter-clockwise seen from above; elevation > 0 looks from above;
/// both relative to `up` = +z, or to the smallest rotation that takes +z to `up`.
struct Framing {
  double azimuthDegrees = 30;
  double elevationDegrees = 20;
  double rollDegrees = 0;
  double zoom = 1;
  double fovDegrees = 30;
  Projection projection = Projection::perspective;
  glm::dvec3 up{0, 0, 1};
};

/// The camera that sees all eight corners (world) just fit into a picture of that aspect (width / height), with a
/// margin of 5 %. The target is the centre of the corners.
Camera frameCorners(const std::array<glm::dvec3, 8>& corners, double aspect, const Framing& framing);

/// The eight world corners of an index box.
std::array<glm::dvec3, 8> boxCorners(const glm::dmat4& worldFromGrid, glm::dvec3 gridMin, glm::dvec3 gridMax);

}  // namespace isolume
