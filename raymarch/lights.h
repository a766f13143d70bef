// The uniforms and the program of light fields.
#pragma once

#include <vector>

#include "gl_objects.h"
#include "light_field.h"
#include "light_uniforms.h"
#include "renderer.h"
#include "view.h"

namespace isolume {

shader::LightUniforms makeLightUniforms(const std::vector<LightField>& fields, const RenderSettings& settings,
                                        const GridFrame& grid);

/// march_lights for these fields, up to kMostLightFields, and suns, up to kMostSuns: loops of known length, and nothing
/// of a disc where there is none. `colored`: by a field (surface_colors.h).
GlProgram buildLightProgram(const std::vector<LightField>& fields, std::size_t suns, bool colored);

}  // namespace isolume
