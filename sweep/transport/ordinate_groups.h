// Ordinates that are swept together in SIMD lanes: all of an octant.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace isolume {

struct OrdinateGroup {
  glm::ivec3 sweep{1};                 ///< away from the light
  std::vector<glm::dvec3> directions;  ///< towards it
};

/// `ordinates` directions of ordinate_set.h, those of an octant in groups of like size, up to `most` in each.
std::vector<OrdinateGroup> ordinateGroups(int ordinates, int most);

}  // namespace isolume
