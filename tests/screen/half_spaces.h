// Scenes about a shaded point at the origin whose normal is +z: floors, walls and steps, and views that see all of
// them.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

namespace isolume::test {

/// Solid where dot(into, p) > offset.
struct HalfSpace {
  glm::dvec3 into;
  double offset = 0;
};
/// Solid where all of a block's half-spaces are; the scene is the union of its blocks. Lengths in radii.
using Block = std::vector<HalfSpace>;
using Blocks = std::vector<Block>;

inline const HalfSpace kFloor{{0, 0, -1}, 0};
inline HalfSpace wallX(double distance) { return {{1, 0, 0}, distance}; }
inline HalfSpace wallY(double distance) { return {{0, 1, 0}, distance}; }
inline HalfSpace below(double height) { return {{0, 0, -1}, -height}; }

inline Blocks plane() { return {{kFloor}}; }
inline Blocks edge(double distance) { return {{kFloor}, {wallX(distance)}}; }
inline Blocks corner(double distance) { return {{kFloor}, {wallX(distance)}, {wallY(distance)}}; }
inline Blocks step(double distance, double height) { return {{kFloor}, {wallX(distance), below(height)}}; }

inline bool isSolid(const Blocks& blocks, glm::dvec3 p) {
  return std::any_of(blocks.begin(), blocks.end(), [&](const Block& block) {
    return std::all_of(block.begin(), block.end(), [&](const HalfSpace& h) { return glm::dot(h.into, p) > h.offset; });
  });
}

/// Where a ray of the view enters the scene, from infinitely far: every half-space is seen from outside (dot(into,
/// along) > 0), so a block is entered where the last of its half-spaces is.
inline double entry(const Blocks& blocks, glm::dvec3 origin, glm::dvec3 along) {
  double first = std::numeric_limits<double>::infinity();
  for (const Block& block : blocks) {
    double last = -std::numeric_limits<double>::infinity();
    for (const HalfSpace& h : block)
      last = std::max(last, (h.offset - glm::dot(h.into, origin)) / glm::dot(h.into, along));
    first = std::min(first, last);
  }
  return first;
}

/// Columns: x, y and the direction of view of a frame, turned about the view by `roll`.
inline glm::dmat3 frameAlong(glm::dvec3 view, double roll) {
  const glm::dvec3 z = glm::normalize(view);
  const glm::dvec3 across = glm::normalize(glm::cross(z, glm::dvec3(0.3, -0.5, 0.8)));
  const glm::dvec3 x = std::cos(roll) * across + std::sin(roll) * glm::cross(z, across);
  return {x, glm::cross(z, x), z};
}

}  // namespace isolume::test
