// The tables of geometry terms on the GPU, each made when it is first asked for.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "gl_objects.h"
#include "sweep/octants/geometry_terms.h"

namespace isolume {

class GeometryTextures {
 public:
  using Pair = std::array<GlTexture, 2>;

  /// RGBA32F, octants 0 to 3 and 4 to 7.
  const Pair& of(GeometryTerm term);

  /// Those of the front divided by what an open plane gives, read `offset` voxels above it, on a grid of that spacing
  /// (sweep/octants/open_plane.h). The last are kept.
  const Pair& dividedByOpenPlane(glm::dvec3 spacing, float offset);

 private:
  std::array<Pair, 2> tables_;  // by term
  Pair divided_;
  glm::dvec3 spacing_{0};  // of divided_, as the next
  float offset_ = 0;
};

}  // namespace isolume
