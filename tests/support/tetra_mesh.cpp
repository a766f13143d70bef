#include "support/tetra_mesh.h"

#include <array>
#include <utility>

namespace isolume::test {
namespace {

struct Corner {
  glm::ivec3 place;
  double level;
};
using Polygon = std::vector<glm::vec3>;

// Where the level is 0 on the edge between a corner inside and one outside; the same bits in either order.
glm::vec3 crossing(Corner a, Corner b) {
  if (a.level > 0) std::swap(a, b);
  return glm::vec3(glm::dvec3(a.place) + a.level / (a.level - b.level) * glm::dvec3(b.place - a.place));
}

void addTetrahedron(const std::array<Corner, 4>& corners, std::vector<glm::vec3>& triangles) {
  std::vector<Corner> inside, outside;
  for (const Corner& corner : corners) (corner.level > 0 ? inside : outside).push_back(corner);
  if (inside.empty() || outside.empty()) return;
  if (inside.size() == 2) {
    const glm::vec3 a = crossing(inside[0], outside[0]), b = crossing(inside[0], outside[1]);
    const glm::vec3 c = crossing(inside[1], outside[1]), d = crossing(inside[1], outside[0]);
    for (const glm::vec3& corner : {a, b, c, a, c, d}) triangles.push_back(corner);
    return;
  }
  const bool one = inside.size() == 1;
  for (const Corner& other : one ? outside : inside) triangles.push_back(crossing(one ? inside[0] : outside[0], other));
}

// The part of a triangle of the border that is inside: with up to four corners.
void addCap(const std::array<Corner, 3>& corners, std::vector<glm::vec3>& triangles) {
  Polygon polygon;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner &here = corners[i], &next = corners[(i + 1) % 3];
    if (here.level > 0) polygon.emplace_back(here.place);
    if ((here.level > 0) != (next.level > 0)) polygon.push_back(crossing(here, next));
  }
  for (std::size_t i = 2; i < polygon.size(); ++i)
    for (const glm::vec3& corner : {polygon[0], polygon[i - 1], polygon[i]}) triangles.push_back(corner);
}

constexpr std::array<std::array<int, 3>, 6> kOrders{{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

}  // namespace

std::vector<glm::vec3> tetraMesh(GridView<const float> level) {
  std::vector<glm::vec3> triangles;
  const auto cornerAt = [&](glm::ivec3 p) { return Corner{p, level(p.x, p.y, p.z)}; };
  const glm::ivec3 cells = level.size - 1;
  for (int z = 0; z < cells.z; ++z)
    for (int y = 0; y < cells.y; ++y)
      for (int x = 0; x < cells.x; ++x)
        for (const auto& order : kOrders) {
          // From the lowest to the highest corner of the cell, one axis after the other.
          glm::ivec3 place(x, y, z);
          std::array<Corner, 4> corners;
          corners[0] = cornerAt(place);
          for (std::size_t i = 0; i < 3; ++i) {
            ++place[order[i]];
            corners[i + 1] = cornerAt(place);
          }
          addTetrahedron(corners, triangles);
        }
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      glm::ivec3 low(0);
      low[axis] = side * cells[axis];
      for (low[v] = 0; low[v] < cells[v]; ++low[v])
        for (low[u] = 0; low[u] < cells[u]; ++low[u])
          for (const int firstAxis : {u, v}) {
            glm::ivec3 middle = low, high = low;
            ++middle[firstAxis];
            ++high[u];
            ++high[v];
            addCap({cornerAt(low), cornerAt(middle), cornerAt(high)}, triangles);
          }
    }
  return triangles;
}

}  // namespace isolume::test
