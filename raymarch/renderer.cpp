#include "renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <glm/common.hpp>
#include <new>
#include <stdexcept>
#include <utility>

#include "beams.h"
#include "check_settings.h"
#include "frame_layers.h"
#include "frame_uniforms.h"
#include "framebuffer.h"
#include "geometry_textures.h"
#include "gl_check.h"
#include "gpu_error.h"
#include "lights.h"
#include "octant_lights.h"
#include "program.h"
#include "program_variants.h"
#include "scene_textures.h"
#include "screen/screen_pass.h"
#include "view.h"

namespace isolume {
namespace {

shader::FrameUniforms makeUniforms(const Camera& camera, const RenderSettings& settings, const SceneTextures& scene) {
  shader::FrameUniforms uniforms{};
  setRays(uniforms, camera, settings.size, scene.frame, scene.size);
  uniforms.scale.w = settings.occlusionOffsetVoxels;
  uniforms.albedo = glm::vec4(settings.albedo, 1 / settings.gamma);
  uniforms.background = glm::vec4(glm::vec3(settings.background) * settings.background.a, settings.background.a);
  uniforms.gridSize = glm::ivec4(scene.size, 0);
  uniforms.modes = glm::ivec4(settings.normals == NormalSource::distance ? 1 : 0, 0, 0, 0);
  return uniforms;
}

constexpr GLuint kSwept0Unit = 3;  // after level, clearance and distance: octants and geometry terms
constexpr GLuint kBeamUnit = 7;
constexpr GLuint kLight0Unit = 8;

const char* variantName(Shading shading) {
  switch (shading) {
    case Shading::octants:
      return "march_octants";
    case Shading::lights:
      return "march_lights";
    case Shading::local:
      return "march_local";
  }
  return nullptr;
}

}  // namespace

struct Renderer::Impl {
  std::array<GlProgram, 3> programs;  // by shading, each built when it is first needed
  GlBuffer uniformBuffer = GlBuffer::create();
  GlBuffer lightBuffer = GlBuffer::create();
  GlBuffer octantBuffer = GlBuffer::create();
  GlVertexArray vertexArray = GlVertexArray::create();
  std::size_t builtSuns = 0;  // that the program of light fields knows
  GeometryTextures geometryTextures;
  SceneTextures scene;
  Framebuffer framebuffer;
  BeamPass beams;
  std::unique_ptr<ScreenPass> screen;  // made with the first picture that needs it

  Impl() {
    glNamedBufferStorage(uniformBuffer.name(), sizeof(shader::FrameUniforms), nullptr, GL_DYNAMIC_STORAGE_BIT);
    glNamedBufferStorage(lightBuffer.name(), sizeof(shader::LightUniforms), nullptr, GL_DYNAMIC_STORAGE_BIT);
    glNamedBufferStorage(octantBuffer.name(), sizeof(shader::OctantLights), nullptr, GL_DYNAMIC_STORAGE_BIT);
    checkGl("renderer");
  }

  // `suns`: of Shading::lights.
  const GlProgram& program(Shading shading, std::size_t suns = 0) {
    GlProgram& built = programs[static_cast<std::size_t>(shading)];
    if (shading == Shading::lights && builtSuns != suns) built = {};
    builtSuns = shading == Shading::lights ? suns : builtSuns;
    if (built.name() == 0) {
      const ProgramVariant& variant = programVariant(variantName(shading));
      const bool colored = static_cast<bool>(scene.colors);
      built = shading == Shading::lights
                  ? buildLightProgram(scene.lightFields, suns, colored)
                  : buildProgram(variant.vertex, variant.fragment,
                                 [colored](std::string_view name) { return coloredShader(name, colored); });
    }
    return built;
  }

  const GeometryTextures::Pair& geometryTerms(const RenderSettings& settings) {
    return settings.openPlaneTerms
               ? geometryTextures.dividedByOpenPlane(scene.frame.spacing, settings.occlusionOffsetVoxels)
               : geometryTextures.of(settings.geometryTerm);
  }

