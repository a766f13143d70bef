// A level with what all sweeps of light over it share.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "support/octant_openness.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/ordinates/light_sweeps.h"

namespace isolume::test {

/// The rays borrow the fields, so this stays where it is.
struct SweptScene {
  SweptScene(Grid<float> level_, int refinement)
      : level(std::move(level_)),
        distance(closestDistance(level.view(), {.extent = DistanceExtent::band})),
        rays(level.view(), distance.view(), refinement),
        feet_(rays.surface().makeFeet()) {}
  SweptScene(glm::ivec3 size, glm::dvec3 spacing, int refinement, const std::function<double(glm::dvec3)>& f)
      : SweptScene(sampleLevel(size, spacing, f), refinement) {}
  SweptScene(const SweptScene&) = delete;
  SweptScene& operator=(const SweptScene&) = delete;

  const std::vector<SurfaceFoot>& feet() const { return feet_; }
  /// At least that far from the border of the grid, in samples.
  bool isWithin(const SurfaceFoot& foot, double margin) const {
    const glm::dvec3 at(foot.position), most = glm::dvec3(level.size() - 1) - margin;
    return at.x >= margin && at.y >= margin && at.z >= margin && at.x <= most.x && at.y <= most.y && at.z <= most.z;
  }

  Grid<float> level, distance;
  SurfaceRays rays;

 private:
  std::vector<SurfaceFoot> feet_;
};

/// At a point of index space.
inline double lightAt(const SweptLight& light, glm::dvec3 position) {
  constexpr double kFull = 65535;
  return surfaceValueAt(light.values, position) * static_cast<double>(light.full) / kFull;
}

}  // namespace isolume::test
