// The uniforms and the program of light fields.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "gl_objects.h"
#include "light_field.h"
#include "light_uniforms.h"
#include "view.h"

namespace isolume {

/// `colors` empty: white.
shader::LightUniforms makeLightUniforms(const std::vector<LightField>& fields, const std::vector<glm::vec3>& colors,
                                        const GridFrame& grid);

/// march_lights for that many fields, 1 to kMostLightFields: a loop of known length.
GlProgram buildLightProgram(std::size_t fields);

}  // namespace isolume
