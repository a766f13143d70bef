// The exact tracer against Embree on a mesh of the same volume: another method, another author.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "reference/random_rays.h"
#include "support/embree_scene.h"
#include "support/test_levels.h"
#include "support/tetra_mesh.h"
#include "sweep/level.h"
#include "sweep/reference/surface_tracer.h"
#include "volumes/scenes.h"

namespace isolume::test {
namespace {

// From outside, with a unit direction.
GridRay outsideRay(glm::ivec3 size, std::uint64_t number) {
  Random random(number);
  const glm::dvec3 high(size - 1);
  GridRay ray;
  ray.origin = 0.5 * high + glm::length(high) * random.direction();
  ray.direction = glm::normalize(random.pointIn(glm::dvec3(0), high) - ray.origin);
  return ray;
}

TEST(EmbreeHits, Ball) {
  // On a ball both tracers hit the same rays, and apart by no more than what the mesh and the interpolant are off.
  const double radius = 20;
  const glm::dvec3 centre(23.4, 23.9, 23.2);
  const Grid<float> level = ballLevel(48, radius, centre);
  const SurfaceTracer tracer(level.view());
  const EmbreeScene embree(tetraMesh(level.view()));
  // Trilinear: an eighth of the second derivatives, 2 / r. Linear in a tetrahedron: an eighth of the square of its
  // longest edge, 3, times the largest, 1 / r. Both in space; r > radius - 1.
  const double bound = (2.0 / 8 + 3.0 / 8) / (radius - 1);
  int hits = 0, apart = 0;
  for (std::uint64_t i = 0; i < 50'000; ++i) {
    const GridRay ray = outsideRay(level.size(), i);
    const auto exact = tracer.firstHit(ray);
    const auto mesh = embree.firstHit(ray);
    const double pass = glm::length(glm::cross(centre - ray.origin, ray.direction));
    if (std::abs(pass - radius) > bound) {
      ASSERT_EQ(exact.has_value(), mesh.has_value()) << i;
    }
    apart += exact.has_value() != mesh.has_value();
    if (!exact || !mesh) continue;
    const double cosine = -glm::dot(ray.direction, glm::normalize(exact->position - centre));
    if (cosine < 0.3) continue;
    ++hits;
    // Both surfaces turn by bound / (radius cosine^2), 2 %, over the way between them; floats add 1e-5.
    ASSERT_LE(std::abs(exact->t - *mesh) * cosine, 1.02 * bound + 1e-5) << i;
  }
  EXPECT_GT(hits, 20'000);
  EXPECT_LT(apart, 100);
}

TEST(EmbreeHits, CapsOfACutSolid) {
  // A plane that the box cuts, which both represent exactly, is hit in the same places, caps and all.
  const Grid<float> level =
      sampleLevel({20, 17, 33}, glm::dvec3(1), [](glm::dvec3 p) { return 4.375 + 0.25 * p.x + 0.5 * p.y - p.z; });
  const SurfaceTracer tracer(level.view());
  const EmbreeScene embree(tetraMesh(level.view()));
  int onCaps = 0, apart = 0;
  for (std::uint64_t i = 0; i < 50'000; ++i) {
    const GridRay ray = outsideRay(level.size(), i);
    const auto exact = tracer.firstHit(ray);
    const auto mesh = embree.firstHit(ray);
    apart += exact.has_value() != mesh.has_value();
    if (!exact || !mesh) continue;
    onCaps += exact->capAxis >= 0;
    // Floats: 6e-8 of coordinates up to 100, over the cosine, which for a few rays is 1e-2.
    apart += std::abs(exact->t - *mesh) > 1e-3;
  }
  EXPECT_GT(onCaps, 10'000);
  EXPECT_LE(apart, 10) << "rays along an edge of the box";
}

TEST(EmbreeHits, Gyroid) {
  // On a gyroid sheet, cut by a ball, both tracers agree but next to silhouettes, which few rays see.
  Grid<float> level = sampleScene(*findScene("gyroid"), 96);
  makeLevel(level.view(), 0, Inside::below);
  const SurfaceTracer tracer(level.view());
  const EmbreeScene embree(tetraMesh(level.view()));
  int hits = 0, oneOnly = 0, far = 0, blockedApart = 0;
  const int count = 50'000;
  for (std::uint64_t i = 0; i < count; ++i) {
    const GridRay ray = outsideRay(level.size(), i);
    const auto exact = tracer.firstHit(ray);
    const auto mesh = embree.firstHit(ray);
    oneOnly += exact.has_value() != mesh.has_value();
    blockedApart += embree.isBlocked(ray) != mesh.has_value();
    if (!exact || !mesh) continue;
    const double cosine = glm::dot(ray.direction, glm::normalize(tracer.cellGradient(exact->position)));
    // The crease along which the ball cuts the sheet is rounded off by up to a voxel, by either in its own way.
    const double fromBall = glm::distance(exact->position, glm::dvec3(47.5)) - 0.42 * 96;
    if (std::abs(fromBall) < 2) continue;
    // 32 voxels to a period: second differences are 2 pi / 32 = .2 of the slope, and the mesh is off by up to 5/8 of
    // it.
    if (cosine < 0.3) continue;
    ++hits;
    far += std::abs(exact->t - *mesh) * cosine > 0.125;
  }
  EXPECT_GT(hits, count / 4);
  EXPECT_LT(oneOnly, count / 500);
  // Past a silhouette the two can go on to different sheets.
  EXPECT_LT(far, hits / 50);
  EXPECT_EQ(blockedApart, 0);
  RecordProperty("oneOnly", oneOnly);
  RecordProperty("far", far);
}

}  // namespace
}  // namespace isolume::test
