// Small random levels of every degenerate kind, and the symmetries of a grid.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "sweep/grid.h"

namespace isolume::test {

struct RandomGrid {
  std::string name;  ///< kind, size and spacing, for messages
  Grid<float> level;
};

/// Grid i of an endless list, at most 8^3 samples: single samples, lines, planes and boxes; noise, plateaus, samples
/// exactly at the isovalue, magnitudes of 1e-30 and 1e30 side by side, all inside, all outside, single samples inside;
/// spacings from equal to 1:1:1000.
RandomGrid randomGrid(int i);

/// Axis k mirrored if bit k of `axes` is set.
Grid<float> mirrored(const Grid<float>& grid, int axes);
/// Axes in the order `order` (0 to 5) of their six orders.
Grid<float> permuted(const Grid<float>& grid, int order);

/// A sample from which the surface is `along` away on one of its edges; a solid sample on the border is 0 away.
struct Crossing {
  glm::dvec3 sample{0};
  double along = 0;
};
std::vector<Crossing> crossings(GridView<const float> level);

}  // namespace isolume::test
