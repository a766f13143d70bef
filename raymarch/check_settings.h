// What settings a scene can be drawn with.
#pragma once

#include "renderer.h"
#include "scene_textures.h"

namespace isolume {

/// GpuError: a setting out of its range, or one that needs what the scene does not have.
void checkSettings(const RenderSettings& settings, const SceneTextures& scene);

}  // namespace isolume
