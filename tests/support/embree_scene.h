// Rays against a triangle mesh by Embree: a tracer that shares nothing with ours. Float arithmetic, so a distance is
// good to about 1e-6 of the coordinates.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "sweep/reference/grid_ray.h"

namespace isolume::test {

class EmbreeScene {
 public:
  /// Three corners per triangle, as of tetraMesh(). Both sides of a triangle are hit; no ray slips between two that
  /// share an edge.
  explicit EmbreeScene(const std::vector<glm::vec3>& triangles);
  ~EmbreeScene();

  /// Smallest t in (ray.start, ray.end) at which the ray meets the mesh. A ray that starts on the mesh must start a
  /// little off it (ray.start > 0, or a moved origin): triangles have no memory of where a ray came from.
  std::optional<double> firstHit(const GridRay& ray) const;
  bool isBlocked(const GridRay& ray) const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace isolume::test
