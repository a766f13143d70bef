// The pure functions of shaders/lib compiled as C++ and compared with double precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <random>

#include "sweep/octants/geometry_terms.h"

namespace isolume {
namespace glsl {
using namespace glm;
#include "shaders/shared/octant_lights.h"

#include "shaders/lib/ambient.glsl"
#include "shaders/lib/camera_ray.glsl"
#include "shaders/lib/cell_cubic.glsl"
#include "shaders/lib/clearance.glsl"
#include "shaders/lib/disc_light.glsl"
#include "shaders/lib/ray_box.glsl"
}  // namespace glsl

namespace {

// Uniform in [low, high), the same on every machine.
class Random {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  glm::dvec3 vector(double low, double high) {
    const double x = (*this)(low, high), y = (*this)(low, high), z = (*this)(low, high);
    return {x, y, z};
  }

 private:
  std::mt19937 engine_{7};
};

double trilinear(const std::array<float, 8>& corner, glm::dvec3 p) {
  double sum = 0;
  for (unsigned i = 0; i < 8; ++i) {
    sum += corner[i] * ((i & 1) ? p.x : 1 - p.x) * ((i & 2) ? p.y : 1 - p.y) * ((i & 4) ? p.z : 1 - p.z);
  }
  return sum;
}

glsl::Cubic cubicOf(const std::array<float, 8>& c, glm::dvec3 u, glm::dvec3 d) {
  return glsl::cellCubic({c[0], c[1], c[2], c[3]}, {c[4], c[5], c[6], c[7]}, u, d);
}

TEST(ShaderMath, CellCubicIsTheInterpolantAlongTheRay) {
  // For random cells and rays the cubic equals the trilinear interpolant to a few float roundings of the largest
  // corner.
  Random random;
  for (int round = 0; round < 2000; ++round) {
    std::array<float, 8> corner;
    for (float& value : corner) value = static_cast<float>(random(-1, 1));
    const glm::dvec3 u = glm::vec3(random.vector(0, 1)), d = glm::vec3(random.vector(-1, 1));
    const glsl::Cubic g = cubicOf(corner, u, d);
    for (const double t : {0.0, 0.3, 0.9}) {
      ASSERT_NEAR(glsl::cubicAt(g, static_cast<float>(t)),
                  trilinear(corner, u + static_cast<double>(static_cast<float>(t)) * d), 2e-6);
      ASSERT_NEAR(glsl::cubicSlope(g, static_cast<float>(t)),
                  (trilinear(corner, u + (t + 1e-5) * d) - trilinear(corner, u + (t - 1e-5) * d)) / 2e-5, 1e-5);
    }
  }
}

double at(const glsl::Cubic& g, double t) { return ((g.d * t + g.c) * t + g.b) * t + g.a; }

// First point of a fine walk where the cubic is above 0.
std::optional<double> walkToRise(const glsl::Cubic& g, double len) {
  constexpr int kSteps = 20000;
  for (int i = 0; i <= kSteps; ++i) {
    if (at(g, len * i / kSteps) > 0) return len * i / kSteps;
  }
  return std::nullopt;
}

TEST(ShaderMath, FirstRiseIsTheFirst) {
  // For random cubics that start at or below 0 the root is found exactly when a fine walk finds one, it is the first
  // one, and it is a root; the walk cannot see bumps narrower than its step.
  Random random;
  int found = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto coefficient = [&](double scale) { return static_cast<float>(random(-scale, scale)); };
    const glsl::Cubic g{static_cast<float>(-random(0, 0.3)), coefficient(1), coefficient(3), coefficient(3)};
    const float len = static_cast<float>(random(0.01, 1.7));
    const glsl::Bracket bracket = glsl::firstRise(g, len);
    const auto expected = walkToRise(g, len);
    if (!expected) {
      if (bracket.found) {
        ASSERT_LT(at(g, bracket.high), 1e-6) << round;
      }
      continue;
    }
    ++found;
    ASSERT_TRUE(bracket.found) << round;
    const double root = glsl::refineRise(g, bracket);
    ASSERT_GE(root, 0);
    ASSERT_LE(root, len);
    // Not after the walk's first point, and the value there no more than the slope times twice the tolerance.
    ASSERT_LE(root, *expected + 3e-5) << round;
    const double slope = std::abs(3 * g.d * root * root + 2 * g.c * root + g.b);
    ASSERT_LE(std::abs(at(g, root)), 2e-5 * slope + 1e-6) << round;
  }
  EXPECT_GT(found, 500);
}

TEST(ShaderMath, GrazingAndDegenerateCubics) {
  // A bump that just reaches above 0 is found at its near flank, one that stays below is not, a double root from below
  // is no rise, and constants, lines and parabolas work without a cubic term.
  const auto bump = [](float height) { return glsl::Cubic{-0.25f + height, 1, -1, 0}; };  // top at t = 1/2
  const glsl::Bracket above = glsl::firstRise(bump(1e-4f), 1);
  ASSERT_TRUE(above.found);
  EXPECT_NEAR(glsl::refineRise(bump(1e-4f), above), 0.5 - 0.01, 1e-4);
  EXPECT_FALSE(glsl::firstRise(bump(-1e-4f), 1).found);
  EXPECT_FALSE(glsl::firstRise(bump(0), 1).found);
  EXPECT_FALSE(glsl::firstRise({-1, 0, 0, 0}, 1).found);
  EXPECT_FALSE(glsl::firstRise({0, 0, 0, 0}, 1).found);
  EXPECT_FALSE(glsl::firstRise({-1, 2, 0, 0}, 0).found);
  EXPECT_NEAR(glsl::refineRise({-1, 2, 0, 0}, glsl::firstRise({-1, 2, 0, 0}, 1)), 0.5, 1e-5);
  // Two rises within the cell: the first counts. (t - .2)(t - .5)(t - .8) scaled.
  const glsl::Cubic three{-0.08f * 4, 0.66f * 4, -1.5f * 4, 4};
  EXPECT_NEAR(glsl::refineRise(three, glsl::firstRise(three, 1)), 0.2, 1e-5);
  // Already inside at the entry: a hit there, not later.
  const glsl::Bracket entry = glsl::firstRise({1e-9f, -1, 0, 0}, 1);
  EXPECT_TRUE(entry.found);
  EXPECT_EQ(glsl::refineRise({1e-9f, -1, 0, 0}, entry), 0);
}

TEST(ShaderMath, RefinementConvergesOnFlatRoots) {
  // A triple root, where Newton crawls, is still bracketed to the tolerance within the fixed number of steps.
  const glsl::Cubic g{-0.125f, 0.75f, -1.5f, 1};  // (t - 1/2)^3
  const glsl::Bracket bracket = glsl::firstRise(g, 1);
  ASSERT_TRUE(bracket.found);
  // Float evaluates (t - 1/2)^3 as 0 within (1e-7)^(1/3) of the root.
  EXPECT_NEAR(glsl::refineRise(g, bracket), 0.5, 5e-3);
}

TEST(ShaderMath, TablesAndAddressGiveTheGeometryTerm) {
  // Bilinear look-up in the tables at the address gives G_s(N) to 2e-4 for normals of all directions, also on the axes
  // and at the horizon: the tables promise 1e-4, float addresses add the rest.
  const GeometryTermTables tables = makeGeometryTermTables();
  Random random;
  for (int round = 0; round < 3000; ++round) {
    glm::dvec3 n = glm::normalize(random.vector(-1, 1));
    if (round % 3 == 0) n = glm::normalize(glm::dvec3(n.x, n.y, 0));
    if (round < 6) n = glm::dvec3(round % 3 == 0, round % 3 == 1, round % 3 == 2) * (round < 3 ? 1.0 : -1.0);
    const glsl::GeometryAddress address = glsl::geometryAddress(n, static_cast<float>(tables.size));
    ASSERT_EQ(address.swapped, n.z < 0);
    const glm::dvec2 p = glm::dvec2(address.uv) * static_cast<double>(tables.size) - 0.5;
    const glm::ivec2 low = glm::clamp(glm::ivec2(glm::floor(p)), glm::ivec2(0), glm::ivec2(tables.size - 2));
    for (int octant = 0; octant < kOctantCount; ++octant) {
      const auto& texels = tables.texels[static_cast<std::size_t>((octant / 4) ^ (address.swapped ? 1 : 0))];
      double sum = 0;
      for (int corner = 0; corner < 4; ++corner) {
        const glm::ivec2 q = low + glm::ivec2(corner & 1, corner >> 1);
        const glm::dvec2 w = 1.0 - glm::abs(p - glm::dvec2(q));
        sum += w.x * w.y * texels[static_cast<std::size_t>(q.y * tables.size + q.x)][octant % 4];
      }
      ASSERT_NEAR(sum, octantGeometryTerm(octant, n), 2e-4) << n.x << " " << n.y << " " << n.z << " octant " << octant;
    }
  }
}

TEST(ShaderMath, OctantLightIsNormalised) {
  // All octants open and of light 1: (sum of G) / pi = 1; rounding above 1 is cut.
  glsl::OctantLights white{};
  for (int color = 0; color < 3; ++color) white.low[color] = white.high[color] = glm::vec4(1);
  white.most = glm::vec4(1, 1, 1, 0);
  const glm::vec4 open(1);
  const glm::vec4 share(static_cast<float>(M_PI / 8));
  for (int color = 0; color < 3; ++color) {
    EXPECT_NEAR(glsl::octantLight(white, open, open, share, share)[color], 1, 1e-6);
    EXPECT_NEAR(glsl::octantLight(white, open, glm::vec4(0), share, share)[color], 0.5, 1e-6);
    EXPECT_EQ(glsl::octantLight(white, open, open, share * 1.01f, share)[color], 1);
  }
}

TEST(ShaderMath, EachOctantHasItsOwnLight) {
  // The light is sum I_s V_s G_s / pi for each colour by itself, cut at the brightest octant of that colour.
  Random random;
  const auto vector = [&random] { return glm::vec4(glm::vec3(random.vector(0, 1)), static_cast<float>(random(0, 1))); };
  for (int round = 0; round < 200; ++round) {
    glsl::OctantLights lights{};
    for (int color = 0; color < 3; ++color) {
      lights.low[color] = vector();
      lights.high[color] = vector();
      lights.most[color] = color == 2 ? 0.1f : 100.0f;
    }
    const glm::vec4 visibility[2]{vector(), vector()}, geometry[2]{vector(), vector()};
    const glm::vec3 got = glsl::octantLight(lights, visibility[0], visibility[1], geometry[0], geometry[1]);
    for (int color = 0; color < 3; ++color) {
      double sum = 0;
      for (int s = 0; s < kOctantCount; ++s)
        sum += static_cast<double>((s < 4 ? lights.low : lights.high)[color][s % 4]) * visibility[s / 4][s % 4] *
               geometry[s / 4][s % 4] / M_PI;
      EXPECT_NEAR(got[color], std::min(sum, static_cast<double>(lights.most[color])), 1e-6);
    }
  }
}

TEST(ShaderMath, BeyondABorderOnlyTheOctantsThatEnterThereOpen) {
  // A point f voxels beyond a face: octants whose light comes through that face are open by f, all others keep their
  // visibility; at the border and inside nothing changes. Channel c of table k is octant 4 k + c.
  const glm::vec4 dark(0.25F);
  for (int axis = 0; axis < 3; ++axis) {
    for (const float f : {-1.5F, -1.0F, -0.5F, 0.0F, 0.25F, 1.0F, 2.0F}) {
      glm::vec3 beyond(0);
      beyond[axis] = f;
      for (int octant = 0; octant < kOctantCount; ++octant) {
        const float zSign = octant < 4 ? -1.0F : 1.0F;
        const float got = glsl::openBeyondBorder(dark, beyond, zSign)[octant % 4];
        const int light = kOctants[static_cast<std::size_t>(octant)].towardsLight()[axis];
        const float open = std::clamp(f * static_cast<float>(light), 0.0F, 1.0F);
        EXPECT_FLOAT_EQ(got, 0.25F + 0.75F * open) << "octant " << octant << " axis " << axis << " beyond by " << f;
      }
    }
  }
}

// Mean of max(N . w, 0) over a disc by the midpoint rule, N at that angle from its centre.
double meanCosine(double angle, double radius) {
  constexpr int kSteps = 400;
  double sum = 0, weights = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = radius * (i + 0.5) / kSteps, weight = std::sin(t);
    weights += weight * kSteps;
    for (int j = 0; j < kSteps; ++j) {
      const double turn = M_PI * (j + 0.5) / kSteps;
      const double cosine = std::cos(angle) * std::cos(t) + std::sin(angle) * std::sin(t) * std::cos(turn);
      sum += weight * std::max(cosine, 0.0);
    }
  }
  return sum / weights;
}

