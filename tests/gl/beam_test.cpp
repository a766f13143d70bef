// Beams: the bounds of a block of rays in C++, which blocks are drawn, and pictures of what a beam could leap over.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <random>

#include "gl/gl_scene.h"
#include "raymarch/beams.h"
#include "support/cpu_tracer.h"

namespace isolume {
namespace glsl {
using namespace glm;
#include "shaders/lib/beam.glsl"
#include "shaders/shared/beam_block.h"
}  // namespace glsl

namespace test {
namespace {

// The same numbers on every machine.
double uniform(std::mt19937& engine, double low, double high) {
  return low + (high - low) * (static_cast<double>(engine()) / 4294967296.0);
}
glm::vec3 uniformVector(std::mt19937& engine, double low, double high) {
  const double x = uniform(engine, low, high), y = uniform(engine, low, high), z = uniform(engine, low, high);
  return {x, y, z};
}

// What rounding in float may hide at coordinates of this size; the beams here have no margin of their own.
constexpr double kRounding = 1e-4;

struct Block {
  glm::dvec3 centre, along, right, down;  // of its centre ray, and half its sides
  double perspective = 1;
  glm::dvec3 pointAt(glm::dvec2 pixel, double s) const {
    const glm::dvec3 shift = pixel.x * right + pixel.y * down;
    return centre + shift + s * (along + perspective * shift);
  }
  glsl::Beam beam() const {
    return glsl::makeBeam(glm::vec3(centre), glm::vec3(along), glm::vec3(glm::abs(right) + glm::abs(down)),
                          static_cast<float>(perspective), 0);
  }
};

Block randomBlock(std::mt19937& engine) {
  Block block;
  block.centre = uniformVector(engine, -10, 30);
  block.along = uniformVector(engine, -40, 40);
  block.right = uniformVector(engine, -1, 1);
  block.down = uniformVector(engine, -1, 1);
  block.perspective = engine() % 2 == 0 ? 0 : 1;
  return block;
}

TEST(Beam, StaysWithinABoxAsLongAsEveryRay) {
  // No ray of a block is outside the box before the beam says so, and just after it, the beam's bounds are.
  std::mt19937 engine(3);
  int stayed = 0;
  for (int round = 0; round < 20000; ++round) {
    const Block block = randomBlock(engine);
    const double from = uniform(engine, -0.9, 0.5);
    const glm::vec3 at = block.pointAt({0, 0}, from);
    const glm::vec3 low = at - uniformVector(engine, 0, 12), high = at + uniformVector(engine, 0, 12);
    const double until = glsl::beamStaysWithin(block.beam(), low, high, static_cast<float>(from));
    if (until < from) continue;
    ++stayed;
    for (const glm::dvec2 pixel : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1),
                                   glm::dvec2(uniform(engine, -1, 1), uniform(engine, -1, 1))}) {
      for (const double s : {from, 0.5 * (from + until), until}) {
        const glm::dvec3 p = block.pointAt(pixel, s);
        ASSERT_TRUE(glm::all(glm::greaterThan(p, glm::dvec3(low) - kRounding))) << round;
        ASSERT_TRUE(glm::all(glm::lessThan(p, glm::dvec3(high) + kRounding))) << round;
      }
    }
    const glsl::Beam beam = block.beam();
    const double after = until + 1e-3 * (1 + std::abs(until));
    const glm::dvec3 upper = glm::dvec3(beam.upper) + after * glm::dvec3(beam.upperSlope);
    const glm::dvec3 lower = glm::dvec3(beam.lower) + after * glm::dvec3(beam.lowerSlope);
    ASSERT_TRUE(glm::any(glm::greaterThan(upper, glm::dvec3(high))) || glm::any(glm::lessThan(lower, glm::dvec3(low))));
  }
  EXPECT_GT(stayed, 5000);
}

TEST(Beam, MeetsTheGridWheneverARayDoes) {
  // A point of any ray within the grid lies between where the beam enters the grid and where it has passed it.
  std::mt19937 engine(4);
  const glm::vec3 high(17, 9, 23);
  int within = 0;
  for (int round = 0; round < 200000; ++round) {
    const Block block = randomBlock(engine);
    const double s = uniform(engine, -1, 2);
    const glm::dvec3 p = block.pointAt({uniform(engine, -1, 1), uniform(engine, -1, 1)}, s);
    if (glm::any(glm::lessThan(p, glm::dvec3(0))) || glm::any(glm::greaterThan(p, glm::dvec3(high)))) continue;
    ++within;
    ASSERT_LE(glsl::beamEnters(block.beam(), high, -1), s + kRounding);
    ASSERT_GE(glsl::beamPasses(block.beam(), high), s - kRounding);
  }
  EXPECT_GT(within, 4000);
}

TEST(Beam, ABeamBesideTheGridNeverEntersIt) {
  // Rays that run away from the grid, and rays parallel to it and beside it, have passed before they enter.
  const glm::vec3 high(10, 10, 10), thin(0.01f);
  const glsl::Beam away = glsl::makeBeam({20, 5, 5}, {1, 0, 0}, thin, 0, 0);
  const glsl::Beam beside = glsl::makeBeam({5, -3, 5}, {1, 0, 0}, thin, 0, 0);
  EXPECT_GE(glsl::beamEnters(away, high, 0), glsl::beamPasses(away, high));
  EXPECT_GE(glsl::beamEnters(beside, high, 0), glsl::beamPasses(beside, high));
}

TEST(Beam, LiveBlocksAreCoveredOnce) {
  // Random patterns: each live block lies in one rectangle, each dead one in none.
  std::mt19937 engine(5);
  for (int round = 0; round < 300; ++round) {
    const glm::ivec2 blocks(1 + static_cast<int>(engine() % 9), 1 + static_cast<int>(engine() % 9));
    std::vector<float> starts(static_cast<std::size_t>(blocks.x * blocks.y));
    for (float& start : starts) start = engine() % 4 < static_cast<unsigned>(round % 5) ? 1.5f : glsl::kBeamMissed;
    std::vector<int> covered(starts.size());
    for (const TileRect& rect : liveBlocks(starts, blocks)) {
      for (int y = rect.low.y / glsl::kBeamBlock; y < rect.high.y / glsl::kBeamBlock; ++y)
        for (int x = rect.low.x / glsl::kBeamBlock; x < rect.high.x / glsl::kBeamBlock; ++x)
          ++covered[static_cast<std::size_t>(y * blocks.x + x)];
    }
    for (std::size_t i = 0; i < starts.size(); ++i) ASSERT_EQ(covered[i], starts[i] < glsl::kBeamMissed ? 1 : 0);
  }
}

TEST(Beam, EqualRowsBecomeOneRectangle) {
  // A solid block of live blocks is one rectangle: one draw call.
  const std::vector<TileRect> rects = liveBlocks(std::vector<float>(12, 0.0f), {4, 3});
  ASSERT_EQ(rects.size(), 1u);
  EXPECT_EQ(rects[0].high, glm::ivec2(4, 3) * glsl::kBeamBlock);
}

// Single samples that stick out of nothing, a voxel or two across: whatever a beam leaps over is missing at once.
GlScene scattered(glm::dvec3 spacing) {
  std::mt19937 engine(11);
  GlScene scene = makeScene({37, 29, 33}, spacing, [](glm::dvec3) { return 1.0; });
  GridView<float> level = scene.level.view();
  for (std::size_t i = 0; i < level.count(); ++i) {
    constexpr unsigned kOneIn = 60;
    level.data[i] = engine() % kOneIn == 0 ? 1.0f : -0.6f;
  }
  return scene;
}

/// Pixels whose coverage is not the tracer's although it stays the same a thousandth of a pixel around them.
int wrongPixels(const GlScene& scene, const Camera& camera, glm::ivec2 size, int& hits) {
  const Frame frame = renderOnce(scene, camera, layerSettings(size.x, size.y));
  int wrong = 0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const auto traced = [&](double dx, double dy) {
        const IndexRay ray = pixelRay(camera, size, glm::dvec2(x + 0.5 + dx, y + 0.5 + dy), scene.worldFromGrid);
        return traceLevel(scene.level.view(), ray).has_value();
      };
      const bool found = std::isfinite(frame.depth[static_cast<std::size_t>(y * size.x + x)]);
      hits += found;
      constexpr double kNear = 1e-3;
      const bool centre = traced(0, 0);
      if (found != centre && traced(kNear, 0) == centre && traced(-kNear, 0) == centre && traced(0, kNear) == centre &&
          traced(0, -kNear) == centre)
        ++wrong;
    }
  }
  return wrong;
}

