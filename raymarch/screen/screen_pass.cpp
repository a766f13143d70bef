#include "raymarch/screen/screen_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "raymarch/framebuffer.h"
#include "raymarch/gl_check.h"
#include "raymarch/gpu_error.h"
#include "raymarch/program.h"
#include "raymarch/program_variants.h"
#include "raymarch/screen/screen_uniforms.h"
#include "raymarch/textures.h"
#include "raymarch/view.h"

namespace isolume {
namespace {

// Units and bindings as in the shaders.
constexpr GLuint kDepthUnit = 0, kNormalUnit = 1, kLightUnit = 2, kLevelUnit = 3, kHeightUnit = 4, kMomentUnit = 5,
                 kRadianceUnit = 6, kBeamUnit = 7, kSweptUnit = 9;
constexpr GLuint kScreenBinding = 1, kSampleBinding = 2;
constexpr int kTriangle = 3;
constexpr std::size_t kSweptFields = 4;

void checkScreen(const ScreenOcclusion& settings, const SceneTextures& scene) {
  const auto require = [](bool good, const char* what, double found) {
    if (!good) throw GpuError(fmt::format("screen-space occlusion: expected {}, found {}", what, found));
  };
  require(settings.radiusWorld > 0, "a radius above 0", settings.radiusWorld);
  require(settings.samples >= 1 && settings.samples <= kMostScreenSamples, "1 to 256 samples", settings.samples);
  require(settings.interleaving >= 1 && settings.interleaving <= kMostInterleaving, "a pattern of side 1 to 8",
          settings.interleaving);
  require(!settings.thicknessWorld || *settings.thicknessWorld > 0, "a thickness above 0",
          settings.thicknessWorld.value_or(0));
  require(!settings.secondRadius || *settings.secondRadius > 0, "a second radius above 0",
          settings.secondRadius.value_or(0));
  require(settings.steps >= 0 && settings.steps <= kMostScreenSteps, "0 to 3 steps", settings.steps);
  require(!settings.sky || readsSky(settings.estimator), "a sky with an estimator that takes one",
          static_cast<double>(settings.estimator));
  require(readsNeighbourhood(settings) || scene.lights.size() == kSweptFields, "openness and three components swept",
          static_cast<double>(scene.lights.size()));
  const std::vector<Membership> taken = takenMemberships(settings.estimator);
  const bool takes = taken.empty() || std::find(taken.begin(), taken.end(), settings.membership) != taken.end();
  require(takes, "a membership function that the estimator takes", static_cast<double>(settings.membership));
}

GlFramebuffer framebufferOf(const std::vector<const GlTexture*>& textures) {
  GlFramebuffer framebuffer = GlFramebuffer::create();
  std::vector<GLenum> targets;
  for (std::size_t i = 0; i < textures.size(); ++i) {
    targets.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i));
    glNamedFramebufferTexture(framebuffer.name(), targets.back(), textures[i]->name(), 0);
  }
  glNamedFramebufferDrawBuffers(framebuffer.name(), static_cast<GLsizei>(targets.size()), targets.data());
  const GLenum status = glCheckNamedFramebufferStatus(framebuffer.name(), GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw GpuError(fmt::format("screen-space images: expected a complete framebuffer, found status {:#06x}", status));
  return framebuffer;
}

/// The rectangle in bands of at most kTilePixels, each waited for.
void drawBands(const TileRect& rect) {
  const int rows = std::max(1, kTilePixels / std::max(1, rect.high.x - rect.low.x));
  for (int y = rect.low.y; y < rect.high.y; y += rows) {
    glScissor(rect.low.x, y, rect.high.x - rect.low.x, std::min(rows, rect.high.y - y));
    glDrawArrays(GL_TRIANGLES, 0, kTriangle);
    glFinish();
  }
}

void bindTarget(const GlFramebuffer& target, glm::ivec2 size) {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.name());
  glViewport(0, 0, size.x, size.y);
}

void readTexture(const GlTexture& texture, glm::ivec2 size, std::vector<glm::vec4>& texels) {
  glGetTextureSubImage(texture.name(), 0, 0, 0, 0, size.x, size.y, 1, GL_RGBA, GL_FLOAT,
                       static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)), texels.data());
}

}  // namespace

ScreenPass::ScreenPass() {
  glNamedBufferStorage(screenBuffer_.name(), sizeof(shader::ScreenUniforms), nullptr, GL_DYNAMIC_STORAGE_BIT);
  glNamedBufferStorage(sampleBuffer_.name(), sizeof(shader::ScreenSamples), nullptr, GL_DYNAMIC_STORAGE_BIT);
  checkGl("screen-space passes");
}

