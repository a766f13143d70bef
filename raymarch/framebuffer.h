// What a picture is drawn into, tile by tile: colour, normal, position + hit flag and light, all RGBA32F.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "gl_objects.h"

namespace isolume {

enum class Attachment { color, normal, position, light };

/// Pictures are drawn in tiles, so that no draw call blocks for long and no picture is larger than a texture may be.
inline constexpr int kTileWidth = 2048;
inline constexpr int kTilePixels = 1 << 20;

class Framebuffer {
 public:
  /// Makes room for a tile of that size; layers only when wanted. Keeps what is large enough.
  void reserve(glm::ivec2 size, bool layers);
  /// Binds for drawing, with the outputs that are wanted and the others discarded.
  void bind(glm::ivec2 size, bool color, bool layers) const;
  /// What the last bind() left on becomes what a pixel without a hit has, and this colour.
  void clear(glm::vec4 color) const;
  /// Copies a tile to its place in an image of that width (texels). Row 0 is the top.
  void read(Attachment attachment, glm::ivec2 tileSize, glm::vec4* destination, int imageWidth) const;

 private:
  GlFramebuffer framebuffer_;
  std::array<GlTexture, 4> textures_;
  glm::ivec2 size_{0};
  bool layers_ = false;
};

}  // namespace isolume
