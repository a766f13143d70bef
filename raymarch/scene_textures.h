// The textures of one scene on the GPU.
#pragma once

#include "gl_objects.h"
#include "renderer.h"
#include "surface_colors.h"
#include "view.h"

namespace isolume {

struct SceneTextures {
  GlTexture level;                      ///< R32F, samples, as slices
  GlTexture clearance;                  ///< R8UI, cells; clearance.h
  GlTexture distance;                   ///< R16F, samples, in smallest spacings, as slices
  std::array<GlTexture, 2> octants;     ///< RGBA8, samples; absent where the scene has none
  std::vector<GlTexture> lights;        ///< R16, samples and caps, as slices
  std::vector<LightField> lightFields;  ///< of the same; borrow nothing any more
  SurfaceColors colors;
  glm::ivec3 size{0};
  GridFrame frame;

  bool hasOctants() const { return static_cast<bool>(octants[0]); }
};

/// GpuError: fewer than two samples along an axis, grids of different sizes, or more than the GPU takes.
SceneTextures uploadScene(const SceneFields& fields);

}  // namespace isolume
