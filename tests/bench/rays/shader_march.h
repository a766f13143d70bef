// The march of the shader on the CPU: the text of shaders/march/trace.glsl itself, compiled as C++ (the way that
// shader_math_test takes the functions of shaders/lib), so that what is counted is what the shader does.
//
// Left out is the pass of beams (shaders/beam.frag), which lets the rays of a block start where all of them are still
// free: what is counted is a ray on its own. Levels are read without textures, the same numbers.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "raymarch/camera.h"
#include "raymarch/frame_uniforms.h"
#include "raymarch/view.h"
#include "sweep/grid.h"
#include "tests/bench/rays/traced_ray.h"

namespace isolume::bench {

class ShaderMarch {
 public:
  /// Borrows the level; builds the clearance. At least two samples along each axis.
  explicit ShaderMarch(GridView<const float> level);
  /// The ray of pixel (x, y) of a picture, as the shader makes it, in float.
  TracedRay trace(const shader::FrameUniforms& uniforms, glm::ivec2 pixel, glm::ivec2 size) const;

 private:
  GridView<const float> level_;
  std::vector<std::uint8_t> clearance_;
};

/// The uniforms of a picture's rays.
shader::FrameUniforms rayUniforms(const Camera& camera, glm::ivec2 imageSize, const GridFrame& frame,
                                  glm::ivec3 gridSize);

}  // namespace isolume::bench
