// A drawn frame as the channels of an image file.
#pragma once

#include <cstddef>

#include "raymarch/renderer.h"
#include "src/io/image.h"
#include "src/jobs/render_job.h"

namespace isolume {

/// R G B, then A unless the file is a PNG with an opaque background, then the layers asked for: ambient.Y,
/// normal.X .Y .Z, position.X .Y .Z, Z. No metadata.
Image imageOf(const Frame& frame, const RenderJob& job);

/// What a frame takes in memory.
std::size_t frameBytes(const Frame& frame);

}  // namespace isolume
