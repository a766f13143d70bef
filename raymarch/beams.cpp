#include "beams.h"

#include <algorithm>
#include <glm/common.hpp>

#include "gl_check.h"
#include "program.h"
#include "program_variants.h"
#include "textures.h"

namespace isolume {
namespace shader {
#include "shaders/shared/beam_block.h"
}

std::vector<TileRect> liveBlocks(const std::vector<float>& starts, glm::ivec2 blocks) {
  std::vector<TileRect> rects;
  std::size_t above = 0;  // rectangles from here on were added or continued by the row above
  for (int y = 0; y < blocks.y; ++y) {
    const float* row = &starts[static_cast<std::size_t>(y) * static_cast<std::size_t>(blocks.x)];
    const auto live = [row](int x) { return row[x] < shader::kBeamMissed; };
    std::vector<TileRect> runs;
    for (int x = 0; x < blocks.x;) {
      const int begin = x;
      while (x < blocks.x && live(x)) ++x;
      if (x > begin)
        runs.push_back({shader::kBeamBlock * glm::ivec2(begin, y), shader::kBeamBlock * glm::ivec2(x, y + 1)});
      while (x < blocks.x && !live(x)) ++x;
    }
    const auto sameColumns = [](const TileRect& a, const TileRect& b) {
      return a.low.x == b.low.x && a.high.x == b.high.x;
    };
    if (std::equal(rects.begin() + static_cast<std::ptrdiff_t>(above), rects.end(), runs.begin(), runs.end(),
                   sameColumns)) {
      for (std::size_t i = above; i < rects.size(); ++i) rects[i].high.y = shader::kBeamBlock * (y + 1);
    } else {
      above = rects.size();
      rects.insert(rects.end(), runs.begin(), runs.end());
    }
  }
  return rects;
}

BeamPass::BeamPass() {
  const ProgramVariant& beam = programVariant("beam");
  program_ = buildProgram(beam.vertex, beam.fragment);
}

std::vector<TileRect> BeamPass::trace(glm::vec2 pixelOrigin, glm::ivec2 tileSize) {
  const glm::ivec2 blocks = (tileSize + shader::kBeamBlock - 1) / shader::kBeamBlock;
  if (!starts_ || blocks.x > size_.x || blocks.y > size_.y) {
    size_ = glm::max(size_, blocks);
    starts_ = makeTexture2D("beams", size_, kR32F, GL_NEAREST, nullptr);
    framebuffer_ = GlFramebuffer::create();
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, starts_.name(), 0);
    checkGl("beams");
  }
  constexpr GLint kPixelOrigin = 0;
  constexpr int kTriangle = 3;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, blocks.x, blocks.y);
  glUseProgram(program_.name());
  glProgramUniform2f(program_.name(), kPixelOrigin, pixelOrigin.x, pixelOrigin.y);
  glDrawArrays(GL_TRIANGLES, 0, kTriangle);
  std::vector<float> starts(static_cast<std::size_t>(blocks.x) * static_cast<std::size_t>(blocks.y));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, blocks.x, blocks.y, GL_RED, GL_FLOAT, starts.data());
  return liveBlocks(starts, blocks);
}

}  // namespace isolume