const GlProgram& ScreenPass::program(const std::string& name) {
  GlProgram& built = programs_[name];
  if (!built) {
    const ProgramVariant& variant = programVariant(name);
    built = buildProgram(variant.vertex, variant.fragment,
                         [this](std::string_view file) { return coloredShader(file, colored_); });
  }
  return built;
}

void ScreenPass::reserve(glm::ivec2 size, bool positions) {
  if (images_.size == size && (images_.position || !positions)) return;
  images_ = Images();
  const auto image = [size](const TexelFormat& format) {
    return makeTexture2D("screen-space", size, format, GL_NEAREST, nullptr);
  };
  images_.depth = image(kR32F);
  images_.normal = image(kRGBA32F);
  images_.light = image(kRGBA32F);
  images_.filtered = image(kRGBA32F);
  images_.color = image(kRGBA32F);
  if (positions) images_.position = image(kRGBA32F);
  std::vector<const GlTexture*> gbuffer{&images_.depth, &images_.normal};
  if (positions) gbuffer.push_back(&images_.position);
  images_.gbuffer = framebufferOf(gbuffer);
  images_.estimate = framebufferOf({&images_.light});
  images_.filter = framebufferOf({&images_.filtered});
  images_.composite = framebufferOf({&images_.color});
  images_.size = size;
  checkGl("screen-space images");
}

void ScreenPass::reserveIndirect() {
  if (images_.radiance) return;
  images_.radiance = makeTexture2D("radiance", images_.size, kRGBA32F, GL_NEAREST, nullptr);
  images_.filteredRadiance = makeTexture2D("radiance", images_.size, kRGBA32F, GL_NEAREST, nullptr);
  images_.indirect = framebufferOf({&images_.radiance});
  images_.filterIndirect = framebufferOf({&images_.filteredRadiance});
}

void ScreenPass::setSamples(const std::vector<glm::vec4>& samples) {
  if (samples.empty()) return;
  glNamedBufferSubData(sampleBuffer_.name(), 0, static_cast<GLsizeiptr>(samples.size() * sizeof(glm::vec4)),
                       samples.data());
}

void ScreenPass::drawPass(const std::string& name, const GlFramebuffer& target, glm::ivec2 size) {
  glUseProgram(program(name).name());
  bindTarget(target, size);
  glEnable(GL_SCISSOR_TEST);
  drawBands({glm::ivec2(0), size});
  glDisable(GL_SCISSOR_TEST);
}

void ScreenPass::makeHeights(const SceneTextures& scene) {
  if (heights_) return;
  const glm::ivec2 columns(scene.size);
  heights_ = makeTexture2D("height", columns, kR32F, GL_NEAREST, nullptr);
  glBindTextureUnit(kLevelUnit, scene.level.name());
  drawPass("screen_heights", framebufferOf({&heights_}), columns);
}

void ScreenPass::makeMoments() {
  moments_.reserve(images_.size);
  drawPass("screen_moments", moments_.target(), images_.size);
  moments_.average();
  glBindTextureUnit(kMomentUnit, moments_.texture());
}

void ScreenPass::drawGBuffer(glm::vec2 sampleOffset, BeamPass& beams, const SceneTextures& scene) {
  constexpr GLint kPixelOrigin = 0;
  constexpr glm::vec4 kNothing(0), kNoDepth(shader::kNothingSeen);
  const glm::vec2 origin = -0.5f * glm::vec2(images_.size);
  const std::array<GLuint, 3> textures{scene.level.name(), scene.clearance.name(), scene.distance.name()};
  for (GLuint unit = 0; unit < textures.size(); ++unit) glBindTextureUnit(unit, textures[unit]);
  const std::vector<TileRect> rects = beams.trace(origin, images_.size);
  const GlProgram& march = program("march_gbuffer");
  glUseProgram(march.name());
  glBindTextureUnit(kBeamUnit, beams.texture());
  glProgramUniform2f(march.name(), kPixelOrigin, origin.x + sampleOffset.x, origin.y + sampleOffset.y);
  bindTarget(images_.gbuffer, images_.size);
  glClearNamedFramebufferfv(images_.gbuffer.name(), GL_COLOR, 0, &kNoDepth[0]);
  for (GLint i = 1; i < (images_.position ? 3 : 2); ++i)
    glClearNamedFramebufferfv(images_.gbuffer.name(), GL_COLOR, i, &kNothing[0]);
  glEnable(GL_SCISSOR_TEST);
  for (const TileRect& rect : rects) drawBands({rect.low, glm::min(rect.high, images_.size)});
  glDisable(GL_SCISSOR_TEST);
}

