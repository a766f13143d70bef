// The uniform blocks of the screen-space passes as C++ structs, from the same text as in GLSL.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>

#include "raymarch/camera.h"
#include "raymarch/frame_uniforms.h"
#include "raymarch/screen/screen_plan.h"
#include "raymarch/screen/sky_convolution.h"
#include "raymarch/screen/sky_draws.h"
#include "raymarch/view.h"

namespace isolume {
namespace shader {

#include "shaders/shared/screen_block.h"

// std140: members of 16 bytes each.
static_assert(sizeof(ScreenUniforms) == 11 * 16);
static_assert(offsetof(ScreenUniforms, depthRow) == 4 * 16);
static_assert(offsetof(ScreenUniforms, size) == 8 * 16);
static_assert(offsetof(ScreenUniforms, march) == 10 * 16);
static_assert(kConeAngles == isolume::kConeAngles);
static_assert(kSkyCells == isolume::kSkyCells && kCellDraws == isolume::kCellDraws);
static_assert(sizeof(ScreenSamples) == kMostScreenSamples * 16);

}  // namespace shader

/// `frame` has its rays set (view.h). Everything else is worked out in double. `sampleOffset`: of this anti-aliasing
/// sample, pixels.
shader::ScreenUniforms makeScreenUniforms(const shader::FrameUniforms& frame, const Camera& camera,
                                          const GridFrame& grid, glm::ivec2 size, glm::vec2 sampleOffset,
                                          const ScreenOcclusion& settings, const ScreenPlan& plan);

}  // namespace isolume
