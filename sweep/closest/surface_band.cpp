#include "surface_band.h"

#include <cmath>

#include "band_solver.h"

namespace isolume {
namespace {

// Rounds of taking over neighbours' points, each one sample further. Less than ten change anything but a few samples
// unless one spacing is many times another.
constexpr int kRelaxations = 64;

// Steps that growth so far can have gone along two axes together, and along three: what it covers are the samples
// within a steps along each axis, two + ... of any two, three of all.
struct Coverage {
  int two = 0, three = 0;
  // With k layers, samples (a, b, c) steps from a cell must be in if a^2 + b^2 + c^2 < (k + 1)^2, so that
  // a + b < sqrt(2) (k + 1) and a + b + c < sqrt(3) (k + 1). Would a layer across faces alone leave some out?
  bool needsCorners(int layers) const {
    const double reach = layers + 1;
    return two + 2 < std::sqrt(2.0) * reach || three + 2 < std::sqrt(3.0) * reach;
  }
};

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
  Coverage covered;
  for (int layer = 1; layer <= layers; ++layer) {
    if (covered.needsCorners(layer)) {
      solver.grow();
      covered.two += 2;
      covered.three += 3;
    } else {
      solver.growAcrossFaces();
      covered.two += 1;
      covered.three += 1;
    }
  }
  solver.relax(kRelaxations);
  return set;
}

}  // namespace isolume
