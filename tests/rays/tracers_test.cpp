// The tracers whose steps are counted: what is certified is right, and the shader's is the shader's.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bench/rays/octant_cubes.h"
#include "bench/rays/picture_judge.h"
#include "bench/rays/random_views.h"
#include "bench/rays/shader_march.h"
#include "bench/rays/sphere_tracers.h"
#include "raymarch/context.h"
#include "reference/random_rays.h"
#include "src/jobs/reference_camera.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/occlusion_sweep.h"

namespace isolume::test {
namespace {

using namespace isolume::bench;

// Lone samples inside: blobs of less than a voxel, and some room between them.
Grid<float> sparse(glm::dvec3 spacing = glm::dvec3(1)) {
  Grid<float> level = noiseLevel({40, 36, 32}, spacing, 11);
  for (std::size_t i = 0; i < level.count(); ++i) level.data()[i] = level.data()[i] > 0.97F ? 0.7F : -0.3F;
  return level;
}

// Many samples exactly at the isovalue, and much inside, where rays start.
Grid<float> plateaus() {
  Grid<float> level = noiseLevel({30, 24, 20}, glm::dvec3(1), 5);
  for (std::size_t i = 0; i < level.count(); ++i) level.data()[i] = std::round(level.data()[i] + 0.4F);
  return level;
}

template <class Trace>
int wrongRays(const RayJudge& judge, const Trace& trace) {
  int wrong = 0;
  for (std::uint64_t number = 0; number < 3000; ++number) {
    GridRay ray = randomRay(judge.tracer().level().size, number);
    ray.direction /= glm::length(ray.direction * judge.scale());
    const Verdict verdict = judge.judge(ray, trace(ray).found);
    wrong += verdict == Verdict::missed || verdict == Verdict::falseHit;
  }
  return wrong;
}

TEST(Tracers, CertifiedBoundsMissNothing) {
  // On scattered thin things no ray is wrong with any bound or relaxation, at equal and unequal spacings; with the
  // bound doubled, or with a swept distance as it is, some are.
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 2, 1.5)}) {
    const Grid<float> level = sparse(spacing);
    const RayJudge judge(level.view());
    const Grid<float> cells = cellLowerBound(level.view()), closest = closestDistance(level.view()),
                      godunov = sweepOcclusion(level.view(), {.visibility = VisibilityStorage::none}).distance;
    const PointBound bounds[] = {cellPointBound(cells.view()),
                                 fieldPointBound(closest.view(), certifyField(level.view(), closest.view())),
                                 fieldPointBound(godunov.view(), certifyField(level.view(), godunov.view()))};
    for (const PointBound& bound : bounds) {
      for (const double omega : {1.0, 1.4, 1.8})
        EXPECT_EQ(wrongRays(judge, [&](const GridRay& ray) { return traceCertified(level.view(), bound, ray, omega); }),
                  0);
    }
    const PointBound doubled = [&](glm::dvec3 p, glm::ivec3 cell) { return 2 * bounds[0](p, cell) + 1; };
    EXPECT_GT(wrongRays(judge, [&](const GridRay& ray) { return traceCertified(level.view(), doubled, ray, 1); }), 10);
    EXPECT_GT(wrongRays(judge, [&](const GridRay& ray) { return traceRaw(level.view(), godunov.view(), ray); }), 10);
  }
}

TEST(Tracers, SamplesAtTheIsovalueAreRightFromBothSides) {
  // Where samples are exactly at the isovalue no ray is wrong, those from within the solid included.
  const Grid<float> level = plateaus();
  const RayJudge judge(level.view());
  const Grid<float> cells = cellLowerBound(level.view());
  const OctantCubes cubes(level.view());
  const PointBound bound = cellPointBound(cells.view());
  EXPECT_EQ(wrongRays(judge, [&](const GridRay& ray) { return traceCertified(level.view(), bound, ray, 1); }), 0);
  EXPECT_EQ(wrongRays(judge, [&](const GridRay& ray) { return cubes.trace(ray); }), 0);
}

