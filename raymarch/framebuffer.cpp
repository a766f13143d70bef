#include "framebuffer.h"

#include <fmt/format.h>

#include <glm/common.hpp>

#include "gl_check.h"
#include "gpu_error.h"
#include "textures.h"

namespace isolume {

void Framebuffer::reserve(glm::ivec2 size, bool layers) {
  if (framebuffer_ && size.x <= size_.x && size.y <= size_.y && (layers_ || !layers)) return;
  size_ = glm::max(size, size_);
  layers_ = layers_ || layers;
  framebuffer_ = GlFramebuffer::create();
  for (std::size_t i = 0; i < (layers_ ? textures_.size() : 1); ++i) {
    textures_[i] = makeTexture2D("image", size_, kRGBA32F, GL_NEAREST, nullptr);
    glNamedFramebufferTexture(framebuffer_.name(), static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i), textures_[i].name(),
                              0);
  }
  const GLenum status = glCheckNamedFramebufferStatus(framebuffer_.name(), GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw GpuError(fmt::format("image: expected a complete framebuffer of {}x{} RGBA32F, found status {:#06x}", size_.x,
                               size_.y, status));
  }
  checkGl("framebuffer");
}

void Framebuffer::bind(glm::ivec2 size, bool color, bool layers) const {
  std::array<GLenum, 4> targets{};
  for (std::size_t i = 0; i < targets.size(); ++i)
    targets[i] = static_cast<GLenum>((i == 0 ? color : layers) ? GL_COLOR_ATTACHMENT0 + i : GL_NONE);
  glNamedFramebufferDrawBuffers(framebuffer_.name(), static_cast<GLsizei>(targets.size()), targets.data());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, size.x, size.y);
}

void Framebuffer::clear(glm::vec4 color) const {
  constexpr glm::vec4 kNothing(0), kOpen(1);
  const GLuint name = framebuffer_.name();
  glClearNamedFramebufferfv(name, GL_COLOR, 0, &color[0]);
  glClearNamedFramebufferfv(name, GL_COLOR, 1, &kNothing[0]);
  glClearNamedFramebufferfv(name, GL_COLOR, 2, &kNothing[0]);
  glClearNamedFramebufferfv(name, GL_COLOR, 3, &kOpen[0]);
}

void Framebuffer::read(Attachment attachment, glm::ivec2 tileSize, glm::vec4* destination, int imageWidth) const {
  glNamedFramebufferReadBuffer(framebuffer_.name(),
                               static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + static_cast<int>(attachment)));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, imageWidth);
  glReadPixels(0, 0, tileSize.x, tileSize.y, GL_RGBA, GL_FLOAT, destination);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
}

}  // namespace isolume