TEST(ShaderMath, DiscCosineIsTheMeanOverTheDisc) {
  // For discs from a hundredth of a degree to a hemisphere, above, across and below the horizon: to 2e-5, which
  // covers the error of the double integral that it is compared with, and the rounding of float over the disc's radius.
  for (const double degrees : {0.01, 0.25, 2.0, 15.0, 60.0, 89.0, 90.0}) {
    const double radius = glm::radians(degrees);
    for (int i = 0; i <= 12; ++i)
      for (const double aside : {0.0, 0.3 * radius, -0.7 * radius}) {
        const double angle = std::clamp(M_PI * i / 12 + aside, 0.0, M_PI);
        const float got = glsl::discCosine(static_cast<float>(std::cos(angle)), static_cast<float>(radius));
        ASSERT_NEAR(got, meanCosine(angle, radius), 2e-5 + 1e-7 / radius) << degrees << " at " << angle;
      }
  }
}

TEST(ShaderMath, CameraRaysPassThroughEyeAndPixel) {
  // Perspective: the eye lies on the ray at `start`. Orthographic: all rays are parallel. One unit of the parameter is
  // one smallest spacing of length.
  const glm::vec4 scale(2, 1, 1.5f, 0), plane(10, 20, 30, 40), x(0.1f, 0, 0, 0), y(0, 0, -0.1f, 0);
  const glm::vec4 eye(10, -20, 30, 1);
  const glsl::Ray ray = glsl::cameraRay(plane, x, y, eye, scale, {30, -20});
  EXPECT_LT(glm::length(ray.origin - glm::vec3(13, 20, 32)), 1e-5f);
  EXPECT_LT(glm::length(ray.origin + ray.start * ray.direction - glm::vec3(eye)), 1e-4f);
  EXPECT_NEAR(glm::length(ray.direction * glm::vec3(scale)), 1, 1e-6);
  const glm::vec4 parallel(0, -1, 0, 0);
  const glsl::Ray a = glsl::cameraRay(plane, x, y, parallel, scale, {30, -20});
  const glsl::Ray b = glsl::cameraRay(plane, x, y, parallel, scale, {0, 0});
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_EQ(a.start, -40);
  // Components of 0 are replaced, so that their inverse is finite.
  EXPECT_NE(a.direction.x, 0);
  EXPECT_TRUE(std::isfinite(1 / a.direction.x));
}

