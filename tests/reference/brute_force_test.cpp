// The exact tracer against brute force: no miss, no false hit, on sample scenes and real volumes.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "io/volume.h"
#include "reference/hit_judge.h"
#include "reference/random_rays.h"
#include "support/cpu_tracer.h"
#include "support/shared_data.h"
#include "support/test_levels.h"
#include "sweep/level.h"
#include "volumes/scenes.h"

namespace isolume::test {
namespace {

// Rays per volume: ISOLUME_HIT_RAYS, 10^7 for the full run.
std::int64_t rayCount() {
  const char* text = std::getenv("ISOLUME_HIT_RAYS");
  return text ? std::atoll(text) : 100'000;
}

// Ties are rays that touch the surface. Of random ones hardly any does; of those along lattice lines (1 in 8) some do
// where samples lie at the isovalue.
HitCounts expectNoneWrong(GridView<const float> level, std::int64_t count, double tieShare = 1e-3) {
  const HitCounts counts = judgeHits(SurfaceTracer(level), 0, count);
  EXPECT_EQ(counts.wrong, 0) << counts.firstWrong;
  EXPECT_LE(static_cast<double>(counts.ties), tieShare * static_cast<double>(count)) << counts.text();
  std::cout << counts.text() << "\n";
  return counts;
}

Grid<float> sceneLevel(std::string_view name, int size) {
  Grid<float> level = sampleScene(*findScene(name), size);
  makeLevel(level.view(), 0, Inside::below);
  return level;
}

class SceneHits : public testing::TestWithParam<std::string_view> {};

TEST_P(SceneHits, AgainstBruteForce) {
  // On a sample scene every hit is where brute force in long double finds it, and there is no other.
  const Grid<float> level = sceneLevel(GetParam(), 64);
  const HitCounts counts = expectNoneWrong(level.view(), rayCount());
  EXPECT_GT(counts.hits, counts.rays / 10);
  EXPECT_GT(counts.blocked, counts.leaving / 4);
  EXPECT_LT(counts.grazing, counts.leaving / 50);
}

TEST_P(SceneHits, AgainstBernsteinTracer) {
  // The tracer that pictures are compared with, which visits every cell in double, finds the same first hits.
  const Grid<float> level = sceneLevel(GetParam(), 40);
  const SurfaceTracer tracer(level.view());
  int compared = 0, apart = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const GridRay ray = randomRay(level.size(), i);
    const auto got = tracer.firstHit(ray);
    const auto want = traceLevel(level.view(), {ray.origin, ray.direction});
    if (want && want->t == 0) continue;  // it starts inside, which that tracer does not know
    ++compared;
    const bool same =
        got.has_value() == want.has_value() &&
        (!got || (glm::length(got->position - want->position) < 1e-9 && (got->capAxis >= 0) == (want->capAxis >= 0)));
    apart += !same;
  }
  EXPECT_GT(compared, 3000);
  // Both round, and differ where a ray touches or enters through an edge of the box.
  EXPECT_LE(apart, 4);
}

INSTANTIATE_TEST_SUITE_P(All, SceneHits, testing::ValuesIn(sceneNames()),
                         [](const auto& scene) { return std::string(scene.param); });

void expectHitsOf(const std::string& path, float isovalue) {
  Volume volume = readVolume(path);
  makeLevel(volume.values.view(), isovalue, Inside::above);
  const HitCounts counts = expectNoneWrong(volume.values.view(), rayCount());
  EXPECT_GT(counts.hits, counts.rays / 20);
}

TEST(RealHits, Cranium) {
  // On a head CT of whole numbers, some at the isovalue, no hit is missed and none is false.
  ISOLUME_NEED_SHARED(path, "cranium.mhd");
  expectHitsOf(path, 300);
}

#ifdef ISOLUME_HAVE_ITK
TEST(RealHits, Mni152) {
  // On a brain template no hit is missed and none is false.
  ISOLUME_NEED_SHARED(path, "mni152_2009.nii.gz");
  expectHitsOf(path, 600);
}

TEST(RealHits, BetaGal) {
  // On a noisy density map no hit is missed and none is false.
  ISOLUME_NEED_SHARED(path, "betaGal.mrc");
  expectHitsOf(path, 0.06F);
}
#endif

TEST(NoiseHits, AgainstBruteForce) {
  // In noise, where every cell has its own cubic with up to three roots, no hit is missed and none is false.
  const Grid<float> level = noiseLevel({19, 33, 6}, glm::dvec3(1), 7);
  const HitCounts counts = expectNoneWrong(level.view(), rayCount());
  EXPECT_GT(counts.inside, counts.rays / 20);
  EXPECT_GT(counts.caps, counts.rays / 10);
}

TEST(NoiseHits, WholeNumbers) {
  // Where a third of the samples lie at the isovalue, so that whole faces and cells do, no hit is missed or false.
  Grid<float> level = noiseLevel({24, 17, 20}, glm::dvec3(1), 8);
  for (std::size_t i = 0; i < level.count(); ++i) level.data()[i] = std::round(level.data()[i] * 1.5F);
  expectNoneWrong(level.view(), rayCount(), 0.01);
}

TEST(NoiseHits, FarApartSizes) {
  // With levels from 1e-4 to 1e4 side by side no hit is missed and none is false.
  Grid<float> level = noiseLevel({24, 17, 20}, glm::dvec3(1), 9);
  for (std::size_t i = 0; i < level.count(); ++i) {
    const float x = level.data()[i];
    level.data()[i] = std::copysign(std::pow(10.0F, 8 * std::abs(x) - 4), x);
  }
  // What is 0 to the rounding of a cell's largest corner is wide next to its small ones.
  expectNoneWrong(level.view(), rayCount(), 0.01);
}

}  // namespace
}  // namespace isolume::test
