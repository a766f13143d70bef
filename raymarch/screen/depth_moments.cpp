#include "raymarch/screen/depth_moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "raymarch/gl_check.h"
#include "raymarch/gpu_error.h"

namespace isolume {

void DepthMoments::reserve(glm::ivec2 size) {
  if (texture_ && size_ == size) return;
  const auto levels = std::bit_width(static_cast<unsigned>(std::max(size.x, size.y)));
  texture_ = GlTexture::create(GL_TEXTURE_2D);
  glTextureStorage2D(texture_.name(), static_cast<GLsizei>(levels), GL_RG32F, size.x, size.y);
  if (glGetError() != GL_NO_ERROR)
    throw GpuError(
        fmt::format("depth moments: expected memory for {}x{} RG32F with levels, found none", size.x, size.y));
  glTextureParameteri(texture_.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTextureParameteri(texture_.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTextureParameteri(texture_.name(), axis, GL_CLAMP_TO_EDGE);
  framebuffer_ = GlFramebuffer::create();
  glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, texture_.name(), 0);
  size_ = size;
  checkGl("depth moments");
}

}  // namespace isolume
