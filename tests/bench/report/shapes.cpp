#include "tests/bench/report/shapes.h"

#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "src/errors.h"
#include "volumes/primitives.h"
#include "volumes/scenes.h"

namespace isolume::bench {
namespace {

constexpr glm::dvec3 kCentre{0.5013, 0.4979, 0.5007};

double sphereValue(glm::dvec3 p) {
  constexpr double kRadius = 0.31;
  return distanceTo(Sphere{kCentre, kRadius}, p);
}
double torusValue(glm::dvec3 p) {
  constexpr double kRing = 0.27, kTube = 0.11;
  const glm::dvec3 q = p - kCentre;
  return glm::length(glm::dvec2(glm::length(glm::dvec2(q)) - kRing, q.z)) - kTube;
}
double boxValue(glm::dvec3 p) {
  constexpr glm::dvec3 kHalfSize{0.31, 0.23, 0.27};
  return boxDistance(p - kCentre, kHalfSize);
}

struct Shape {
  const char* name;
  double (*value)(glm::dvec3);
};
constexpr Shape kShapes[] = {{"sphere", sphereValue}, {"torus", torusValue}, {"box", boxValue}};

}  // namespace

std::vector<std::string> shapeNames() {
  std::vector<std::string> names;
  for (const Shape& shape : kShapes) names.emplace_back(shape.name);
  for (const std::string_view scene : sceneNames()) names.emplace_back(scene);
  return names;
}

Grid<float> shapeLevel(const std::string& name, int size) {
  std::function<double(glm::dvec3)> value;
  for (const Shape& shape : kShapes)
    if (name == shape.name) value = shape.value;
  if (const Scene* scene = findScene(name)) value = scene->value;
  if (!value) {
    std::string list;
    for (const std::string& known : shapeNames()) list += (list.empty() ? "" : ", ") + known;
    throw UsageError(fmt::format("--shape: expected one of {}, found '{}'", list, name));
  }
  Grid<float> level{glm::ivec3(size)};
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        level.view()(x, y, z) = static_cast<float>(-size * value((glm::dvec3(x, y, z) + 0.5) / double(size)));
  return level;
}

void checkBorderOutside(GridView<const float> level, const std::string& name) {
  const glm::ivec3 last = level.size - 1;
  for (int z = 0; z <= last.z; ++z)
    for (int y = 0; y <= last.y; ++y)
      for (int x = 0; x <= last.x; ++x) {
        const bool border = x == 0 || y == 0 || z == 0 || x == last.x || y == last.y || z == last.z;
        if (border && level(x, y, z) > 0)
          throw InputError(fmt::format(
              "{}: expected every sample on the border outside the solid, found ({}, {}, {}) inside", name, x, y, z));
      }
}

}  // namespace isolume::bench
