// No OpenGL error passes silently.
#pragma once

#include <string_view>

namespace isolume {

/// GpuError "<stage>: OpenGL error GL_OUT_OF_MEMORY" if any error has been raised since the last check. Called after
/// each stage (upload, frame, ...), not after each call. Clears all pending errors; names the first.
void checkGl(std::string_view stage);

}  // namespace isolume
