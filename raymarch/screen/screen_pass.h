// Pictures whose light comes from the screen: G-buffer, estimator, filter, composite.
//
// The passes go over the whole picture, since estimators look at neighbours: per pixel 84 B with layers, or colours by a field (depth 4,
// normal 16, light 2 x 16, colour 16, position 16) and 32 B more for light from the neighbourhood, all on the GPU, and
// no picture is larger than a texture may be. Draws are cut into bands so that none blocks for long.
//
// Each anti-aliasing sample is a picture of its own, moved by a part of a pixel, with a G-buffer, light and filter of
// its own; the colours are averaged. Layers, and the light in them, are those of the centres of the pixels. Nothing is
// compiled or allocated before the first draw() that needs it.
#pragma once

#include <glm/vec4.hpp>
#include <map>
#include <string>
#include <vector>

#include "raymarch/beams.h"
#include "raymarch/frame_uniforms.h"
#include "raymarch/gl_objects.h"
#include "raymarch/renderer.h"
#include "raymarch/scene_textures.h"
#include "raymarch/screen/depth_moments.h"
#include "raymarch/screen/screen_plan.h"
#include "raymarch/screen/sky_textures.h"

namespace isolume {

/// Where a picture goes, row-major, top row first: colour (sum of the samples), and for layers the normal (grid axes),
/// the position (index space; w: 1 where something is hit) and the light, which is the openness.
struct ScreenTarget {
  std::vector<glm::vec4>&color, &normals, &positions, &lights;
};

class ScreenPass {
 public:
  ScreenPass();
  /// The caller has bound the uniforms of the frame, the textures of the scene and a vertex array. GpuError for
  /// settings that cannot be drawn.
  void draw(const Camera& camera, const RenderSettings& settings, const shader::FrameUniforms& frame,
            const SceneTextures& scene, BeamPass& beams, const ScreenTarget& target);
  /// What belongs to the scene alone is made anew.
  void forgetScene() { heights_ = GlTexture(); }

 private:
  struct Images {
    GlTexture depth, normal, position, light, filtered, color;
    GlTexture radiance, filteredRadiance;  ///< with light from the neighbourhood alone
    GlFramebuffer gbuffer, estimate, filter, composite, indirect, filterIndirect;
    glm::ivec2 size{0};
  };

  const GlProgram& program(const std::string& name);
  void reserve(glm::ivec2 size, bool positions);
  void makeHeights(const SceneTextures& scene);
  void drawGBuffer(glm::vec2 sampleOffset, BeamPass& beams, const SceneTextures& scene);
  void drawPass(const std::string& name, const GlFramebuffer& target, glm::ivec2 size);
  void makeMoments();
  void reserveIndirect();
  void setSamples(const std::vector<glm::vec4>& samples);
  /// After the light, which is bound; leaves its own texture bound.
  void drawIndirect(const ScreenOcclusion& settings, bool filtered);
  /// Light of one sample; returns the image that holds it, one of two.
  const GlTexture& drawLight(const ScreenOcclusion& settings, const ScreenPlan& plan, bool filtered,
                             const SceneTextures& scene);

  std::map<std::string, GlProgram> programs_;
  bool colored_ = false;  ///< whether they read the colours of the scene; of one pass always the same
  GlBuffer screenBuffer_ = GlBuffer::create(), sampleBuffer_ = GlBuffer::create();
  GlTexture heights_;  ///< R32F, one texel per column: 4 B each
  Images images_;
  DepthMoments moments_;  ///< of loos10-area
  SkyTextures sky_;
};

}  // namespace isolume
