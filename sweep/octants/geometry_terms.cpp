#include "geometry_terms.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "sweep/parallel.h"

namespace isolume {
namespace {

// A triangle clipped by one plane has at most four corners.
struct Polygon {
  std::array<glm::dvec3, 4> corners;
  int count = 0;
  void add(glm::dvec3 corner) { corners[static_cast<std::size_t>(count++)] = corner; }
};

// The part of the octant's spherical triangle on the side N . w >= 0. Edges are great circles, so they may be cut on
// their chords.
Polygon clipAtHorizon(glm::ivec3 signs, glm::dvec3 normal) {
  const std::array<glm::dvec3, 3> triangle{glm::dvec3(signs.x, 0, 0), glm::dvec3(0, signs.y, 0),
                                           glm::dvec3(0, 0, signs.z)};
  Polygon polygon;
  for (std::size_t i = 0; i < triangle.size(); ++i) {
    const glm::dvec3 here = triangle[i];
    const glm::dvec3 next = triangle[(i + 1) % triangle.size()];
    const double heightHere = glm::dot(normal, here);
    const double heightNext = glm::dot(normal, next);
    if (heightHere >= 0) polygon.add(here);
    if ((heightHere < 0) != (heightNext < 0)) {
      polygon.add(glm::normalize(here * heightNext - next * heightHere) * (heightNext > heightHere ? 1.0 : -1.0));
    }
  }
  return polygon;
}

// Lambert's formula: the clamped-cosine integral over a spherical polygon is 1/2 sum theta_k (N . n_k), with theta_k
// the angle of edge k and n_k the unit normal of its plane.
double frontTerm(int octant, glm::dvec3 normal) {
  const Polygon polygon = clipAtHorizon(kOctants[static_cast<std::size_t>(octant)].towardsLight(), normal);
  double sum = 0;
  for (int k = 0; k < polygon.count; ++k) {
    const glm::dvec3 a = polygon.corners[static_cast<std::size_t>(k)];
    const glm::dvec3 b = polygon.corners[static_cast<std::size_t>((k + 1) % polygon.count)];
    const glm::dvec3 cross = glm::cross(a, b);
    const double sine = glm::length(cross);
    if (sine == 0) continue;
    sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(normal, cross) / sine;
  }
  return std::abs(sum) / 2;  // the sign tells only which way round the corners go
}

}  // namespace

double octantGeometryTerm(int octant, glm::dvec3 normal, GeometryTerm term) {
  const double front = frontTerm(octant, normal);
  return term == GeometryTerm::front ? front : front + frontTerm(octant, -normal);
}

GeometryTermTables makeGeometryTermTables(int size, GeometryTerm geometryTerm) {
  GeometryTermTables tables;
  tables.size = size;
  const auto rowLength = static_cast<std::size_t>(size);
  for (auto& texels : tables.texels) texels.resize(rowLength * rowLength);
  // One quarter is computed; mirroring a normal in x or y mirrors its octants, s -> s ^ 1 or s -> s ^ 2.
  parallelFor((rowLength + 1) / 2, [&](std::size_t row) {
    for (std::size_t column = 0; column < (rowLength + 1) / 2; ++column) {
      const double x = 2 * static_cast<double>(column) / (size - 1) - 1;
      const double y = 2 * static_cast<double>(row) / (size - 1) - 1;
      const double z = 1 - (x * x + y * y);
      const double scale = std::sqrt(1 + z);
      const glm::dvec3 normal = glm::normalize(glm::dvec3(x * scale, y * scale, z));
      for (int octant = 0; octant < kOctantCount; ++octant) {
        const auto term = static_cast<float>(octantGeometryTerm(octant, normal, geometryTerm));
        for (int mirror = 0; mirror < 4; ++mirror) {
          const std::size_t atX = (mirror & 1) != 0 ? rowLength - 1 - column : column;
          const std::size_t atY = (mirror & 2) != 0 ? rowLength - 1 - row : row;
          tables.texels[static_cast<std::size_t>(octant / 4)][atY * rowLength + atX][(octant ^ mirror) % 4] = term;
        }
      }
    }
  });
  return tables;
}

}  // namespace isolume
