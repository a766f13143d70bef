// The judge of rays judged: right answers pass, wrong ones are named, and rounding is told from error.
#include "bench/rays/ray_judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "reference/random_rays.h"
#include "support/test_levels.h"

namespace isolume::test {
namespace {

using bench::HitQuality;
using bench::RayJudge;
using bench::Verdict;

const Grid<float>& ball() {
  static const Grid<float> level = ballLevel(32, 10.3, {15.6, 15.1, 15.4});
  return level;
}

GridRay unitRay(glm::ivec3 size, std::uint64_t number) {
  GridRay ray = randomRay(size, number);
  ray.direction = glm::normalize(ray.direction);
  return ray;
}

TEST(RayJudge, RightAnswersAgreeAndWrongOnesAreNamed) {
  // The exact hit agrees; without it a surface is missed; moved by a tenth of a voxel, or put where there is none, it
  // is false, unless the ray runs along the surface.
  const RayJudge judge(ball().view());
  int hits = 0, misses = 0, wrong = 0;
  for (std::uint64_t number = 0; number < 2000; ++number) {
    const GridRay ray = unitRay(ball().size(), number);
    const auto hit = judge.tracer().firstHit(ray);
    if (!hit) {
      ++misses;
      EXPECT_EQ(judge.judge(ray, std::nullopt), Verdict::agrees);
      EXPECT_EQ(judge.judge(ray, ray.origin + 20.0 * ray.direction), Verdict::falseHit) << number;
      continue;
    }
    ++hits;
    EXPECT_EQ(judge.judge(ray, hit->position), Verdict::agrees);
    EXPECT_EQ(judge.judge(ray, hit->position + 0.9e-3 * ray.direction), Verdict::agrees);
    const Verdict without = judge.judge(ray, std::nullopt);
    const Verdict early = judge.judge(ray, hit->position - 0.1 * ray.direction);
    const Verdict late = judge.judge(ray, hit->position + 0.1 * ray.direction);
    wrong += without == Verdict::missed && early == Verdict::falseHit && late == Verdict::missed;
  }
  EXPECT_GT(misses, 400);
  EXPECT_GT(hits, 400);
  EXPECT_GE(wrong, hits - 10) << "rays that graze the ball";
}

TEST(RayJudge, GrazingRaysMayGoEitherWay) {
  // A ray that enters a ball by 1e-6 voxel at its rim may miss it; one that enters by 1e-3 voxel may not.
  const RayJudge judge(ball().view());
  for (const double depth : {1e-6, 1e-3}) {
    // The rim of the interpolated ball along this line, by halving.
    GridRay ray;
    ray.direction = {0, 0, 1};
    double inside = 10, outside = 10.6;
    constexpr int kHalvings = 50;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (inside + outside) / 2;
      ray.origin = {15.6 + middle, 15.1, -5};
      (judge.tracer().firstHit(ray) ? inside : outside) = middle;
    }
    ray.origin = {15.6 + inside - depth, 15.1, -5};
    ASSERT_TRUE(judge.tracer().firstHit(ray));
    EXPECT_EQ(judge.judge(ray, std::nullopt), depth < 1e-5 ? Verdict::grazing : Verdict::missed);
    ray.origin.x = 15.6 + inside;
    const glm::dvec3 atRim = judge.tracer().firstHit(ray)->position;
    ray.origin.x = 15.6 + outside + depth;
    ASSERT_FALSE(judge.tracer().firstHit(ray));
    EXPECT_EQ(judge.judge(ray, atRim), depth < 1e-5 ? Verdict::grazing : Verdict::falseHit) << depth;
  }
}

TEST(RayJudge, ALevelThatOnlyRoundingLiftsIsATie) {
  // A sheet whose level is above 0 by less than float's rounding of its cells may be passed; a higher one may not.
  for (const double height : {1e-8, 1e-3}) {
    const Grid<float> level =
        sampleLevel({9, 9, 9}, glm::dvec3(1), [=](glm::dvec3 p) { return p.x == 4 ? height : -1; });
    const RayJudge judge(level.view());
    GridRay ray;
    ray.origin = {-3, 3.3, 4.4};
    ray.direction = glm::normalize(glm::dvec3(1, 0.01, 0.02));
    ASSERT_TRUE(judge.tracer().firstHit(ray));
    EXPECT_EQ(judge.judge(ray, std::nullopt), height < 1e-6 ? Verdict::tie : Verdict::missed);
  }
}

TEST(RayJudge, MeasuresHowFarAHitIsFromTheSurface) {
  // A hit moved along its ray is found to be that far off, in voxels, on a grid of any spacing; a cap is told apart.
  const glm::dvec3 spacing(0.5, 1, 0.75);
  const Grid<float> level =
      sampleLevel({60, 30, 40}, spacing, [](glm::dvec3 p) { return 9 - glm::length(p - glm::dvec3(15, 14, 15)); });
  const RayJudge judge(level.view());
  EXPECT_EQ(judge.scale(), glm::dvec3(1, 2, 1.5));
  int measured = 0;
  for (std::uint64_t number = 0; number < 500; ++number) {
    GridRay ray = randomRay(level.size(), number);
    ray.direction /= glm::length(ray.direction * judge.scale());
    const auto hit = judge.tracer().firstHit(ray);
    if (!hit || hit->capAxis >= 0) continue;
    const glm::dvec3 forward = ray.direction * judge.scale();
    const double facing = std::abs(glm::dot(glm::normalize(judge.cellGradient(hit->position)), forward));
    if (facing < 0.3) continue;
    ++measured;
    for (const double off : {0.0, 1e-3, -2e-3}) {
      const HitQuality quality = judge.quality(ray, hit->position + off * ray.direction);
      EXPECT_FALSE(quality.cap);
      EXPECT_NEAR(quality.distance, std::abs(off), 1e-8);
      // The level is nearly a distance: its gradient is 1 to a few hundredths.
      EXPECT_NEAR(quality.across, std::abs(off) * facing, 0.02 * std::abs(off) + 1e-8);
    }
  }
  EXPECT_GT(measured, 100);
  EXPECT_TRUE(judge.quality({}, {0, 7, 7}).cap);
}

}  // namespace
}  // namespace isolume::test
