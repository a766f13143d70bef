#include "tests/bench/rays/shader_march.h"

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

#include "raymarch/clearance.h"

namespace isolume::bench {
namespace glsl {
using namespace glm;
using uint = unsigned int;
#include "shaders/lib/camera_ray.glsl"
#include "shaders/lib/cell_cubic.glsl"
#include "shaders/lib/clearance.glsl"
#include "shaders/lib/ray_box.glsl"
#include "shaders/shared/beam_block.h"
#include "shaders/shared/clearance_code.h"

// As in the march shaders.
struct Hit {
  bool found;
  vec3 position;
  int capAxis;
};

// The names that the text of the shader refers to, with the swizzles that it uses.
struct Shader {
  struct {
    struct {
      ivec3 xyz;
    } gridSize;
  } frame;
  struct {
    vec2 xy{0};
  } gl_FragCoord;
  struct BeamTexture {
  } beamTexture;
  struct Texel {
    float r;
  };
  // No beams: a start before every ray's own.
  Texel texelFetch(BeamTexture, ivec2, int) const { return {-std::numeric_limits<float>::max()}; }

  const float* level;
  const std::uint8_t* clearances;
  int steps = 0, solves = 0;

  // cell.glsl without its textures.
  struct ClearanceMap {
    Walk walk;
  };
  static ClearanceMap clearanceMap(Walk walk) { return {walk}; }

  // Beyond the grid the texture repeats its edge, and the ray ends.
  uint cellClearance(const ClearanceMap& map, vec3 cell) {
    const ivec3 cells = frame.gridSize.xyz - 1;
    const ivec3 turned(gridCell(map.walk, cell));
    const ivec3 at = clamp(turned, ivec3(0), cells - 1);
    steps += at == turned ? 1 : 0;
    return clearances[(static_cast<std::size_t>(at.z) * cells.y + at.y) * static_cast<std::size_t>(cells.x) + at.x];
  }

  Cubic levelAlongRay(vec3 cellAt, vec3 origin, vec3 direction, float start) {
    ++solves;
    const ivec3 cell(cellAt);
    const std::ptrdiff_t strideY = frame.gridSize.xyz.x, strideZ = strideY * frame.gridSize.xyz.y;
    const float* at = level + cell.z * strideZ + cell.y * strideY + cell.x;
    vec4 low(at[0], at[1], at[strideY], at[strideY + 1]);
    at += strideZ;
    vec4 high(at[0], at[1], at[strideY], at[strideY + 1]);
    const vec4 largest4 = max(abs(low), abs(high));
    const float largest = std::max(std::max(largest4.x, largest4.y), std::max(largest4.z, largest4.w));
    constexpr float kSmallestLevel = 1e-37f, kLargestLevel = 1e37f;  // as in cell.glsl
    const float normalise = 1.0F / std::clamp(largest, kSmallestLevel, kLargestLevel);
    const vec3 entry = clamp(origin + start * direction - vec3(cell), 0.0f, 1.0f);
    return cellCubic(low * normalise, high * normalise, entry, direction);
  }

#include "shaders/march/trace.glsl"
};

}  // namespace glsl

ShaderMarch::ShaderMarch(GridView<const float> level) : level_(level), clearance_(buildClearance(level)) {}

TracedRay ShaderMarch::trace(const shader::FrameUniforms& uniforms, glm::ivec2 pixel, glm::ivec2 size) const {
  glsl::Shader shader{};
  shader.frame.gridSize.xyz = level_.size;
  shader.level = level_.data;
  shader.clearances = clearance_.data();
  const glm::vec2 place = (glm::vec2(pixel) + 0.5F) - 0.5F * glm::vec2(size);
  const glsl::Ray ray =
      glsl::cameraRay(uniforms.planePoint, uniforms.planeX, uniforms.planeY, uniforms.eye, uniforms.scale, place);
  const glsl::Hit hit = shader.trace(ray);
  TracedRay traced;
  if (hit.found) traced.found = glm::dvec3(hit.position);
  traced.steps = shader.steps;
  traced.solves = shader.solves;
  return traced;
}

shader::FrameUniforms rayUniforms(const Camera& camera, glm::ivec2 imageSize, const GridFrame& frame,
                                  glm::ivec3 gridSize) {
  shader::FrameUniforms uniforms{};
  setRays(uniforms, camera, imageSize, frame, gridSize);
  return uniforms;
}

}  // namespace isolume::bench
