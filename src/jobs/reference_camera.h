// The renderer's camera as rays of the reference: the same pixel centres, worked out in double all the way.
#pragma once

#include <glm/vec2.hpp>

#include "raymarch/camera.h"
#include "raymarch/view.h"
#include "sweep/reference/reference.h"

namespace isolume {

/// Perspective rays start at the eye, orthographic ones on the plane through it, as the renderer's do. The direction's
/// length is 1 world unit along the view axis, so that the parameter of a hit is its depth.
/// std::invalid_argument for a camera without a direction (cameraAxes()).
PixelRays pixelRays(const Camera& camera, glm::ivec2 imageSize, const GridFrame& frame);

}  // namespace isolume
