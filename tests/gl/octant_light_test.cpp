// The octants as eight lights whose colours change from frame to frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <vector>

#include "gl/gl_scene.h"
#include "raymarch/gpu_error.h"
#include "support/octant_openness.h"
#include "sweep/occlusion_sweep.h"

namespace isolume::test {
namespace {

RenderSettings octantSettings() {
  RenderSettings settings = layerSettings(60, 48);
  settings.shading = Shading::octants;
  return settings;
}

TEST(OctantLight, EachShinesInItsOwnColour) {
  // With one octant alight, an open surface has its colour times G_s(N) / pi, by either geometry term; all normals
  // occur. The tables are good to 1e-4 of G, and 8-bit weights of hardware filters add half as much.
  constexpr double kTolerance = 2e-4;
  const GlScene scene = makeSphere();
  const glm::vec3 color(1, 0.5F, 0.125F);
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  renderer.upload(scene.fields());
  for (const double azimuth : {30.0, 210.0})
    for (const GeometryTerm term : {GeometryTerm::front, GeometryTerm::bothSides})
      for (int octant = 0; octant < kOctantCount; ++octant) {
        RenderSettings settings = octantSettings();
        settings.geometryTerm = term;
        settings.octantLight.fill(glm::vec3(0));
        settings.octantLight[static_cast<std::size_t>(octant)] = color;
        const double elevation = azimuth > 180 ? -25 : 25;
        const Camera camera = frameScene(scene, {.azimuthDegrees = azimuth, .elevationDegrees = elevation});
        const Frame frame = renderer.render(camera, settings);
        double brightest = 0;
        for (std::size_t i = 0; i < frame.depth.size(); ++i) {
          if (!std::isfinite(frame.depth[i])) continue;
          const glm::dvec3 normal = glm::normalize(glm::dvec3(frame.normal[i]));
          const double term1 = octantGeometryTerm(octant, normal, term) / M_PI;
          for (int c = 0; c < 3; ++c) ASSERT_NEAR(frame.light[i][c], term1 * color[c], kTolerance) << octant;
          brightest = std::max(brightest, term1);
        }
        EXPECT_GT(brightest, 0.04) << "octant " << octant;
      }
}

TEST(OctantLight, ChangesAreOfOneFrame) {
  // Lights and geometry term are those of the frame: after frames with others, the picture has the bits of the first.
  GlScene scene = makeSphere();
  scene.octants = sweepOcclusion(scene.fields().level, {.opacity = 0.3F}).visibility.packed;
  const Camera camera = frameScene(scene);
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  renderer.upload(scene.fields());
  const Frame first = renderer.render(camera, octantSettings());
  RenderSettings cloudy = octantSettings();
  for (int s = 0; s < kOctantCount; ++s)
    if (kOctants[static_cast<std::size_t>(s)].towardsLight().z < 0)
      cloudy.octantLight[static_cast<std::size_t>(s)] = glm::vec3(0);
  RenderSettings translucent = octantSettings();
  translucent.geometryTerm = GeometryTerm::bothSides;
  const Frame fromAbove = renderer.render(camera, cloudy), throughIt = renderer.render(camera, translucent);
  const Frame again = renderer.render(camera, octantSettings());
  EXPECT_EQ(first.color, again.color);
  EXPECT_EQ(first.light, again.light);
  EXPECT_NE(first.light, throughIt.light);
  for (std::size_t i = 0; i < first.light.size(); ++i) {
    if (!std::isfinite(first.depth[i])) continue;
    ASSERT_LE(fromAbove.light[i].x, first.light[i].x);
    // Straight down no light of the upper half arrives.
    if (first.normal[i].z < -0.999F) {
      ASSERT_LT(fromAbove.light[i].x, 0.01F);
    }
  }
}

TEST(OctantLight, TermsDividedByAnOpenPlaneAreOfTheirOffsetAndScene) {
  // Divided by what an open plane gives, a picture has the bits of one by a renderer of its own, whatever offsets and
  // spacings were drawn before; each of them changes it. All octants are a quarter open: nothing is clipped at 1, and
  // what they are read at changes nothing else.
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  const auto draw = [](Renderer& by, const GlScene& scene, float offset) {
    RenderSettings settings = octantSettings();
    settings.openPlaneTerms = true;
    settings.occlusionOffsetVoxels = offset;
    by.upload(scene.fields());
    return by.render(frameScene(scene), settings).light;
  };
  const auto quarterOpen = [](GlScene scene) {
    for (Grid<glm::u8vec4>& grid : scene.octants) std::fill_n(grid.data(), grid.view().count(), glm::u8vec4(64));
    return scene;
  };
  const GlScene even = quarterOpen(makeSphere()), flat = quarterOpen(makeSphere(48, 17.3, {1, 1, 0.7}));
  std::vector<std::vector<glm::vec3>> drawn;
  for (const GlScene* scene : {&even, &flat})
    for (const float offset : {0.0F, 2.0F, 0.0F}) {
      Renderer own(*context);
      drawn.push_back(draw(renderer, *scene, offset));
      EXPECT_EQ(drawn.back(), draw(own, *scene, offset));
    }
  EXPECT_NE(drawn[0], drawn[1]);
  EXPECT_EQ(drawn[0], drawn[2]);
}

TEST(OctantLight, TermsOfBothSidesAreNotDividedByAnOpenPlane) {
  const GlScene scene = makeSphere(16, 5);
  RenderSettings settings = octantSettings();
  settings.openPlaneTerms = true;
  settings.geometryTerm = GeometryTerm::bothSides;
  EXPECT_THROW(renderOnce(scene, frameScene(scene), settings), GpuError);
}

TEST(OctantLight, ThroughAClearSolidAllIsLit) {
  // At opacity 0 every pixel has light 1 from the front, and 2 from both sides.
  GlScene scene = makeSphere();
  scene.octants = sweepOcclusion(scene.fields().level, {.opacity = 0}).visibility.packed;
  for (const GeometryTerm term : {GeometryTerm::front, GeometryTerm::bothSides}) {
    RenderSettings settings = octantSettings();
    settings.geometryTerm = term;
    const Frame frame = renderOnce(scene, frameScene(scene), settings);
    const float want = term == GeometryTerm::front ? 1 : 2;
    for (std::size_t i = 0; i < frame.light.size(); ++i) {
      if (!std::isfinite(frame.depth[i])) continue;
      ASSERT_NEAR(frame.light[i].x, want, 1e-4);
    }
  }
}

TEST(OctantLight, CombinedIsDrawnAsAField) {
  // The octants as one number are drawn as any light field: their mean, interpolated at the hit.
  GlScene scene = makeSphere();
  const SweptFields octants = sweepOcclusion(scene.fields().level, {.visibility = VisibilityStorage::float32});
  const SweptFields combined = sweepOcclusion(scene.fields().level, {.visibility = VisibilityStorage::combined});
  scene.openness = surfaceField(combined.visibility.combined.view());
  RenderSettings settings = layerSettings(60, 48);
  settings.shading = Shading::lights;
  SceneFields fields = scene.fields();
  fields.lights[0].everywhere = true;
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  renderer.upload(fields);
  const Frame frame = renderer.render(frameScene(scene), settings);
  int hits = 0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (!std::isfinite(frame.depth[i])) continue;
    ++hits;
    double mean = 0;
    for (const Grid<float>& octant : octants.visibility.octants)
      mean += trilinear(octant.view(), glm::dvec3(frame.position[i])) / kOctantCount;
    // The sweep in 16-bit lanes is off by 11 steps at most (sweep/octants/fixed_light_sweeper.h); a 12th for the
    // texture.
    ASSERT_NEAR(frame.light[i].x, mean, 12.0 / 65535);
  }
  EXPECT_GT(hits, 200);
}

TEST(OctantLight, IsFiniteAndNotNegative) {
  // A light that is negative, infinite or not a number is an error that names its octant.
  const GlScene scene = makeSphere(24, 7.3);
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  renderer.upload(scene.fields());
  for (const float bad : {-0.5F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    RenderSettings settings = octantSettings();
    settings.octantLight[5].y = bad;
    try {
      renderer.render(frameScene(scene), settings);
      ADD_FAILURE() << bad;
    } catch (const GpuError& error) {
      EXPECT_NE(std::string(error.what()).find("octant pnp: expected a finite light"), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace isolume::test
