#include "ordinate_groups.h"

#include "sweep/octants.h"
#include "sweep/ordinates/ordinate_set.h"

namespace isolume {

std::vector<OrdinateGroup> ordinateGroups(int ordinates, int most) {
  const std::vector<glm::dvec3> all = ordinateDirections(ordinates);
  std::vector<OrdinateGroup> groups;
  for (const Octant& octant : kOctants) {
    std::vector<glm::dvec3> own;
    for (const glm::dvec3& direction : all) {
      const glm::ivec3 away(direction.x < 0 ? 1 : -1, direction.y < 0 ? 1 : -1, direction.z < 0 ? 1 : -1);
      if (away == octant.sweep) own.push_back(direction);
    }
    const std::size_t count = (own.size() + static_cast<std::size_t>(most) - 1) / static_cast<std::size_t>(most);
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = [&](std::size_t k) { return own.begin() + static_cast<std::ptrdiff_t>(k * own.size() / count); };
      groups.push_back({octant.sweep, {at(i), at(i + 1)}});
    }
  }
  return groups;
}

}  // namespace isolume