  void bindOctants(const RenderSettings& settings) {
    const shader::OctantLights uniforms = makeOctantLights(settings.octantLight, settings.geometryTerm);
    glNamedBufferSubData(octantBuffer.name(), 0, sizeof(uniforms), &uniforms);
    glBindBufferBase(GL_UNIFORM_BUFFER, 2, octantBuffer.name());
    GLuint unit = kSwept0Unit;
    for (const GlTexture& texture : scene.octants) glBindTextureUnit(unit++, texture.name());
    for (const GlTexture& texture : geometryTerms(settings)) glBindTextureUnit(unit++, texture.name());
    assert(unit <= kBeamUnit);
  }

  void bindLights(const RenderSettings& settings) const {
    const shader::LightUniforms uniforms = makeLightUniforms(scene.lightFields, settings, scene.frame);
    glNamedBufferSubData(lightBuffer.name(), 0, sizeof(uniforms), &uniforms);
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, lightBuffer.name());
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
      glBindTextureUnit(kLight0Unit + static_cast<GLuint>(i), scene.lights[i].name());
  }

  void bindInputs(const shader::FrameUniforms& uniforms, const RenderSettings& settings) {
    const Shading shading = settings.shading;
    glNamedBufferSubData(uniformBuffer.name(), 0, sizeof(uniforms), &uniforms);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, uniformBuffer.name());
    glBindVertexArray(vertexArray.name());
    const std::array<GLuint, kSwept0Unit> textures{scene.level.name(), scene.clearance.name(), scene.distance.name()};
    for (GLuint unit = 0; unit < textures.size(); ++unit) glBindTextureUnit(unit, textures[unit]);
    scene.colors.bind();
    if (shading == Shading::octants) bindOctants(settings);
    if (shading == Shading::lights) bindLights(settings);
    for (GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_BLEND}) glDisable(capability);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
  }

  // The rectangles, each a triangle that covers the viewport, cut by the scissor.
  void draw(const GlProgram& program, glm::vec2 pixelOrigin, const std::vector<TileRect>& rects) const {
    constexpr GLint kPixelOrigin = 0;
    constexpr int kTriangle = 3;
    glUseProgram(program.name());
    glBindTextureUnit(kBeamUnit, beams.texture());
    glProgramUniform2f(program.name(), kPixelOrigin, pixelOrigin.x, pixelOrigin.y);
    glEnable(GL_SCISSOR_TEST);
    for (const TileRect& rect : rects) {
      glScissor(rect.low.x, rect.low.y, rect.high.x - rect.low.x, rect.high.y - rect.low.y);
      glDrawArrays(GL_TRIANGLES, 0, kTriangle);
    }
    glDisable(GL_SCISSOR_TEST);
    glFinish();
  }

  // Colour (sum of the samples) and layers of one tile. One sample is its own centre; of several, the centre's layers
  // are drawn on their own.
  void drawTile(glm::vec2 pixelOrigin, glm::ivec2 size, const RenderSettings& settings, glm::vec4 background) {
    const std::vector<TileRect> rects = beams.trace(pixelOrigin, size);
    const GlProgram& march = program(settings.shading, settings.suns.size());
    const bool single = settings.samples == 1;
    if (single || settings.layers) {
      framebuffer.bind(size, single, settings.layers);
      framebuffer.clear(background);
      draw(march, pixelOrigin, rects);
    }
    if (single) return;
    framebuffer.bind(size, true, false);
    framebuffer.clear(static_cast<float>(settings.samples) * background);
    for (int i = 0; i < settings.samples; ++i) {
      if (i == 1) glEnablei(GL_BLEND, 0);  // the first sample replaces the background of the rectangles
      draw(march, pixelOrigin + sampleOffset(i), rects);
    }
    glDisablei(GL_BLEND, 0);
  }

  void drawTiles(const shader::FrameUniforms& uniforms, const RenderSettings& settings, const ScreenTarget& target) {
    const glm::ivec2 size = settings.size;
    const int tileWidth = std::min(size.x, kTileWidth);
    const glm::ivec2 tile(tileWidth, std::min(size.y, kTilePixels / tileWidth));
    framebuffer.reserve(tile, settings.layers);
    bindInputs(uniforms, settings);
    for (int y = 0; y < size.y; y += tile.y) {
      for (int x = 0; x < size.x; x += tile.x) {
        const glm::ivec2 extent = glm::min(tile, size - glm::ivec2(x, y));
        drawTile(glm::vec2(x, y) - 0.5f * glm::vec2(size), extent, settings, uniforms.background);
        const std::size_t start =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
        framebuffer.read(Attachment::color, extent, &target.color[start], size.x);
        if (!settings.layers) continue;
        framebuffer.read(Attachment::normal, extent, &target.normals[start], size.x);
        framebuffer.read(Attachment::position, extent, &target.positions[start], size.x);
        framebuffer.read(Attachment::light, extent, &target.lights[start], size.x);
      }
    }
  }

  void drawScreen(const shader::FrameUniforms& uniforms, const Camera& camera, const RenderSettings& settings,
                  const ScreenTarget& target) {
    RenderSettings inputs = settings;
    inputs.shading = Shading::local;  // of the scene, only what the trace reads
    bindInputs(uniforms, inputs);
    if (!screen) screen = std::make_unique<ScreenPass>();
    screen->draw(camera, settings, uniforms, scene, beams, target);
  }
};

