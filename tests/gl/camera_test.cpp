#include "raymarch/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

namespace isolume {
namespace {

std::array<glm::dvec3, 8> box() { return boxCorners(glm::dmat4(1), {-1, -2, 5}, {3, 4, 6}); }

// Largest |x| and |y| of the corners in the picture, in half pictures.
glm::dvec2 pictureExtent(const Camera& camera, double aspect) {
  const CameraAxes axes = cameraAxes(camera);
  glm::dvec2 extent(0);
  for (const glm::dvec3& corner : box()) {
    const glm::dvec3 offset = corner - camera.eye;
    const double depth = glm::dot(offset, axes.forward);
    EXPECT_GT(depth, 0);
    const double half = camera.projection == Projection::perspective
                            ? depth * std::tan(glm::radians(camera.fovDegrees) / 2)
                            : camera.heightWorld / 2;
    extent.x = std::max(extent.x, std::abs(glm::dot(offset, axes.right)) / (half * aspect));
    extent.y = std::max(extent.y, std::abs(glm::dot(offset, axes.up)) / half);
  }
  return extent;
}

TEST(Camera, FramedBoxJustFits) {
  // From any direction, with any roll and both projections, the corner that reaches furthest stands at 95 % of the half
  // picture (to rounding).
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    for (double azimuth = 0; azimuth < 360; azimuth += 33) {
      for (const double elevation : {-90., -40., 0., 25., 90.}) {
        for (const double aspect : {0.5, 1.0, 2.0}) {
          const Framing framing{.azimuthDegrees = azimuth,
                                .elevationDegrees = elevation,
                                .rollDegrees = azimuth / 3,
                                .projection = projection};
          const glm::dvec2 extent = pictureExtent(frameCorners(box(), aspect, framing), aspect);
          EXPECT_NEAR(std::max(extent.x, extent.y), 0.95, 1e-9) << azimuth << " " << elevation << " " << aspect;
        }
      }
    }
  }
}

void expectNear(glm::dvec3 found, glm::dvec3 expected) {
  EXPECT_LT(glm::length(found - expected), 1e-12) << found.x << " " << found.y << " " << found.z;
}

TEST(Camera, AzimuthAndElevationAreThoseOfTheHeader) {
  // Azimuth 0 looks along +y, 90 along -x; elevation 90 looks straight down with +y up; roll turns the camera
  // clockwise.
  expectNear(cameraAxes(frameCorners(box(), 1, {.azimuthDegrees = 0, .elevationDegrees = 0})).forward, {0, 1, 0});
  expectNear(cameraAxes(frameCorners(box(), 1, {.azimuthDegrees = 0, .elevationDegrees = 0})).right, {1, 0, 0});
  expectNear(cameraAxes(frameCorners(box(), 1, {.azimuthDegrees = 90, .elevationDegrees = 0})).forward, {-1, 0, 0});
  const CameraAxes above = cameraAxes(frameCorners(box(), 1, {.azimuthDegrees = 0, .elevationDegrees = 90}));
  expectNear(above.forward, {0, 0, -1});
  expectNear(above.up, {0, 1, 0});
  const CameraAxes rolled =
      cameraAxes(frameCorners(box(), 1, {.azimuthDegrees = 0, .elevationDegrees = 0, .rollDegrees = 90}));
  expectNear(rolled.up, {1, 0, 0});
  expectNear(rolled.right, {0, 0, -1});
}

TEST(Camera, UpTurnsTheWholeFraming) {
  // With up = +y the view from azimuth 0 looks along -z (the smallest rotation from z to y takes y to -z), up = -z
  // turns about x, and the axes stay orthonormal and right-handed.
  const CameraAxes y =
      cameraAxes(frameCorners(box(), 1, {.azimuthDegrees = 0, .elevationDegrees = 0, .up = {0, 2, 0}}));
  expectNear(y.forward, {0, 0, -1});
  expectNear(y.up, {0, 1, 0});
  const CameraAxes down =
      cameraAxes(frameCorners(box(), 1, {.azimuthDegrees = 0, .elevationDegrees = 0, .up = {0, 0, -1}}));
  expectNear(down.forward, {0, -1, 0});
  expectNear(down.up, {0, 0, -1});
  expectNear(glm::cross(down.right, down.up), -down.forward);
}

TEST(Camera, ContradictionsAreErrors) {
  // An eye in the target and an up direction along the view are refused.
  Camera camera;
  camera.target = camera.eye;
  EXPECT_THROW(cameraAxes(camera), std::invalid_argument);
  camera.target = camera.eye + glm::dvec3(0, 0, -3);
  EXPECT_THROW(cameraAxes(camera), std::invalid_argument);
  camera.up = glm::dvec3(0);
  EXPECT_THROW(cameraAxes(camera), std::invalid_argument);
}

}  // namespace
}  // namespace isolume