TEST(Beam, LeapsOverNothing) {
  // Scattered single voxels are all seen: from afar, where a block is many voxels wide, and from near; with and without
  // perspective; in a picture that is no whole number of blocks; at voxels of 1 : 1 : 2.5.
  int hits = 0;
  for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1, 2.5)}) {
    const GlScene scene = scattered(spacing);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      for (const double zoom : {0.3, 1., 6.}) {
        SCOPED_TRACE(zoom);
        const Camera camera = frameScene(scene, {.zoom = zoom, .projection = projection});
        EXPECT_EQ(wrongPixels(scene, camera, {77, 59}, hits), 0);
      }
    }
  }
  EXPECT_GT(hits, 2000);
}

TEST(Beam, SeesFromWithinTheGrid) {
  // An eye between the voxels: beams begin at the eye, as thin as a point.
  const GlScene scene = scattered(glm::dvec3(1));
  int hits = 0;
  const Camera camera{.eye = {18.2, 14.7, 16.1}, .target = {30, 20, 19}, .fovDegrees = 90};
  ASSERT_FALSE(levelAt(scene.level.view(), camera.eye) > 0);
  EXPECT_EQ(wrongPixels(scene, camera, {91, 66}, hits), 0);
  EXPECT_GT(hits, 500);
}

TEST(Beam, SamplesOfMissedBlocksAreBackground) {
  // Where no block is drawn, and beside the solid in blocks that are, each number of samples gives the background.
  const GlScene scene = makeSphere();
  RenderSettings settings{.size = {130, 70}, .shading = Shading::local, .background = {0.25f, 0.5f, 0.75f, 1}};
  for (const int samples : {1, 2, 5}) {
    settings.samples = samples;
    const Frame frame = renderOnce(scene, frameScene(scene, {.zoom = 0.5}), settings);
    const std::size_t beside = 35 * 130 + 45;  // within a block of the silhouette
    for (const std::size_t pixel : {std::size_t{0}, frame.color.size() - 1, beside}) {
      ASSERT_LT(glm::length(frame.color[pixel] - settings.background), 1e-6f) << samples << " samples, pixel " << pixel;
    }
  }
}

}  // namespace
}  // namespace test
}  // namespace isolume