Renderer::Renderer(Context&) : impl_(std::make_unique<Impl>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::upload(const SceneFields& fields) {
  const bool colored = static_cast<bool>(impl_->scene.colors);
  impl_->scene = SceneTextures();  // room for the new one
  if (impl_->screen) impl_->screen->forgetScene();
  impl_->scene = uploadScene(fields);
  impl_->programs[static_cast<std::size_t>(Shading::lights)] = {};  // it knows how many they are
  if (colored != static_cast<bool>(impl_->scene.colors)) {
    impl_->programs = {};
    impl_->screen = {};
  }
}

void Renderer::prepare(const RenderSettings& settings) {
  checkSettings(settings, impl_->scene);
  if (settings.screen) return;  // many programs, some for the first picture alone: it builds them
  if (settings.shading == Shading::octants) impl_->geometryTerms(settings);
  impl_->program(settings.shading, settings.suns.size());
}

Frame Renderer::render(const Camera& camera, const RenderSettings& settings, Frame storage) try {
  checkSettings(settings, impl_->scene);
  const shader::FrameUniforms uniforms = makeUniforms(camera, settings, impl_->scene);
  const glm::ivec2 size = settings.size;
  const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  Frame frame;
  if (settings.layers)
    frame = std::move(storage);
  else
    frame.color = std::move(storage.color);
  frame.size = size;
  frame.color.resize(count);
  const std::size_t layerCount = settings.layers ? count : 0;
  std::vector<glm::vec4> normals(layerCount), positions(layerCount), lights(layerCount);

  if (settings.screen)
    impl_->drawScreen(uniforms, camera, settings, {frame.color, normals, positions, lights});
  else
    impl_->drawTiles(uniforms, settings, {frame.color, normals, positions, lights});
  checkGl("frame");
  if (settings.samples > 1) {
    const float share = 1 / static_cast<float>(settings.samples);
    for (glm::vec4& color : frame.color) color *= share;
  }
  if (settings.layers) fillLayers(frame, normals, positions, lights, camera, impl_->scene.frame);
  return frame;
} catch (const std::bad_alloc&) {
  throw GpuError(fmt::format("image: not enough memory for {}x{} pixels", settings.size.x, settings.size.y));
} catch (const std::length_error&) {
  throw GpuError(fmt::format("image: not enough memory for {}x{} pixels", settings.size.x, settings.size.y));
}

}  // namespace isolume
