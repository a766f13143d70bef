// A world camera as rays in index space, worked out in double: the GPU never sees world coordinates.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "camera.h"
#include "frame_uniforms.h"

namespace isolume {

/// How index space lies in the world: worldFromGrid = rotation (or reflection) * spacing, then translation.
struct GridFrame {
  glm::dmat4 worldFromGrid{1};
  glm::dmat4 gridFromWorld{1};
  glm::dmat3 worldFromAxes{1};  ///< orthonormal: directions along the grid's axes to the world
  glm::dvec3 spacing{1};
  double smallestSpacing = 1;
};
/// GpuError unless the columns are finite, not 0 and orthogonal (to 1e-6 of their lengths).
GridFrame makeGridFrame(const glm::dmat4& worldFromGrid);

/// Fills the members that tell the rays: planePoint, planeX, planeY, eye, scale. The plane faces the camera at the
/// depth of the grid's centre, or nearer to the eye than that but never closer than the grid's radius.
void setRays(shader::FrameUniforms& uniforms, const Camera& camera, glm::ivec2 imageSize, const GridFrame& frame,
             glm::ivec3 gridSize);

/// Sub-pixel offset of anti-aliasing sample i, in [-1/2, 1/2)^2; sample 0 is the centre of the pixel. The R2 sequence
/// of [Roberts18]: any first n are evenly spread.
glm::vec2 sampleOffset(int i);

}  // namespace isolume
