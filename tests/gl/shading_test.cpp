#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "gl/gl_scene.h"
#include "raymarch/gpu_error.h"
#include "support/random_numbers.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/octants/geometry_terms.h"
#include "sweep/ordinates/openness_sweep.h"

namespace isolume::test {
namespace {

// The sphere from all around, so that all normals occur: two opposite cameras.
std::array<Camera, 2> bothSides(const GlScene& scene) {
  return {frameScene(scene, {.azimuthDegrees = 30, .elevationDegrees = 25}),
          frameScene(scene, {.azimuthDegrees = 210, .elevationDegrees = -25})};
}

TEST(Shading, OpenSurfaceIsFullyLit) {
  // With every octant open, A = 1 whatever the normal: the eight tables sum to pi at every texel.
  const GlScene scene = makeSphere();
  RenderSettings settings = layerSettings();
  settings.shading = Shading::octants;
  for (const Camera& camera : bothSides(scene)) {
    const Frame frame = renderOnce(scene, camera, settings);
    for (const glm::vec3& light : frame.light) ASSERT_NEAR(light.x, 1, 1e-5);
  }
}

TEST(Shading, EachOctantLightsItsOwnSide) {
  // With one octant open, A = G_s(N) / pi of that octant: addressing, channels, and the swap for N.z < 0.
  // The tables are good to 1e-4 of G, and 8-bit weights of hardware filters add half as much.
  constexpr double kTolerance = 2e-4;
  GlScene scene = makeSphere();
  RenderSettings settings = layerSettings(60, 48);
  settings.shading = Shading::octants;
  for (int octant = 0; octant < kOctantCount; ++octant) {
    for (int half = 0; half < 2; ++half) {
      glm::u8vec4 open(0);
      if (octant / 4 == half) open[octant % 4] = 255;
      std::fill_n(scene.octants[static_cast<std::size_t>(half)].data(), scene.level.count(), open);
    }
    double brightest = 0;
    for (const Camera& camera : bothSides(scene)) {
      const Frame frame = renderOnce(scene, camera, settings);
      for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        if (!std::isfinite(frame.depth[i])) continue;
        const double expected = octantGeometryTerm(octant, glm::normalize(glm::dvec3(frame.normal[i]))) / M_PI;
        ASSERT_NEAR(frame.light[i].x, expected, kTolerance) << "octant " << octant;
        brightest = std::max(brightest, expected);
      }
    }
    EXPECT_GT(brightest, 0.25) << "octant " << octant;
  }
}

TEST(Shading, VisibilityIsInterpolatedLinearly) {
  // Octants that grow linearly along x give an A that is linear in the x of the hit.
  GlScene scene = makeSphere();
  for (Grid<glm::u8vec4>& grid : scene.octants) {
    for (std::size_t i = 0; i < grid.count(); ++i) grid.data()[i] = glm::u8vec4(static_cast<std::uint8_t>(i % 48 * 5));
  }
  RenderSettings settings = layerSettings();
  settings.shading = Shading::octants;
  const Frame frame = renderOnce(scene, frameScene(scene), settings);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    // Exact but for float rounding, since the shader filters by hand: the hardware would round to 8 bits.
    if (std::isfinite(frame.depth[i])) {
      ASSERT_NEAR(frame.light[i].x, frame.position[i].x * 5 / 255, 1e-5);
    }
  }
}

// A ball with swept octants. Its ambient should vary slowly: the largest second difference between neighbouring pixels
// is a measure of stripes.
double roughness(float occlusionOffsetVoxels) {
  GlScene scene = makeSphere();
  SweptFields swept = sweepOcclusion(scene.level.view());
  scene.octants = std::move(swept.visibility.packed);
  RenderSettings settings = layerSettings(200, 200);
  settings.shading = Shading::octants;
  settings.occlusionOffsetVoxels = occlusionOffsetVoxels;
  const Frame frame = renderOnce(scene, frameScene(scene), settings);
  double largest = 0;
  for (int y = 0; y < frame.size.y; ++y)
    for (int x = 1; x + 1 < frame.size.x; ++x) {
      const auto at = [&](int column) { return static_cast<std::size_t>(y * frame.size.x + column); };
      const bool hits = std::isfinite(frame.depth[at(x - 1)]) && std::isfinite(frame.depth[at(x)]) &&
                        std::isfinite(frame.depth[at(x + 1)]);
      if (!hits) continue;
      const double bend =
          frame.light[at(x - 1)].x - 2.0 * frame.light[at(x)].x + static_cast<double>(frame.light[at(x + 1)].x);
      largest = std::max(largest, std::abs(bend));
    }
  return largest;
}

TEST(Shading, ReadAboveTheSurfaceThereAreNoStripes) {
  // Read at the hit, the ball shows the stripes of Eq. 7; read two voxels above they are gone (below 1/100, which is
  // less than three steps of an 8-bit picture).
  const double atHit = roughness(0);
  const double above = roughness(2);
  EXPECT_GT(atHit, 0.03);
  EXPECT_LT(above, 0.01);
}

TEST(Shading, ACapIsAsOpenAsTheSurfaceBesideIt) {
  // A half space cut by the box: read above, its caps are lit by the light that enters at the border, not darkened by
  // it.
  GlScene scene = makeScene(glm::ivec3(40), glm::dvec3(1), [](glm::dvec3 p) { return p.z - 20.3; });
  SweptFields swept = sweepOcclusion(scene.level.view());
  scene.octants = std::move(swept.visibility.packed);
  RenderSettings settings = layerSettings();
  settings.shading = Shading::octants;
  settings.occlusionOffsetVoxels = 2;
  const Frame frame = renderOnce(scene, frameScene(scene), settings);
  int caps = 0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (!std::isfinite(frame.depth[i])) continue;
    caps += std::abs(frame.normal[i].z) < 0.5F ? 1 : 0;
    ASSERT_GT(frame.light[i].x, 0.99) << "normal z " << frame.normal[i].z;
  }
  EXPECT_GT(caps, 500);
}