TEST(ShaderMath, BoxSpanIsTheSlabTest) {
  // Entry and exit of random rays lie on the faces named, and points between are inside.
  Random random;
  const glm::dvec3 high(7, 3, 11);
  int met = 0;
  for (int round = 0; round < 2000; ++round) {
    const glm::vec3 o = random.vector(-10, 20), d = random.vector(-1, 1);
    const glsl::BoxSpan span = glsl::boxSpan(o, 1.0f / d, high);
    if (!(span.enter < span.leave)) {
      for (double t = -40; t < 40; t += 0.5) {
        const glm::dvec3 p = glm::dvec3(o) + t * glm::dvec3(d);
        ASSERT_FALSE(glm::all(glm::greaterThan(p, glm::dvec3(1e-3))) && glm::all(glm::lessThan(p, high - 1e-3)));
      }
      continue;
    }
    ++met;
    const glm::dvec3 middle = glm::dvec3(o) + 0.5 * (span.enter + span.leave) * glm::dvec3(d);
    ASSERT_TRUE(glm::all(glm::greaterThanEqual(middle, glm::dvec3(-1e-4))) &&
                glm::all(glm::lessThanEqual(middle, high + 1e-4)));
    const double entry = o[span.enterAxis] + span.enter * d[span.enterAxis];
    ASSERT_NEAR(entry, d[span.enterAxis] > 0 ? 0 : high[span.enterAxis], 1e-4);
  }
  EXPECT_GT(met, 100);
}

