// Hard shadows in the shader, against exact rays.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <iostream>
#include <utility>

#include "gl/gl_scene.h"
#include "raymarch/gpu_error.h"
#include "raymarch/view.h"
#include "src/io/volume.h"
#include "support/shared_data.h"
#include "sweep/level.h"
#include "sweep/reference/surface_tracer.h"
#include "volumes/scenes.h"

namespace isolume::test {
namespace {

/// With no light but the sun.
GlScene unlit(GlScene scene) {
  scene.openness = {};
  return scene;
}

RenderSettings shadowSettings(glm::dvec3 towardsLight, int width = 120, int height = 96) {
  RenderSettings settings = layerSettings(width, height);
  settings.shading = Shading::lights;
  settings.suns = {{towardsLight}};
  return settings;
}

struct Shadows {
  int pixels = 0, dark = 0;
  int rounded = 0;  // lit, where exact rays are blocked, but not a little further out
  int apart = 0;    // all others that differ
};

// Every hit with what exact rays say of the light there. They find the hit again on the ray of the pixel, so that they
// start on the surface as the shader does.
Shadows compareShadows(GridView<const float> level, const glm::dmat4& worldFromGrid, const Framing& framing,
                       glm::dvec3 towardsLight, int size) {
  const Camera camera = frameCorners(boxCorners(worldFromGrid, glm::dvec3(0), glm::dvec3(level.size - 1)), 1, framing);
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  SceneFields fields;
  fields.worldFromGrid = worldFromGrid;
  fields.level = level;
  renderer.upload(fields);
  const Frame frame = renderer.render(camera, shadowSettings(towardsLight, size, size));

  const GridFrame grid = makeGridFrame(worldFromGrid);
  const SurfaceTracer tracer(level);
  const glm::dvec3 light = glm::normalize(towardsLight);
  const glm::dvec3 alongGrid(grid.gridFromWorld * glm::dvec4(light, 0));
  Shadows shadows;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (!std::isfinite(frame.depth[i])) continue;
    const glm::dvec3 seen(grid.gridFromWorld * glm::dvec4(glm::dvec3(frame.position[i]), 1));
    const glm::dvec3 eye(grid.gridFromWorld * glm::dvec4(camera.eye, 1));
    const auto hit = tracer.firstHit({eye, seen - eye});
    constexpr double kSamePlace = 1e-2;  // voxels; where the pixel's ray grazes the exact one may pass
    if (!hit || glm::length(hit->position - seen) > kSamePlace) continue;
    const double cosine = glm::dot(glm::dvec3(frame.normal[i]), light);
    const bool blocked = cosine <= 0 || tracer.isBlocked({hit->position, alongGrid}, *hit);
    const double want = blocked ? 0 : cosine;
    constexpr double kFloat = 1e-5;
    ++shadows.pixels;
    shadows.dark += blocked;
    if (std::abs(frame.light[i].x - want) <= kFloat) continue;
    // What march/shadow.glsl says it may miss: 3e-4 voxels at 256 samples, for a surface that is no steeper than
    // others.
    constexpr double kRounding = 3e-4;
    SurfacePoint further = *hit;
    further.position -= kRounding * glm::normalize(tracer.cellGradient(hit->position));
    const bool isRounded = blocked && cosine > 0 && !tracer.isBlocked({further.position, alongGrid}, further);
    (isRounded ? shadows.rounded : shadows.apart) += 1;
  }
  return shadows;
}

// Rays along the surface that they leave are few, and fewer those that graze it elsewhere.
constexpr double kMostRounded = 4e-3, kMostApart = 5e-4;

void expectAgreement(const Shadows& shadows) {
  std::cout << shadows.pixels << " pixels, " << shadows.dark << " dark, " << shadows.rounded << " rounded, "
            << shadows.apart << " apart\n";
  EXPECT_LE(shadows.rounded, kMostRounded * shadows.pixels);
  EXPECT_LE(shadows.apart, kMostApart * shadows.pixels);
  EXPECT_GT(shadows.dark, shadows.pixels / 20);
  EXPECT_LT(shadows.dark, shadows.pixels * 19 / 20);
}

TEST(Shadow, ABallHasNoneOfItsOwn) {
  // A convex solid shades nothing but its far side: wherever the light is not grazing, max(N . w, 0) without one dark
  // pixel, from lights all around.
  const GlScene scene = unlit(makeSphere());
  constexpr float kGrazingCosine = 0.1F;  // the facets of the interpolant lean by less
  for (const glm::dvec3 light : {glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 1), glm::dvec3(-0.3, 0.9, -0.2)}) {
    int lit = 0;
    for (const double azimuth : {20.0, 200.0}) {
      const Frame frame =
          renderOnce(scene, frameScene(scene, {.azimuthDegrees = azimuth}), shadowSettings(light, 160, 160));
      for (std::size_t i = 0; i < frame.depth.size(); ++i) {
        if (!std::isfinite(frame.depth[i])) continue;
        const auto cosine = static_cast<float>(glm::dot(glm::dvec3(frame.normal[i]), glm::normalize(light)));
        if (std::abs(cosine) < kGrazingCosine) continue;
        ASSERT_NEAR(frame.light[i].x, std::max(cosine, 0.0F), 1e-5) << i;
        lit += cosine > 0;
      }
    }
    EXPECT_GT(lit, 1000);
  }
}

