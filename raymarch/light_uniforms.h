// The uniform block of the light fields as a C++ struct, from the same text as in GLSL.
#pragma once

#include <glm/vec4.hpp>

namespace isolume::shader {

using glm::vec4;
#include "shaders/shared/light_uniforms.h"

// std140: two arrays of vec4.
static_assert(sizeof(LightUniforms) == 2 * kMostLightFields * 16);

}  // namespace isolume::shader
