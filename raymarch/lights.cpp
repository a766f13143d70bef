#include "lights.h"

#include <fmt/format.h>

#include <cassert>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "program.h"
#include "program_variants.h"

namespace isolume {

shader::LightUniforms makeLightUniforms(const std::vector<LightField>& fields, const RenderSettings& settings,
                                        const GridFrame& grid) {
  const std::vector<glm::vec3>& colors = settings.lightColors;
  shader::LightUniforms uniforms{};
  uniforms.head = glm::vec4(settings.headLight, 0);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const LightField& field = fields[i];
    uniforms.color[i] = glm::vec4(field.full * (colors.empty() ? glm::vec3(1) : colors[i]), 0);
    if (field.radiusDegrees > 0)
      uniforms.disc[i] = glm::dvec4(glm::transpose(grid.worldFromAxes) * glm::normalize(field.direction),
                                    glm::radians(field.radiusDegrees));
  }
  for (std::size_t i = 0; i < settings.suns.size(); ++i) {
    const HardSun& sun = settings.suns[i];
    uniforms.sunColor[i] = glm::vec4(sun.color, 0);
    uniforms.sun[i] = glm::dvec4(glm::transpose(grid.worldFromAxes) * glm::normalize(sun.direction), 0);
  }
  return uniforms;
}

GlProgram buildLightProgram(std::size_t fields, std::size_t suns) {
  assert(fields <= shader::kMostLightFields && suns <= shader::kMostSuns);
  const std::string counts = fmt::format("const int kLightFields = {};\nconst int kSuns = {};\n", fields, suns);
  const ProgramVariant& variant = programVariant("march_lights");
  return buildProgram(variant.vertex, variant.fragment, [&counts](std::string_view name) {
    return name == "shaders/march/light_counts.glsl" ? std::string_view(counts) : embeddedShader(name);
  });
}

}  // namespace isolume