const GlTexture& ScreenPass::drawLight(const ScreenOcclusion& settings, const ScreenPlan& plan, bool filtered,
                                       const SceneTextures& scene) {
  glBindTextureUnit(kDepthUnit, images_.depth.name());
  glBindTextureUnit(kNormalUnit, images_.normal.name());
  glBindTextureUnit(kLevelUnit, scene.level.name());
  glBindTextureUnit(kHeightUnit, heights_.name());
  if (!readsNeighbourhood(settings))
    for (std::size_t i = 0; i < kSweptFields; ++i)
      glBindTextureUnit(kSweptUnit + static_cast<GLuint>(i), scene.lights[i].name());
  if (plan.moments) makeMoments();
  drawPass(plan.program, images_.estimate, images_.size);
  // Each pass goes from one of two images to the other.
  bool inFiltered = false;
  const auto pass = [&](const char* name) {
    glBindTextureUnit(kLightUnit, inFiltered ? images_.filtered.name() : images_.light.name());
    drawPass(name, inFiltered ? images_.estimate : images_.filter, images_.size);
    inFiltered = !inFiltered;
  };
  if (filtered) pass("screen_filter");
  if (plan.bentLight) pass("screen_bent_light");
  return inFiltered ? images_.filtered : images_.light;
}

void ScreenPass::drawIndirect(const ScreenOcclusion& settings, bool filtered) {
  reserveIndirect();
  setSamples(indirectSamples(settings));
  drawPass("screen_indirect", images_.indirect, images_.size);
  if (filtered) {
    glBindTextureUnit(kLightUnit, images_.radiance.name());
    drawPass("screen_filter", images_.filterIndirect, images_.size);
  }
  glBindTextureUnit(kRadianceUnit, filtered ? images_.filteredRadiance.name() : images_.radiance.name());
}

void ScreenPass::draw(const Camera& camera, const RenderSettings& settings, const shader::FrameUniforms& frame,
                      const SceneTextures& scene, BeamPass& beams, const ScreenTarget& target) {
  const ScreenOcclusion& occlusion = settings.screen.value();
  checkScreen(occlusion, scene);
  const ScreenPlan plan = planScreen(occlusion);
  const bool filtered = occlusion.filter && occlusion.interleaving > 1 && readsNeighbourhood(occlusion);
  reserve(settings.size, settings.layers || scene.colors);
  colored_ = static_cast<bool>(scene.colors);
  sky_.use(occlusion.sky, plan.sky);
  if (readsCharacteristic(occlusion) && occlusion.surface == Characteristic::heightField) makeHeights(scene);
  if (colored_) glBindTextureUnit(kColorPositionUnit, images_.position.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, kScreenBinding, screenBuffer_.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, kSampleBinding, sampleBuffer_.name());
  for (int i = 0; i < settings.samples; ++i) {
    const glm::vec2 offset = i == 0 ? glm::vec2(0) : sampleOffset(i);
    const shader::ScreenUniforms uniforms =
        makeScreenUniforms(frame, camera, scene.frame, settings.size, offset, occlusion, plan);
    glNamedBufferSubData(screenBuffer_.name(), 0, sizeof(uniforms), &uniforms);
    setSamples(plan.samples);
    drawGBuffer(offset, beams, scene);
    const GlTexture& light = drawLight(occlusion, plan, filtered, scene);
    glBindTextureUnit(kLightUnit, light.name());
    if (occlusion.indirect) {
      shader::ScreenUniforms around = uniforms;
      around.size.z = occlusion.samples;
      glNamedBufferSubData(screenBuffer_.name(), 0, sizeof(around), &around);
      drawIndirect(occlusion, filtered);
      glBindTextureUnit(kLightUnit, light.name());
    }
    if (i > 0) glEnablei(GL_BLEND, 0);
    drawPass("screen_composite", images_.composite, settings.size);
    glDisablei(GL_BLEND, 0);
    if (i > 0 || !settings.layers) continue;
    readTexture(light, settings.size, target.lights);
    readTexture(images_.normal, settings.size, target.normals);
    readTexture(images_.position, settings.size, target.positions);
  }
  readTexture(images_.color, settings.size, target.color);
  checkGl("screen-space frame");
}

}  // namespace isolume
