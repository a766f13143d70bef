#include "surface_band.h"

#include "band_solver.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// Rounds of taking over neighbours' points: each carries a better point one sample further, and so many cross the band.
constexpr int kRelaxations = 8;

}  // namespace

BitGrid solveBand(GridView<const float> level, int layers, OffsetField& field) {
  BitGrid set(level.size);
  BandSolver solver(level, field, set);
  {
    BitGrid inside(level.size);
    parallelFor(static_cast<std::size_t>(level.size.z), [&](std::size_t z) {
      for (int y = 0; y < level.size.y; ++y) signRow(level, y, static_cast<int>(z), inside);
    });
    solver.seed(inside);
    solver.growToCorners(inside);
  }
  for (int layer = 0; layer < layers; ++layer) solver.grow();
  solver.relax(kRelaxations);
  return set;
}

}  // namespace isolume
