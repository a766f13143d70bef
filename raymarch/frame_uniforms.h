// The uniform block of the march shader as a C++ struct, from the same text as in GLSL.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>

namespace isolume::shader {

using glm::ivec4;
using glm::vec4;
#include "shaders/shared/frame_uniforms.h"

// std140: nine members of 16 bytes each.
static_assert(sizeof(FrameUniforms) == 9 * 16);
static_assert(offsetof(FrameUniforms, eye) == 3 * 16);
static_assert(offsetof(FrameUniforms, background) == 6 * 16);
static_assert(offsetof(FrameUniforms, gridSize) == 7 * 16);
static_assert(offsetof(FrameUniforms, modes) == 8 * 16);

}  // namespace isolume::shader
