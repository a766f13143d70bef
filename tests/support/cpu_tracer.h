// A slow ray tracer in double for comparison with pictures: shares no code and no method with the shaders. It visits
// every cell along the ray, takes the cubic from four samples of the trilinear interpolant, and finds the first root by
// subdividing its Bernstein form.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "raymarch/camera.h"
#include "sweep/grid.h"

namespace isolume::test {

/// Index space; the direction has any length.
struct IndexRay {
  glm::dvec3 origin, direction;
};

/// The ray through a point of the picture: pixel (0.5, 0.5) is the centre of the top left one.
IndexRay pixelRay(const Camera& camera, glm::ivec2 imageSize, glm::dvec2 pixel, const glm::dmat4& worldFromGrid);

struct TracedHit {
  double t = 0;            ///< along IndexRay::direction
  glm::dvec3 position{0};  ///< index space
  int capAxis = -1;        ///< axis of the face of the box that cuts the solid there, or -1
};

/// First point of { level > 0 } within the box of the samples along a ray that starts outside the solid.
std::optional<TracedHit> traceLevel(GridView<const float> level, const IndexRay& ray);

/// The trilinear interpolant, and its gradient by differences one sample to each side (one-sided at the border), both
/// at a point of index space; the gradient per unit of the grid's spacing.
double levelAt(GridView<const float> level, glm::dvec3 position);
glm::dvec3 gradientAt(GridView<const float> level, glm::dvec3 position);

}  // namespace isolume::test
