// The texture behind loos10-area: depth and squared depth of the picture, averaged over ever larger squares.
#pragma once

#include <glm/vec2.hpp>

#include "raymarch/gl_objects.h"

namespace isolume {

/// 8 B per pixel of the picture and a third more for the levels.
class DepthMoments {
 public:
  /// Makes room; what has that size is kept.
  void reserve(glm::ivec2 size);
  /// Where level 0 is drawn to.
  const GlFramebuffer& target() const { return framebuffer_; }
  /// Averages level 0 down to one texel.
  void average() const { glGenerateTextureMipmap(texture_.name()); }
  GLuint texture() const { return texture_.name(); }

 private:
  GlTexture texture_;
  GlFramebuffer framebuffer_;
  glm::ivec2 size_{0};
};

}  // namespace isolume
