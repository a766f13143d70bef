#include "surface_band.h"

#include <algorithm>

#include "band_solver.h"

namespace isolume {
namespace {

// Rounds of taking over neighbours' points, each one sample further. Less than ten change anything but a few samples
// unless one spacing is many times another.
constexpr int kRelaxations = 64;

// Layers of each kind. Together they cover the samples up to k steps from a cell along each axis, k + edges + corners
// along any two together and k + edges + 2 corners along all three, in any order: sets of that kind add up so.
struct Layers {
  int faces = 0, edges = 0, corners = 0;
};

// The fewest steps for k layers: samples (a, b, c) steps from a cell must be in if a^2 + b^2 + c^2 < (k + 1)^2.
Layers layersFor(int k) {
  int two = k, three = k;
  const int limit = (k + 1) * (k + 1);
  for (int a = 0; a <= k; ++a)
    for (int b = 0; b <= a; ++b)
      for (int c = 0; c <= b; ++c) {
        if (a * a + b * b + c * c >= limit) continue;
        two = std::max(two, a + b);
        three = std::max(three, a + b + c);
      }
  const int corners = three - two, edges = std::max(two - k - corners, 0);
  return {k - edges - corners, edges, corners};
}

}  // namespace

BitGrid solveBand(GridView<const float> level, int layers, OffsetField& field) {
  BitGrid set(level.size);
  BandSolver solver(level, field, set);
  {
    const BitGrid inside = insideSamples(level);
    solver.seed(inside);
    solver.growToCorners(inside);
    solver.reseedCorners(inside);
  }
  const Layers each = layersFor(layers);
  for (int i = 0; i < each.corners; ++i) solver.grow(Across::corners);
  for (int i = 0; i < each.edges; ++i) solver.grow(Across::edges);
  for (int i = 0; i < each.faces; ++i) solver.grow(Across::faces);
  solver.relax(kRelaxations);
  return set;
}

}  // namespace isolume
