// Traced pixels as the channels of an image file, in the conventions of `isolume render --layers all`.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "raymarch/camera.h"
#include "raymarch/view.h"
#include "src/io/image.h"
#include "src/jobs/provenance.h"
#include "src/jobs/reference_job.h"

namespace isolume {

/// An image of the whole picture as if nothing were hit: colour is the background, ambient and translucent 1, other
/// estimates 0, their errors 0, normal 0, position NaN, Z +inf. Channels: R G B A, those of channelNames(), each also
/// as "stderr." and its name, then normal.X .Y .Z, position.X .Y .Z, Z.
Image emptyReferenceImage(const ReferenceJob& job);

/// Writes what was hit within the rectangle. Colour = albedo * light, linear: the estimate of ambient, direct,
/// irradiance or translucent; of `bent`, which is no light, the cone in units of the open one.
void storePixels(Image& image, const ReferenceJob& job, const PixelRect& rect,
                 const std::vector<ReferencePixel>& pixels, const GridFrame& frame, const Camera& camera);

/// As renderProvenance(), without GL. `environmentChecksum` is that of the map's file, or "".
Provenance referenceProvenance(const ReferenceJob& job, const Surface& surface, const Camera& camera,
                               const std::string& checksums, const std::string& environmentChecksum);

/// Their names, for checkImageTarget().
std::vector<std::string> referenceChannelNames(const ReferenceJob& job);

}  // namespace isolume