TEST(ShaderMath, CubeExitLiesOnTheFaceAndEntersTheCellBehindIt) {
  // The ray leaves the cube of cells less than `radius` away on one of its faces, not before any other, and the next
  // cell is the one behind that face where the ray is; in any of the eight octants.
  Random random;
  const glm::vec3 lastCell(40, 37, 50);
  for (int round = 0; round < 3000; ++round) {
    const glm::ivec3 cell(15, 19, 12);
    const int radius = 1 + round % 7;
    const glm::vec3 p = glm::dvec3(cell) + random.vector(0, 1);
    const glm::vec3 d = glm::normalize(random.vector(-1, 1));
    const glsl::Walk walk = glsl::makeWalk(p, d, 1.0f / d, lastCell);
    // Turning is its own inverse.
    const glm::vec3 turned = glsl::gridCell(walk, cell);
    ASSERT_EQ(glm::ivec3(glsl::gridCell(walk, turned)), cell);
    const glsl::CubeExit leave = glsl::cubeExit(walk, turned, static_cast<float>(radius));
    const glm::ivec3 next(glsl::gridCell(walk, leave.next));
    const glm::dvec3 at = glm::dvec3(p) + static_cast<double>(leave.t) * glm::dvec3(d);
    const glm::dvec3 low = glm::dvec3(cell - (radius - 1)), high = glm::dvec3(cell + radius);
    ASSERT_GE(leave.t, -1e-5);
    if (radius == 1) {
      ASSERT_EQ(leave.t, glsl::cellExit(walk, turned));
    }
    int outside = 0;
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_GE(at[axis], low[axis] - 1e-5);
      ASSERT_LE(at[axis], high[axis] + 1e-5);
      ASSERT_GE(leave.next[axis], turned[axis]);
      if (next[axis] < low[axis] || next[axis] >= high[axis]) {
        ++outside;
        ASSERT_NEAR(at[axis], d[axis] > 0 ? high[axis] : low[axis], 1e-5);
        ASSERT_EQ(next[axis], d[axis] > 0 ? cell[axis] + radius : cell[axis] - radius);
      } else {
        ASSERT_NEAR(at[axis], next[axis] + 0.5, 0.5 + 1e-5);
      }
    }
    ASSERT_GE(outside, 1);
  }
}

