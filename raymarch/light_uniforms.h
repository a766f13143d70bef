// The uniform block of the light fields as a C++ struct, from the same text as in GLSL.
#pragma once

#include <glm/vec4.hpp>

namespace isolume::shader {

using glm::vec4;
#include "shaders/shared/light_uniforms.h"

// std140: vec4 and arrays of it.
static_assert(sizeof(LightUniforms) == (2 * kMostLightFields + 2 * kMostSuns + 1) * 16);

}  // namespace isolume::shader
