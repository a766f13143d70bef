#include "gl/gl_scene.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace isolume::test {

SceneFields GlScene::fields() const {
  return {worldFromGrid,
          level.view(),
          distance.view(),
          {octants[0].view(), octants[1].view()},
          openness.empty() ? std::vector<LightField>() : std::vector<LightField>{{&openness}}};
}

GlScene makeScene(glm::ivec3 size, glm::dvec3 spacing, const std::function<double(glm::dvec3)>& distance) {
  GlScene scene{Grid<float>(size, spacing), Grid<float>(size, spacing), {}, SurfaceField(size), glm::dmat4(1)};
  std::ranges::fill(scene.openness.numbers(), std::uint16_t{65535});
  for (int axis = 0; axis < 3; ++axis) scene.worldFromGrid[axis][axis] = spacing[axis];
  std::size_t i = 0;
  for (int z = 0; z < size.z; ++z) {
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x, ++i) {
        const double value = distance(spacing * glm::dvec3(x, y, z));
        scene.level.data()[i] = static_cast<float>(-value);
        scene.distance.data()[i] = static_cast<float>(value);
      }
    }
  }
  for (Grid<glm::u8vec4>& grid : scene.octants) {
    grid = Grid<glm::u8vec4>(size, spacing);
    std::fill_n(grid.data(), grid.count(), glm::u8vec4(255));
  }
  return scene;
}

glm::dvec3 sphereCentre(int n, glm::dvec3 spacing) { return spacing * (0.5 * (n - 1) + glm::dvec3(0.13, -0.21, 0.37)); }

GlScene makeSphere(int n, double radius, glm::dvec3 spacing) {
  const glm::dvec3 centre = sphereCentre(n, spacing);
  return makeScene(glm::ivec3(n), spacing, [=](glm::dvec3 p) { return glm::length(p - centre) - radius; });
}

Camera frameScene(const GlScene& scene, const Framing& framing) {
  const auto corners = boxCorners(scene.worldFromGrid, glm::dvec3(0), glm::dvec3(scene.level.size() - 1));
  return frameCorners(corners, 1.25, framing);
}

RenderSettings layerSettings(int width, int height) {
  RenderSettings settings;
  settings.size = {width, height};
  settings.shading = Shading::local;
  settings.layers = true;
  return settings;
}

Frame renderOnce(const GlScene& scene, const Camera& camera, const RenderSettings& settings) {
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  renderer.upload(scene.fields());
  return renderer.render(camera, settings);
}

}  // namespace isolume::test
