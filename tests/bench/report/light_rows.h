// Rows of report_screen about light from the screen: what bent normals and cones cost over the same occlusion, and how
// far their light is from exact rays.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <vector>

#include "raymarch/renderer.h"
#include "src/jobs/screen_request.h"
#include "sweep/reference/reference.h"

namespace isolume::bench {

struct LitView {
  Renderer& renderer;  ///< holds what klehm11 reads of the volume (src/jobs/screen_light.h)
  const Camera& camera;
  glm::ivec2 size, timeSize;  ///< of the pictures that are judged, and of those that are timed
  std::array<glm::dvec3, 8> corners;
  ReferenceScene scene;
  const std::vector<ReferencePixel>& hits;
  double radius = 0;  ///< world units; 0: the default of render
  int samples, rays, runs;
};

/// klehm11 by every source and lookup, ssdo and env-importance under a sky of two coloured halves. Frames of a source
/// are timed in turn, one of each per run, after the plain occlusion under an even sky: "milliseconds" is the median,
/// "over_occlusion" what its ratio to the plain one exceeds 1 by. RMSE and bias of E / pi over pixels and colours, to
/// `rays` exact rays.
nlohmann::ordered_json lightRows(const LitView& view);

}  // namespace isolume::bench