TEST(Shadow, ABlockIsLitUpToItsEdges) {
  // Half of the grid is solid: its caps and its surface are planes of a convex block, lit by N . w up to the last
  // pixel.
  const GlScene scene =
      unlit(makeScene(glm::ivec3(40), glm::dvec3(1, 0.7, 1.3), [](glm::dvec3 p) { return p.z - 20.3; }));
  for (const glm::dvec3 light : {glm::dvec3(1, -0.4, 0.2), glm::dvec3(0.1, -1, 3)}) {
    const Frame frame = renderOnce(scene, frameScene(scene, {.azimuthDegrees = 30, .elevationDegrees = 25}),
                                   shadowSettings(light, 160, 160));
    int caps = 0, surface = 0;
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      if (!std::isfinite(frame.depth[i])) continue;
      const auto cosine = static_cast<float>(glm::dot(glm::dvec3(frame.normal[i]), glm::normalize(light)));
      ASSERT_NEAR(frame.light[i].x, std::max(cosine, 0.0F), 1e-5) << i;
      (std::abs(frame.normal[i].z) > 0.5F ? surface : caps) += 1;
    }
    EXPECT_GT(caps, 500);
    EXPECT_GT(surface, 500);
  }
}

TEST(Shadow, AFloorNextToItsSamplesIsLit) {
  // A floor on a plane of samples, or a millionth of a voxel above it: hits that float puts a little below or above the
  // samples have light alike.
  for (const double above : {0.0, 1e-7, 1e-6, 3e-6, 1e-5}) {
    const GlScene scene =
        unlit(makeScene(glm::ivec3(40), glm::dvec3(1), [above](glm::dvec3 p) { return p.z - (20 + above); }));
    const Frame frame =
        renderOnce(scene, frameScene(scene, {.elevationDegrees = 50}), shadowSettings({1, 0.3, 0.2}, 160, 160));
    int hits = 0;
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      if (!(frame.normal[i].z > 0.5F)) continue;
      ASSERT_NEAR(frame.light[i].x, glm::dot(glm::dvec3(frame.normal[i]), glm::normalize(glm::dvec3(1, 0.3, 0.2))),
                  1e-5)
          << above << " " << frame.position[i].z - 20;
      ++hits;
    }
    EXPECT_GT(hits, 5000);
  }
}

