#include "frame_layers.h"

#include <glm/geometric.hpp>
#include <limits>

#include "sweep/parallel.h"

namespace isolume {

void fillLayers(Frame& frame, const std::vector<glm::vec4>& normals, const std::vector<glm::vec4>& positions,
                const std::vector<glm::vec4>& lights, const Camera& camera, const GridFrame& grid) {
  const glm::dvec3 forward = cameraAxes(camera).forward;
  const std::size_t count = normals.size();
  frame.light.resize(count);
  frame.normal.resize(count);
  frame.position.resize(count);
  frame.index.resize(count);
  frame.depth.resize(count);
  const auto width = static_cast<std::size_t>(frame.size.x);
  parallelFor(static_cast<std::size_t>(frame.size.y), [&](std::size_t row) {
    for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
      const bool hit = positions[i].w > 0;
      frame.light[i] = glm::vec3(lights[i]);
      frame.index[i] = glm::vec3(positions[i]);
      if (!hit) {
        frame.normal[i] = glm::vec3(0);
        frame.position[i] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
        frame.depth[i] = std::numeric_limits<float>::infinity();
        continue;
      }
      const glm::dvec3 world(grid.worldFromGrid * glm::dvec4(glm::dvec3(positions[i]), 1));
      frame.normal[i] = glm::vec3(glm::normalize(grid.worldFromAxes * glm::dvec3(normals[i])));
      frame.position[i] = glm::vec3(world);
      frame.depth[i] = static_cast<float>(glm::dot(world - camera.eye, forward));
    }
  });
}

}  // namespace isolume
