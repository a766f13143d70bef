#include "surface_colors.h"

#include <fmt/format.h>

#include <cstddef>
#include <glm/matrix.hpp>

#include "gl_check.h"
#include "gpu_error.h"
#include "shader_source.h"
#include "textures.h"

namespace isolume {
namespace shader {

using glm::ivec4, glm::vec4;
#include "shaders/shared/color_block.h"

// std140: members of 16 bytes each.
static_assert(sizeof(ColorUniforms) == 5 * 16);
static_assert(offsetof(ColorUniforms, size) == 4 * 16);

}  // namespace shader

namespace {

// As in shaders/march/albedo_field.glsl.
constexpr GLuint kColorBinding = 3, kColorFieldUnit = 16, kColorMapUnit = 17;

}  // namespace

SurfaceColors::SurfaceColors(const ColorField& field, glm::dmat4 worldFromGrid) {
  if (field.colors.size() < 2)
    throw GpuError(fmt::format("colours: expected at least 2 in the map, found {}", field.colors.size()));
  field_ = makeTexture3D("colouring field", field.places.size, kR32F, GL_NEAREST, field.places.data);
  std::vector<glm::vec4> texels;
  texels.reserve(field.colors.size());
  for (const glm::vec3& color : field.colors) texels.emplace_back(color, 1);
  map_ = makeTexture2D("colour map", {static_cast<int>(texels.size()), 1}, kRGBA32F, GL_NEAREST, texels.data());
  const glm::dmat4 rows = glm::transpose(glm::inverse(field.worldFromGrid) * worldFromGrid);
  const shader::ColorUniforms uniforms{.toX = rows[0],
                                       .toY = rows[1],
                                       .toZ = rows[2],
                                       .unknown = glm::vec4(field.unknown, 0),
                                       .size = glm::ivec4(field.places.size, static_cast<int>(texels.size()))};
  uniforms_ = GlBuffer::create();
  glNamedBufferStorage(uniforms_.name(), sizeof(uniforms), &uniforms, 0);
  checkGl("colours of the surface");
}

void SurfaceColors::bind() const {
  if (!field_) return;
  glBindBufferBase(GL_UNIFORM_BUFFER, kColorBinding, uniforms_.name());
  glBindTextureUnit(kColorFieldUnit, field_.name());
  glBindTextureUnit(kColorMapUnit, map_.name());
}

std::string_view coloredShader(std::string_view name, bool colored) {
  if (colored && name == "shaders/march/albedo.glsl") return embeddedShader("shaders/march/albedo_field.glsl");
  if (colored && name == "shaders/screen/albedo.glsl") return embeddedShader("shaders/screen/albedo_field.glsl");
  return embeddedShader(name);
}

}  // namespace isolume
