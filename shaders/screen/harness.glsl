// Everything before an estimator: an entry includes this, one estimator, a function `float estimate(Shaded)` that calls
// it, and screen/main.glsl.
#include "screen/block.glsl"
#include "shared/frame_uniforms.h"

layout(std140, binding = 0) uniform FrameBlock { FrameUniforms frame; };

#include "screen/view.glsl"
#include "screen/shaded.glsl"
#include "screen/neighbourhood.glsl"
#include "screen/characteristic.glsl"
