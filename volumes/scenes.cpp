#include "scenes.h"

#include <array>

#include "scene_families.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

template <double (*Value)(glm::dvec3)>
float asFloat(glm::dvec3 p) {
  return static_cast<float>(Value(p));
}

const std::array<Scene, 7>& scenes() {
  static const std::array<Scene, 7> all{{
      {"corner", "room corner with box, sphere, torus and column, after [Singh10] Fig. 3", true, asFloat<cornerValue>},
      {"capillaries", "branching vascular tree, after [Singh10] Fig. 5", true, asFloat<capillariesValue>},
      {"gyroid", "gyroid sheet of three periods, cut by a ball", false, asFloat<gyroidValue>},
      {"capsules", "60 thin capsules at random", true, asFloat<capsulesValue>},
      {"spheres", "packed spheres of five sizes", true, asFloat<spheresValue>},
      {"vorticity", "vortex tubes of a synthetic turbulent field, after [Singh10] Fig. 4", false,
       asFloat<vorticityValue>},
      {"terrain", "hills, a height field along z", false, asFloat<terrainValue>},
  }};
  return all;
}

}  // namespace

std::vector<std::string_view> sceneNames() {
  std::vector<std::string_view> names;
  for (const Scene& scene : scenes()) names.push_back(scene.name);
  return names;
}

const Scene* findScene(std::string_view name) {
  for (const Scene& scene : scenes())
    if (scene.name == name) return &scene;
  return nullptr;
}

Grid<float> sampleScene(const Scene& scene, int size) {
  const double spacing = 1.0 / size;
  Grid<float> grid(glm::ivec3(size), glm::dvec3(spacing), glm::dvec3(spacing / 2));
  const GridView<float> view = grid.view();
  const auto center = [size](int index) { return (index + 0.5) / size; };
  parallelFor(static_cast<std::size_t>(size), [&](std::size_t slice) {
    const int z = static_cast<int>(slice);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) view(x, y, z) = scene.value({center(x), center(y), center(z)});
  });
  return grid;
}

}  // namespace isolume