TEST(ShaderMath, ARayThroughEdgesAndCornersNeverGoesBack) {
  // Rays through lattice points, where rounding decides on which side of a face they are, leave the grid after at most
  // as many cells as it has along its axes, and never enter a cell that they left.
  const glm::vec3 lastCell(5);
  constexpr int kMostCells = 18;
  Random random;
  for (int round = 0; round < 100000; ++round) {
    const glm::vec3 through = glm::floor(glm::vec3(random.vector(1, 6)));
    const glm::vec3 d = glm::normalize(glm::vec3(random.vector(-1, 1)));
    const glm::vec3 start = glm::clamp(through - static_cast<float>(random(0, 2)) * d, glm::vec3(0), glm::vec3(6));
    const glsl::Walk walk = glsl::makeWalk(start, d, 1.0f / d, lastCell);
    glm::vec3 cell = glm::clamp(glm::floor(walk.origin), glm::vec3(0), lastCell);
    int steps = 0;
    while (glm::all(glm::lessThanEqual(cell, lastCell))) {
      const glm::vec3 next = glsl::cubeExit(walk, cell, 1).next;
      ASSERT_TRUE(glm::all(glm::greaterThanEqual(next, cell)));
      ASSERT_NE(next, cell);
      cell = next;
      ASSERT_LE(++steps, kMostCells);
    }
  }
}

TEST(ShaderMath, ACubicThatRisesIsNeverRuledOut) {
  // mayRise() holds wherever firstRise() finds a crossing, and rules out more than half of the cubics that have none.
  Random random;
  int rising = 0, ruledOut = 0, others = 0;
  for (int round = 0; round < 20000; ++round) {
    const glm::vec3 bcd = random.vector(-1, 1);
    const glsl::Cubic cubic{static_cast<float>(-random.vector(0, 1).x), bcd.x, bcd.y, bcd.z};
    const auto len = static_cast<float>(random.vector(0, 1.7).x);
    const bool rises = glsl::firstRise(cubic, len).found;
    const bool may = glsl::mayRise(cubic, len);
    ASSERT_TRUE(may || !rises) << cubic.a << ' ' << bcd.x << ' ' << bcd.y << ' ' << bcd.z << ' ' << len;
    rising += rises;
    others += !rises;
    ruledOut += !may;
  }
  EXPECT_GT(rising, 1000);
  EXPECT_GT(ruledOut, others / 2);
}

}  // namespace
}  // namespace isolume