TEST(Tracers, OctantCubesAreTheLargestFreeOnes) {
  // For every cell and octant the cube holds no mixed cell, one of the next side would, and no ray through them is
  // wrong.
  const Grid<float> level = sparse({1, 2, 1.5});
  const OctantCubes cubes(level.view());
  const RayJudge judge(level.view());
  EXPECT_EQ(wrongRays(judge, [&](const GridRay& ray) { return cubes.trace(ray); }), 0);
  const glm::ivec3 last = cubes.cells() - 1;
  const auto holdsMixed = [&](glm::ivec3 corner, int octant, int side) {
    for (int z = 0; z < side; ++z)
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          const glm::ivec3 ahead(octant & 1 ? -x : x, octant & 2 ? -y : y, octant & 4 ? -z : z);
          const glm::ivec3 cell = corner + ahead;
          if (cell == glm::clamp(cell, glm::ivec3(0), last) && isMixed(level.view(), cell)) return true;
        }
    return false;
  };
  int bounded = 0;
  for (std::uint64_t number = 0; number < 500; ++number) {
    Random random(number);
    const glm::ivec3 cell(random.below(last.x + 1), random.below(last.y + 1), random.below(last.z + 1));
    const int octant = random.below(kOctantCount), side = cubes.side(cell, octant);
    EXPECT_FALSE(holdsMixed(cell, octant, std::min(side, last.x + 1)));
    if (side > last.x) continue;  // nothing ahead
    ++bounded;
    EXPECT_TRUE(holdsMixed(cell, octant, side + 1));
  }
  EXPECT_GT(bounded, 200);
}

TEST(Tracers, EmptySpaceTakesOneStep) {
  // Without a surface every bound reaches across a small grid at once, and so does the shader's clearance.
  const Grid<float> level = sampleLevel(glm::ivec3(20), glm::dvec3(1), [](glm::dvec3) { return -1; });
  const Grid<float> cells = cellLowerBound(level.view());
  GridRay ray;
  ray.origin = {-5, 3.3, 4.4};
  ray.direction = {1, 0, 0};
  const TracedRay traced = traceCertified(level.view(), cellPointBound(cells.view()), ray, 1);
  EXPECT_EQ(traced.steps, 1);
  EXPECT_EQ(traced.solves, 0);
  EXPECT_FALSE(traced.found);
  const Camera camera{.eye = {-30, 9, 9}, .target = {9, 9, 9}, .heightWorld = 10};
  const ShaderMarch march(level.view());
  const TracedRay leaps =
      march.trace(rayUniforms(camera, {8, 8}, makeGridFrame(glm::dmat4(1)), level.size()), {3, 4}, {8, 8});
  EXPECT_EQ(leaps.steps, 1);
  EXPECT_EQ(leaps.solves, 0);
  EXPECT_FALSE(leaps.found);
}

TEST(Tracers, SolvesOnlyCellsThatMayHoldSurface) {
  // A ray straight at a wall of one voxel's height steps through the free cell before it and solves the wall's cell:
  // between samples 10 and 11, with the bound 9 from the first cell on.
  const Grid<float> level = sampleLevel({20, 6, 6}, glm::dvec3(1), [](glm::dvec3 p) { return p.x - 10.25; });
  const Grid<float> cells = cellLowerBound(level.view());
  GridRay ray;
  ray.origin = {-1, 2.5, 2.5};
  ray.direction = {1, 0, 0};
  const TracedRay traced = traceCertified(level.view(), cellPointBound(cells.view()), ray, 1);
  ASSERT_TRUE(traced.found);
  EXPECT_NEAR(traced.found->x, 10.25, 1e-12);
  EXPECT_EQ(traced.solves, 1);
  // At 0 the bound is 9 less its rounding, which ends in cell 8; its bound is 1 and ends in cell 9; then the wall's.
  EXPECT_LE(traced.steps, 4);
}

TEST(Tracers, ShaderMarchIsTheShader) {
  // The shader's text compiled as C++ finds what the renderer's picture shows: the same pixels but for a few at
  // silhouettes, and the same places to 1e-4 voxel but for a few that graze.
  const Grid<float> level = sparse();
  const ShaderMarch march(level.view());
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  SceneFields fields;
  fields.level = fields.distance = level.view();
  renderer.upload(fields);
  RenderSettings settings{.size = kViewSize, .shading = Shading::local};
  settings.layers = true;
  const glm::dvec3 high(level.size() - 1);
  int hits = 0, differing = 0;
  for (std::uint64_t number = 0; number < kViewKinds; ++number) {
    const Camera camera = randomView({high, glm::dvec3(0), high}, number);
    const Frame frame = renderer.render(camera, settings);
    const auto uniforms = rayUniforms(camera, kViewSize, makeGridFrame(glm::dmat4(1)), level.size());
    for (int y = 0; y < kViewSize.y; y += 3) {
      for (int x = 0; x < kViewSize.x; x += 3) {
        const TracedRay traced = march.trace(uniforms, {x, y}, kViewSize);
        const auto i = static_cast<std::size_t>(y * kViewSize.x + x);
        const bool hit = std::isfinite(frame.depth[i]);
        hits += hit;
        differing += hit != traced.found.has_value() ||
                     (hit && glm::length(glm::dvec3(frame.position[i]) - *traced.found) > 1e-4);
        EXPECT_LE(traced.solves, traced.steps + 1);
      }
    }
  }
  EXPECT_GT(hits, 10'000);
  EXPECT_LE(differing, hits / 1000);
}

}  // namespace
}  // namespace isolume::test
