// Openness by ordinates against Monte Carlo estimates by exact rays.
#include <gtest/gtest.h>

#include <vector>

#include "ordinates/reference_points.h"
#include "ordinates/swept_openness.h"

namespace isolume {
namespace {

constexpr int kSize = 64, kPoints = 300;

std::vector<double> tracedAt(const SurfaceTracer& tracer, const std::vector<ShadedPoint>& points) {
  std::vector<double> traced;
  for (const ShadedPoint& point : points)
    // Standard error about 1e-3.
    traced.push_back(estimateAt({tracer, glm::dmat3(1)}, {}, {.rays = 4096}, point, traced.size()).channels.value[0]);
  return traced;
}

std::vector<double> sweptAt(GridView<const float> level, const std::vector<ShadedPoint>& points, int ordinates) {
  const SurfaceField values = test::opennessOf(level, {.ordinates = ordinates, .refinement = 2});
  std::vector<double> swept;
  for (const ShadedPoint& each : points)
    swept.push_back(wallValueAt(values, level, each.hit.position, each.normal) / test::kOpen);
  return swept;
}

// With 1024 ordinates the RMSE is below `bound`, 1.2 times what was measured, and 64 have at least `ratio` times as
// much. From what 4096 ordinates give 64 are off by at least 4 times as much as 1024 (measured: 7.7 to 8.8; K^-3/4: 8).
void expectConvergence(const char* name, double bound, double ratio) {
  const Grid<float> level = test::sceneLevel(name, kSize);
  const SurfaceTracer tracer(level.view());
  const std::vector<ShadedPoint> points = test::randomSurfacePoints(tracer, kPoints);
  const std::vector<double> want = tracedAt(tracer, points);
  const std::vector<double> few = sweptAt(level.view(), points, 64), many = sweptAt(level.view(), points, 1024),
                            most = sweptAt(level.view(), points, 4096);
  EXPECT_LT(test::rmsDifference(many, want), bound);
  EXPECT_GT(test::rmsDifference(few, want), ratio * test::rmsDifference(many, want));
  EXPECT_GT(test::rmsDifference(few, most), 4 * test::rmsDifference(many, most));
}

TEST(OpennessReference, Corner) {
  // Measured: .0172; a lift by .7 of a cell has .0128 at these points, and darkens planes by up to .1.
  expectConvergence("corner", 0.0207, 1.3);
}

TEST(OpennessReference, Gyroid) {
  // Measured with a lift by .7: .0373, and only 1.13 times as much with 64 ordinates: at this size the error is that of
  // the values at samples of walls a few voxels apart, which no number of ordinates removes (.0372 with 4096).
  expectConvergence("gyroid", 0.0447, 1);
}

TEST(OpennessReference, Capsules) {
  // Measured with a lift by .7: .0286, and 1.88 times as much with 64 ordinates.
  expectConvergence("capsules", 0.0343, 1.3);
}

}  // namespace
}  // namespace isolume
