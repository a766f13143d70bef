#include "octant_lights.h"

#include <glm/common.hpp>

namespace isolume {

shader::OctantLights makeOctantLights(const std::array<glm::vec3, kOctantCount>& light, GeometryTerm term) {
  shader::OctantLights lights{};
  for (int s = 0; s < kOctantCount; ++s) {
    const glm::vec3 each = light[static_cast<std::size_t>(s)];
    for (int color = 0; color < 3; ++color) (s < 4 ? lights.low : lights.high)[color][s % 4] = each[color];
    lights.most = glm::max(lights.most, glm::vec4(each, 0));
  }
  if (term == GeometryTerm::bothSides) lights.most *= 2;
  return lights;
}

}  // namespace isolume
