// Ambient occlusion of a mesh by rays, with Embree.
//
// Openness = share of cosine-weighted directions that leave the scene: n = k^2 stratified directions (one in each cell
// of a k x k grid on the unit square, at the cell's centre, mapped to the disc by [Shirley97]'s concentric map and
// lifted to the hemisphere), the square turned by a random offset for every pixel ([Cranley76]). Rays start kRayOffset
// of the scene's diagonal above the hit along the normal. Normals are interpolated from those of the mesh's points.
//
// Used as Embree's manual recommends: one device with the stated threads, default build quality, flush-to-zero and
// denormals-are-zero set in every thread, coherent flag for primary rays, single rays (rtcOccluded1) for the incoherent
// rest. Pictures are the same for any number of threads.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>

#include "raymarch/camera.h"
#include "raymarch/renderer.h"
#include "tests/bench/peers/surface_mesh.h"

namespace isolume::bench {

/// Of the diagonal of the mesh's box: far above the rounding of a hit in single precision, 1e-7 of it.
inline constexpr float kRayOffset = 1e-4F;

class EmbreeOcclusion {
 public:
  /// Builds the BVH; copies the mesh.
  EmbreeOcclusion(const SurfaceMesh& mesh, int threads);
  ~EmbreeOcclusion();
  EmbreeOcclusion(const EmbreeOcclusion&) = delete;
  EmbreeOcclusion& operator=(const EmbreeOcclusion&) = delete;

  /// A perspective picture through the centres of the pixels; `rays` a square number. Fills the frame's layers as
  /// raymarch/renderer.h describes them, and the colour with the openness. std::invalid_argument for other numbers.
  Frame render(const Camera& camera, glm::ivec2 size, int rays) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

std::string embreeVersion();

}  // namespace isolume::bench