TEST(Shadow, EndsWhereTheEdgeSaysIt) {
  // A plate above a floor: under a light along (1, 0, 2) the floor is dark up to where the ray past the plate's lower
  // edge meets it, to a hundredth of a voxel.
  constexpr double kFloor = 5, kEdge = 30, kUnderside = 25;
  const GlScene scene = unlit(makeScene(glm::ivec3(60, 40, 32), glm::dvec3(1), [](glm::dvec3 p) {
    return std::min(p.z - kFloor, std::max(p.x - kEdge, kUnderside - p.z));
  }));
  const double rim = kEdge - (kUnderside - kFloor) / 2;
  const Camera camera = frameScene(scene, {.azimuthDegrees = 90, .elevationDegrees = 20});
  const Frame frame = renderOnce(scene, camera, shadowSettings({1, 0, 2}, 400, 300));
  int lit = 0, dark = 0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const glm::vec3 at = frame.position[i];
    if (!(std::abs(at.z - kFloor) < 1e-3) || !(std::abs(at.x - rim) > 1e-2)) continue;
    const bool isLit = frame.light[i].x > 0;
    ASSERT_EQ(isLit, at.x > rim) << at.x << " " << at.y;
    (isLit ? lit : dark) += 1;
  }
  EXPECT_GT(lit, 1000);
  EXPECT_GT(dark, 1000);
}

class SceneShadow : public testing::TestWithParam<std::string_view> {};

TEST_P(SceneShadow, AgreesWithExactRays) {
  // On a sample scene, turned in the world and with uneven spacing, every pixel has the shadow that exact rays give it,
  // but for grazing ones.
  Grid<float> level = sampleScene(*findScene(GetParam()), 64);
  makeLevel(level.view(), 0, Inside::below);
  glm::dmat4 worldFromGrid = glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(1, 2, 0.5));
  worldFromGrid = glm::scale(worldFromGrid, glm::dvec3(1, 1.2, 0.9));
  // Hills have shadows under low lights alone.
  const bool hills = GetParam() == "terrain";
  const glm::dmat3 world(worldFromGrid);
  for (const glm::dvec3 light : {hills ? world * glm::dvec3(1, 0.2, 0.2) : glm::dvec3(0.3, -0.5, 0.8),
                                 hills ? world * glm::dvec3(-0.3, 1, 0.15) : glm::dvec3(0.9, -0.1, 0.4)})
    expectAgreement(compareShadows(std::as_const(level).view(), worldFromGrid, {.azimuthDegrees = 40}, light, 160));
}

INSTANTIATE_TEST_SUITE_P(All, SceneShadow, testing::ValuesIn(sceneNames()),
                         [](const auto& scene) { return std::string(scene.param); });

void expectAgreementOn(const std::string& path, float isovalue) {
  Volume volume = readVolume(path);
  makeLevel(volume.values.view(), isovalue, Inside::above);
  expectAgreement(compareShadows(std::as_const(volume.values).view(), volume.worldFromGrid,
                                 {.azimuthDegrees = 30, .elevationDegrees = 20}, {-1, -1, 1.5}, 256));
}

TEST(RealShadow, Cranium) {
  // On a head CT the shader's shadow is that of exact rays, but for grazing ones.
  ISOLUME_NEED_SHARED(path, "cranium.mhd");
  expectAgreementOn(path, 300);
}

#ifdef ISOLUME_HAVE_ITK
TEST(RealShadow, Mni152) {
  // On a brain template the shader's shadow is that of exact rays, but for grazing ones.
  ISOLUME_NEED_SHARED(path, "mni152_2009.nii.gz");
  expectAgreementOn(path, 600);
}

TEST(RealShadow, BetaGal) {
  // On a noisy density map the shader's shadow is that of exact rays, but for grazing ones.
  ISOLUME_NEED_SHARED(path, "betaGal.mrc");
  expectAgreementOn(path, 0.06F);
}
#endif

TEST(Shadow, NeedsADirection) {
  // A light from nowhere is an error.
  const GlScene scene = makeSphere(24, 7.3);
  EXPECT_THROW(renderOnce(scene, frameScene(scene), shadowSettings(glm::dvec3(0))), GpuError);
}

}  // namespace
}  // namespace isolume::test
