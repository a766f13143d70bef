#include "transport_sweep.h"

#include <glm/common.hpp>

#include "fixed_transport.h"
#include "sweep/ordinates/openness_sweep.h"
#include "sweep/ordinates/surface_feet.h"

namespace isolume {
namespace {

bool looksOut(const SurfaceFoot& foot, glm::ivec3 size) {
  for (int i = 0; i < kFaceCount; ++i) {
    const GridFace face = faceOf(i);
    const float out = face.side == 0 ? -1.0F : 1.0F;
    if (foot.normal[face.axis] == out && foot.position[face.axis] == static_cast<float>(placeOf(face, size)))
      return true;
  }
  return false;
}

}  // namespace

SurfaceField sweepTransport(GridView<const float> level, GridView<const float> distance,
                            const TransportOptions& options) {
  const SurfaceFeet surface(level, distance);
  const std::vector<SurfaceFoot> feet = surface.makeFeet();
  std::vector<OpenPoint> points;
  points.reserve(feet.size());
  for (const SurfaceFoot& foot : feet) points.push_back({foot.position, foot.normal});
  std::vector<float> blocked(points.size(), 0);
  if (glm::min(glm::min(level.size.x, level.size.y), level.size.z) > 1)
    blocked = transportBlocked(distance, points, options);
  for (std::size_t i = 0; i < blocked.size(); ++i)
    if (looksOut(feet[i], level.size)) blocked[i] = 0;
  return surface.spread(opennessOf(blocked));
}

}  // namespace isolume
