#include "lights.h"

#include <fmt/format.h>

#include <cassert>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "program.h"
#include "program_variants.h"
#include "surface_colors.h"

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

GlProgram buildLightProgram(const std::vector<LightField>& fields, std::size_t suns, bool colored) {
  assert(fields.size() <= shader::kMostLightFields && suns <= shader::kMostSuns);
  unsigned discs = 0, volumes = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].radiusDegrees > 0) discs |= 1U << i;
    if (fields[i].everywhere) volumes |= 1U << i;
  }
  const std::string counts = fmt::format(
      "const int kLightFields = {};\nconst int kDiscs = {};\nconst int kVolumes = {};\nconst int kSuns = {};\n",
      fields.size(), discs, volumes, suns);
  const ProgramVariant& variant = programVariant("march_lights");
  return buildProgram(variant.vertex, variant.fragment, [&counts, suns, colored](std::string_view name) {
    if (name == "shaders/march/light_counts.glsl") return std::string_view(counts);
    // A loop of no turns still makes the rest of the program slower.
    if (suns == 0 && name == "shaders/march/suns.glsl")
      return std::string_view("vec3 sunLight(LightUniforms lights, vec3 hit, vec3 normal) { return vec3(0.0f); }\n");
    return coloredShader(name, colored);
  });
}

}  // namespace isolume
