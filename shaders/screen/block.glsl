// The uniforms of the screen-space passes.
#include "shared/screen_block.h"

layout(std140, binding = 1) uniform ScreenBlock { ScreenUniforms screen; };
