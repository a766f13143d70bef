// Planes cut by nothing: what their own steps in the lattice block.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ordinates/swept_openness.h"
#include "support/random_numbers.h"

namespace isolume {
namespace {

constexpr int kTilts = 200, kSize = 24, kOrdinates = 512;
constexpr glm::dvec3 kSpacings[] = {{1, 1, 1}, {1, 2, 3}, {3, 1, 2}};

// A plane through the middle of the grid, between samples.
Grid<float> planeLevel(glm::dvec3 normal, glm::dvec3 spacing) {
  const glm::dvec3 centre = glm::dvec3((kSize - 1) / 2.0) * spacing + glm::dvec3(0.1, 0.23, 0.31) * spacing;
  return test::sampleLevel(glm::ivec3(kSize), spacing, [&](glm::dvec3 p) { return glm::dot(normal, centre - p); });
}

template <class Visit>
void forEachTilt(const Visit& visit) {
  for (const glm::dvec3& spacing : kSpacings)
    for (const int refinement : {1, 2}) {
      test::RandomNumbers numbers(9);
      for (int i = 0; i < kTilts; ++i) visit(numbers.direction(), spacing, refinement);
    }
}

// Closer to the border the closest point of the plane may lie beyond the grid, and a sample's distance is another's.
int marginOf(glm::dvec3 spacing) {
  return static_cast<int>(std::ceil(glm::length(spacing) / smallestSpacing(spacing))) + 1;
}

// Largest deviation from 1 of the samples next to the plane, away from the border.
struct Deviation {
  double largest = 0;
};
Deviation deviationOf(glm::dvec3 normal, glm::dvec3 spacing, int refinement) {
  const Grid<float> level = planeLevel(normal, spacing);
  const SurfaceField values = test::opennessOf(level.view(), {.ordinates = kOrdinates, .refinement = refinement});
  Deviation found;
  test::forEachWithin(level.size(), marginOf(spacing), [&](glm::ivec3 at) {
    if (!test::isNextToSurface(level.view(), at)) return;
    const double deviation = 1 - values.wall(at) / test::kOpen;
    found.largest = std::max(found.largest, deviation);
  });
  return found;
}

TEST(OpenPlane, IsOpenEverywhere) {
  // Every sample next to a plane is open to .01, whatever the tilt, the spacing and the refinement. Without what low
  // rays are lifted by, nearly aligned planes block up to .1 of a sample's light.
  forEachTilt([&](glm::dvec3 normal, glm::dvec3 spacing, int refinement) {
    EXPECT_LT(deviationOf(normal, spacing, refinement).largest, 0.01)
        << normal.x << " " << normal.y << " " << normal.z << " refinement " << refinement;
  });
}

}  // namespace
}  // namespace isolume
