#include "gl_check.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <string>

#include "gpu_error.h"

namespace isolume {
namespace {

std::string errorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST:
      return "GL_CONTEXT_LOST";
    default:
      return fmt::format("{:#06x}", error);
  }
}

}  // namespace

void checkGl(std::string_view stage) {
  const GLenum first = glGetError();
  if (first == GL_NO_ERROR) return;
  // A lost context reports its error for ever.
  constexpr int kMostPending = 64;
  for (int i = 0; i < kMostPending && glGetError() != GL_NO_ERROR; ++i) {
  }
  throw GpuError(fmt::format("{}: OpenGL error {}", stage, errorName(first)));
}

}  // namespace isolume
