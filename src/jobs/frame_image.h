// A drawn frame as the channels of an image file.
#pragma once

#include <cstddef>

#include "raymarch/renderer.h"
#include "src/io/image.h"
#include "src/jobs/lighting.h"
#include "src/jobs/render_job.h"

namespace isolume {

/// R G B, then A unless the file is a PNG with an opaque background, then the layers asked for: ambient.Y (openness) or
/// irradiance.R .G .B (E / pi of all lights), normal.X .Y .Z, bent.X .Y .Z (the mean open direction, unit) and cone.Y
/// (radians), thickness.Y (world units), position.X .Y .Z, Z. Where nothing is hit, bent, cone and thickness are 0. No
/// metadata.
Image imageOf(const Frame& frame, const RenderJob& job, const SweptLighting& lighting);

/// What a frame takes in memory.
std::size_t frameBytes(const Frame& frame);

}  // namespace isolume
