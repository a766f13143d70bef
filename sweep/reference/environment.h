// Light from infinitely far away, given by a picture of the whole sphere (equirectangular), and directions drawn from
// it where it is bright.
//
// The picture lies in the world: its top row is at +z, its bottom row at -z, its centre column at +y, and to the right
// of the centre comes +x (what one sees who stands upright, z up, and looks along +y). Column and row of direction w:
//   column = width (1/2 + atan2(w.x, w.y) / (2 pi)),  row = height acos(w.z) / pi,
// both rounded down. Radiance is constant within a texel: no filter, so that what is drawn and what is looked up are
// the same function to the last bit.
//
// Directions are drawn with a density proportional to max(luminance - mean luminance, 0): what is darker than the mean
// is left to cosine-weighted directions ([Karlik19]: a map that is combined with another technique does best when it
// leaves to it what that one does well). A map of one colour draws nothing, drawnShare() = 0. Immutable, thread-safe.
// Memory: 20 bytes per texel. Drawing: two binary searches.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace isolume {

class Environment {
 public:
  /// Row-major, top row first; linear radiance, finite and >= 0.
  Environment(glm::ivec2 size, std::vector<glm::vec3> radiance);

  std::size_t memoryBytes() const {
    return radiance_.size() * sizeof(glm::vec3) + (weightUpTo_.size() + rowWeightUpTo_.size()) * sizeof(double);
  }

  /// Radiance from a unit direction (world).
  glm::dvec3 radiance(glm::dvec3 direction) const;

  /// Share of all directions that an estimator should draw from the map: 0 to 1/2.
  double drawnShare() const { return drawnShare_; }
  /// A direction for a point of the unit square; only if drawnShare() > 0.
  glm::dvec3 draw(glm::dvec2 u) const;
  /// Density with which draw() gives that direction, per steradian.
  double density(glm::dvec3 direction) const;

 private:
  std::size_t texelOf(glm::dvec3 direction) const;

  glm::ivec2 size_;
  std::vector<glm::vec3> radiance_;
  std::vector<double> weightUpTo_;     ///< per texel: weight of this and the texels to its left in its row
  std::vector<double> rowWeightUpTo_;  ///< per row: weight of this and the rows above
  double drawnShare_ = 0;
};

}  // namespace isolume
