// How much of a ray lies in the solid, against the crossings that halving in long double finds.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/brute_force.h"
#include "reference/random_rays.h"
#include "support/test_levels.h"
#include "sweep/reference/surface_tracer.h"

namespace isolume::test {
namespace {

// Past a crossing by this much the level has the other sign, or the ray only touches the surface.
constexpr long double kPast = 1e-9L;

struct Crossed {
  long double inside = 0;
  int crossings = 0;
};
Crossed crossedByHalving(GridView<const float> level, const SurfaceTracer& tracer, const GridRay& ray,
                         const BoxSpan& span) {
  Crossed crossed;
  long double t = span.begin;
  const auto start = static_cast<double>(t + kPast);
  bool inside =
      tracer.levelAt(glm::clamp(ray.origin + start * ray.direction, glm::dvec3(0), glm::dvec3(level.size - 1))) > 0;
  for (;;) {
    const auto next = firstRiseByHalving(level, ray, t + kPast, inside);
    const long double until = next ? *next : span.end;
    if (inside) crossed.inside += until - t;
    if (!next) return crossed;
    t = until;
    inside = !inside;
    ++crossed.crossings;
  }
}

// The same from lengthInside(): from where the ray enters the box, or starts in it.
double lengthFrom(const SurfaceTracer& tracer, GridRay ray, const BoxSpan& span) {
  ray.start = static_cast<double>(span.begin);
  return tracer.lengthInside(ray);
}

TEST(LengthInside, SumsWhatLiesBetweenCrossings) {
  // In noise, where a ray crosses the surface dozens of times, the length is the sum over the pieces inside, to what
  // each of the crossings may be off by.
  const Grid<float> level = noiseLevel({19, 23, 16}, glm::dvec3(1), 7);
  const SurfaceTracer tracer(level.view());
  int judged = 0, crossings = 0;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    const GridRay ray = randomRay(level.size(), i);
    const auto span = boxSpan(level.size(), ray);
    // What only touches the box.
    if (!span || span->end - span->begin < 1e-6L) continue;
    const Crossed want = crossedByHalving(level.view(), tracer, ray, *span);
    const double bound = 4 * static_cast<double>(kPast) * (want.crossings + 1);
    EXPECT_NEAR(lengthFrom(tracer, ray, *span), static_cast<double>(want.inside), bound) << i;
    ++judged;
    crossings += want.crossings;
  }
  EXPECT_GT(judged, 1000);
  EXPECT_GT(crossings, 5 * judged);
}

TEST(LengthInside, WhatIsNotInsideIsOutside) {
  // With the sign of the level turned, a ray is inside where it was outside: both lengths sum to its way through the
  // box, to rounding.
  const Grid<float> level = noiseLevel({19, 23, 16}, glm::dvec3(1), 9);
  Grid<float> turned = noiseLevel({19, 23, 16}, glm::dvec3(1), 9);
  for (std::size_t i = 0; i < turned.count(); ++i) turned.data()[i] = -turned.data()[i];
  const SurfaceTracer tracer(level.view()), other(turned.view());
  int judged = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const GridRay ray = randomRay(level.size(), i);
    const auto span = boxSpan(level.size(), ray);
    if (!span || span->end - span->begin < 1e-6L) continue;
    const double both = lengthFrom(tracer, ray, *span) + lengthFrom(other, ray, *span);
    const auto way = static_cast<double>(span->end - span->begin);
    EXPECT_NEAR(both, way, 1e-12 * (1 + way)) << i;
    ++judged;
  }
  EXPECT_GT(judged, 3000);
}

}  // namespace
}  // namespace isolume::test
