#include "ordinates/blocked_feet.h"

#include <algorithm>
#include <glm/common.hpp>
#include <vector>

#include "sweep/closest/closest_distance.h"
#include "sweep/ordinates/ordinate_set.h"
#include "sweep/ordinates/sheared_rays.h"
#include "sweep/ordinates/surface_feet.h"

namespace isolume::test {

int blockedFeet(GridView<const float> level, const OrdinateOptions& options, double lift, double margin) {
  constexpr std::size_t kWidestVector = 64;
  const Grid<float> distance = closestDistance(level);
  const SurfaceFeet surface(level, distance.view());
  const std::vector<SurfaceFoot>& feet = surface.feet();
  const SolidLattice lattice = makeSolidLattice(level, surface.solid(), options.refinement);
  RayPoints points(feet.size());
  std::vector<bool> blocked(feet.size());
  for (int axis = 0; axis < 3; ++axis) {
    points.sort(feet, lattice, level.spacing, lift, axis);
    const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
    std::vector<std::int32_t> sums(feet.size() + kWidestVector, 0);
    for (const int towards : {1, -1}) {
      std::vector<RayDirection> group;
      const auto sweepGroup = [&] {
        sweepRays(layersOf(lattice, axis), towards, group, points, 1 << 20, sums.data());
        group.clear();
      };
      for (const glm::dvec3& w : ordinateDirections(options.ordinates)) {
        const glm::dvec3 steps = w / level.spacing, size = glm::abs(steps);
        if (size[axis] < std::max({size.x, size.y, size.z}) || (w[axis] > 0) != (towards > 0)) continue;
        group.push_back({static_cast<float>(w[axes.bit]), static_cast<float>(w[axes.row]), static_cast<float>(w[axis]),
                         steps[axes.bit] / steps[axis], steps[axes.row] / steps[axis]});
        if (group.size() == kRayGroup) sweepGroup();
      }
      sweepGroup();
    }
    for (std::size_t i = 0; i < feet.size(); ++i)
      if (sums[i] != 0) blocked[points.foot()[i]] = true;
  }
  int count = 0;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const glm::vec3 fromBorder = glm::min(feet[i].position, glm::vec3(level.size - 1) - feet[i].position);
    count += blocked[i] && std::min({fromBorder.x, fromBorder.y, fromBorder.z}) >= margin ? 1 : 0;
  }
  return count;
}

}  // namespace isolume::test
