// Solids whose trilinear surface is the closed form's own, and the closed forms.
//
// Faces that lie on planes of samples are exact: in the cell next to a face the level is linear across it, next to an
// edge it is a product that vanishes on both faces. All lengths below are in samples unless a spacing is given.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "support/test_levels.h"
#include "sweep/reference/reference.h"

namespace isolume::test {

inline constexpr double kPi = std::numbers::pi;

/// A level with its tracer. The tracer borrows the level, so this stays where it is.
struct TestScene {
  TestScene(glm::ivec3 size, glm::dvec3 spacing, const std::function<double(glm::dvec3)>& f)
      : level(sampleLevel(size, spacing, f)), tracer(level.view()) {}
  TestScene(const TestScene&) = delete;
  TestScene& operator=(const TestScene&) = delete;

  ReferenceScene scene() const { return {tracer, glm::dmat3(1)}; }

  Grid<float> level;
  SurfaceTracer tracer;
};

/// A point that is known to lie on the surface (index space), with its normal.
inline ShadedPoint pointOn(glm::dvec3 position, glm::dvec3 normal = {0, 0, 1}) { return {{0, position, -1}, normal}; }

/// Solid below z = floor.
inline double floorLevel(glm::dvec3 p, double floor) { return floor - p.z; }

/// Form factor from a small patch to a parallel rectangle a x b at distance c, one corner of it on the patch's axis.
inline double parallelRectangle(double a, double b, double c) {
  const double ac = std::hypot(a, c), bc = std::hypot(b, c);
  return (a / ac * std::atan(b / ac) + b / bc * std::atan(a / bc)) / (2 * kPi);
}

/// Form factor from a small patch to a rectangle that stands on the patch's plane at distance c: `height` high, from
/// the foot of the perpendicular to `width` along the plane.
inline double uprightRectangle(double width, double height, double c) {
  const double top = std::hypot(height, c);
  return (std::atan(width / c) - c / top * std::atan(width / top)) / (2 * kPi);
}

/// The mean of f over the unit square by the midpoint rule with n x n points.
inline double squareMean(int n, const std::function<double(double, double)>& f) {
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) sum += f((i + 0.5) / n, (j + 0.5) / n);
  return sum / n / n;
}

/// Largest deviation that is accepted of an estimate with that standard error: with 15 degrees of freedom, one of
/// twenty thousand estimates lies farther off; the sequences are fixed, so that a test that passes always passes.
inline double allowed(double standardError) {
  constexpr double kDeviations = 5.5;
  return kDeviations * standardError;
}

/// The first channel of an estimate.
struct Openness {
  double value = 0, error = 0;
};
inline Openness openness(const TestScene& scene, const ShadedPoint& point, int rays,
                         const IntegrandSettings& settings = {}) {
  const ChannelEstimate estimate = estimateAt(scene.scene(), settings, {.rays = rays}, point, 0).channels;
  return {estimate.value[0], estimate.standardError[0]};
}

}  // namespace isolume::test