TEST(Shading, GammaAlbedoAndHeadLight) {
  // colour = albedo * A^(1 / gamma); with local shading A = |N . V|.
  const GlScene scene = makeSphere();
  const Camera camera = frameScene(scene, {.projection = Projection::orthographic});
  RenderSettings settings = layerSettings();
  settings.albedo = {0.5f, 0.25f, 1};
  settings.gamma = 2;
  const Frame frame = renderOnce(scene, camera, settings);
  const glm::dvec3 viewer = -cameraAxes(camera).forward;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (!std::isfinite(frame.depth[i])) continue;
    const double expected = std::sqrt(std::abs(glm::dot(glm::dvec3(frame.normal[i]), viewer)));
    ASSERT_NEAR(frame.color[i].r, 0.5 * expected, 1e-4);
    ASSERT_NEAR(frame.color[i].g, 0.25 * expected, 1e-4);
    ASSERT_NEAR(frame.color[i].b, expected, 1e-4);
    ASSERT_EQ(frame.color[i].a, 1);
  }
}

TEST(Shading, DistanceNormalsFollowTheDistance) {
  // A level squeezed beyond recognition (its cube) keeps the surface, and the normals of the distance stay radial to
  // the half-float resolution of the distance (2^-10 within two voxels, over a difference of two voxels).
  GlScene scene = makeSphere();
  for (std::size_t i = 0; i < scene.level.count(); ++i) scene.level.data()[i] = std::pow(scene.level.data()[i], 3.0f);
  RenderSettings settings = layerSettings();
  settings.normals = NormalSource::distance;
  const Frame frame = renderOnce(scene, frameScene(scene), settings);
  int hits = 0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (!std::isfinite(frame.depth[i])) continue;
    ++hits;
    const glm::dvec3 radial = glm::normalize(glm::dvec3(frame.position[i]) - sphereCentre(48));
    ASSERT_LT(glm::length(radial - glm::dvec3(frame.normal[i])), 3e-3);
  }
  EXPECT_GT(hits, 1000);
}

TEST(Shading, OpennessIsReadAsItIsDefined) {
  // Random numbers at all samples, others on the caps, are shown as surface_field.h reads them: on a bumpy solid, whose
  // normals turn from sample to sample, and on the faces that cut it, in the last cells too.
  GlScene scene = makeScene({40, 30, 20}, glm::dvec3(1, 1.3, 1.7), [](glm::dvec3 p) {
    const double bumps = 1.5 * std::sin(p.x) * std::sin(1.1 * p.y) * std::sin(0.9 * p.z);
    return glm::length(p - glm::dvec3(30, 20, 17)) - 15 + bumps;  // cut by three faces
  });
  RandomNumbers numbers(5);
  for (std::uint16_t& number : scene.openness.numbers()) number = static_cast<std::uint16_t>(numbers.below(65536));
  RenderSettings settings = layerSettings();
  settings.shading = Shading::lights;
  int walls = 0, caps = 0;
  for (const Camera& camera : bothSides(scene)) {
    const Frame frame = renderOnce(scene, camera, settings);
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      if (!std::isfinite(frame.depth[i])) continue;
      const glm::dvec3 normal(frame.normal[i]), index(frame.index[i]);
      double want = 0;
      bool cap = false;
      for (int f = 0; f < kFaceCount; ++f) {
        const GridFace face = faceOf(f);
        if (normal[face.axis] != (face.side == 0 ? -1 : 1)) continue;
        want = capValueAt(scene.openness, face, index);
        cap = true;
      }
      ++(cap ? caps : walls);
      if (!cap) want = wallValueAt(scene.openness, scene.level.view(), index, normal);
      // Positions, normals and weights in float.
      ASSERT_NEAR(frame.light[i].x, want / 65535, 5e-5) << i;
    }
  }
  EXPECT_GT(walls, 1000);
  EXPECT_GT(caps, 300);
}

TEST(Shading, SweptOpennessOfABallIsOne) {
  // A ball in the open, swept and drawn: openness within .01 of 1 at every pixel.
  GlScene scene = makeSphere();
  scene.openness = sweepOpenness(scene.fields().level, scene.fields().distance);
  RenderSettings settings = layerSettings();
  settings.shading = Shading::lights;
  for (const Camera& camera : bothSides(scene)) {
    const Frame frame = renderOnce(scene, camera, settings);
    for (const glm::vec3& light : frame.light) ASSERT_NEAR(light.x, 1, 0.01);
  }
}

TEST(Shading, OcclusionNeedsOctants) {
  // A scene without octants renders with local shading; by occlusion it is an error.
  const GlScene scene = makeSphere();
  SceneFields fields = scene.fields();
  fields.octants = {};
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  renderer.upload(fields);
  const Frame frame = renderer.render(frameScene(scene), layerSettings());
  EXPECT_FALSE(frame.normal.empty());
  RenderSettings settings = layerSettings();
  settings.shading = Shading::octants;
  EXPECT_THROW(renderer.render(frameScene(scene), settings), GpuError);
}

}  // namespace
}  // namespace isolume::test
