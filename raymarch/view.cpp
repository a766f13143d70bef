#include "view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

#include "gpu_error.h"
#include "sweep/grid.h"

namespace isolume {
namespace {

void checkCamera(const Camera& camera) {
  const auto require = [](bool good, const char* what, double found) {
    if (!good) throw std::invalid_argument(fmt::format("camera: expected {}, found {}", what, found));
  };
  require(camera.zoom > 0 && std::isfinite(camera.zoom), "a zoom above 0", camera.zoom);
  if (camera.projection == Projection::perspective) {
    require(camera.fovDegrees > 0 && camera.fovDegrees < 180, "a field of view in (0, 180) degrees", camera.fovDegrees);
  } else {
    require(camera.heightWorld > 0 && std::isfinite(camera.heightWorld), "a height above 0", camera.heightWorld);
  }
}

}  // namespace

GridFrame makeGridFrame(const glm::dmat4& worldFromGrid) {
  constexpr double kShearTolerance = 1e-6;
  GridFrame frame;
  frame.worldFromGrid = worldFromGrid;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 column(worldFromGrid[axis]);
    frame.spacing[axis] = glm::length(column);
    if (!(frame.spacing[axis] > 0) || !std::isfinite(frame.spacing[axis])) {
      throw GpuError(fmt::format("worldFromGrid: expected a finite spacing above 0 along axis {}, found {}", axis,
                                 frame.spacing[axis]));
    }
    frame.worldFromAxes[axis] = column / frame.spacing[axis];
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double cosine = glm::dot(frame.worldFromAxes[axis], frame.worldFromAxes[(axis + 1) % 3]);
    if (std::abs(cosine) > kShearTolerance) {
      throw GpuError(fmt::format("worldFromGrid: expected orthogonal axes, found axes {} and {} with cosine {:.3g}",
                                 axis, (axis + 1) % 3, cosine));
    }
  }
  frame.gridFromWorld = glm::inverse(worldFromGrid);
  frame.smallestSpacing = smallestSpacing(frame.spacing);
  return frame;
}

void setRays(shader::FrameUniforms& uniforms, const Camera& camera, glm::ivec2 imageSize, const GridFrame& frame,
             glm::ivec3 gridSize) {
  checkCamera(camera);
  const CameraAxes axes = cameraAxes(camera);
  const glm::dvec3 high = glm::dvec3(gridSize - 1);
  const glm::dvec3 centre(frame.worldFromGrid * glm::dvec4(0.5 * high, 1));
  const double radius = 0.5 * glm::length(high * frame.spacing);
  const double depth = std::max(glm::dot(centre - camera.eye, axes.forward), radius);

  const bool perspective = camera.projection == Projection::perspective;
  const double halfHeight =
      (perspective ? depth * std::tan(glm::radians(camera.fovDegrees) / 2) : camera.heightWorld / 2) / camera.zoom;
  const double pixel = 2 * halfHeight / imageSize.y;

  const glm::dmat3 gridFromWorld(frame.gridFromWorld);
  const glm::dvec3 planePoint(frame.gridFromWorld * glm::dvec4(camera.eye + depth * axes.forward, 1));
  const glm::dvec3 eye =
      perspective ? glm::dvec3(frame.gridFromWorld * glm::dvec4(camera.eye, 1)) : -(gridFromWorld * axes.forward);
  uniforms.planePoint = glm::dvec4(planePoint, depth / frame.smallestSpacing);
  uniforms.planeX = glm::dvec4(gridFromWorld * (axes.right * pixel), 0);
  uniforms.planeY = glm::dvec4(gridFromWorld * (axes.up * -pixel), 0);
  uniforms.eye = glm::dvec4(eye, perspective ? 1 : 0);
  uniforms.scale = glm::dvec4(frame.spacing / frame.smallestSpacing, 0);
}

glm::vec2 sampleOffset(int i) {
  // 1 / g and 1 / g^2 with g^3 = g + 1, the plastic number.
  constexpr double kX = 0.7548776662466927, kY = 0.5698402909980532;
  const auto offset = [i](double step) {
    const double turned = 0.5 + i * step;
    return static_cast<float>(turned - std::floor(turned) - 0.5);
  };
  return {offset(kX), offset(kY)};
}

}  // namespace isolume
