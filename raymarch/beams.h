// The pass before the march: one beam per block of pixels, and the rectangles of blocks that are worth drawing.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "gl_objects.h"

namespace isolume {

/// Pixels [low, high) of a tile.
struct TileRect {
  glm::ivec2 low{0}, high{0};
};

/// Rectangles that together cover each block with `starts` below kBeamMissed once and no other: runs of a row, joined
/// with the same run of the row before. `starts`: row-major, one per block.
std::vector<TileRect> liveBlocks(const std::vector<float>& starts, glm::ivec2 blocks);

class BeamPass {
 public:
  BeamPass();
  /// Traces the beams of a tile; the caller has bound the frame's uniforms, the clearance and a vertex array.
  /// Afterwards texture() holds their starts, and the result is what remains to be drawn, with coordinates that may
  /// reach past the tile by less than a block. 4 bytes per block of kBeamBlock^2 pixels. Waits for the GPU.
  std::vector<TileRect> trace(glm::vec2 pixelOrigin, glm::ivec2 tileSize);
  GLuint texture() const { return starts_.name(); }

 private:
  GlProgram program_;
  GlFramebuffer framebuffer_;
  GlTexture starts_;
  glm::ivec2 size_{0};  // blocks that starts_ has room for
};

}  // namespace isolume
