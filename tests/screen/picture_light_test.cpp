// What becomes of the openness in pictures lighted from the screen: colour, light of neighbours, filter, product.
#include <glm/geometric.hpp>

#include "screen/screen_pictures.h"

namespace isolume::test {
namespace {

TEST_F(ScreenPictures, ColourIsAlbedoTimesOpenness) {
  // The colour of a pixel is albedo * openness^(1 / gamma), and the background where nothing is hit; with several
  // samples a pixel on the silhouette is a mean of both.
  const GlScene scene = makeSphere();
  const Camera camera = frameScene(scene);
  RenderSettings settings = screenSettings(ScreenEstimator::crytek);
  settings.albedo = {0.5f, 0.25f, 1};
  settings.gamma = 2;
  settings.background = {0, 1, 0, 0.5f};
  const Frame frame = draw(scene, camera, settings);
  for (std::size_t i = 0; i < frame.color.size(); ++i) {
    const bool hit = std::isfinite(frame.depth[i]);
    const float light = std::sqrt(frame.light[i].r);
    const glm::vec4 want = hit ? glm::vec4(settings.albedo * light, 1) : glm::vec4(0, 0.5f, 0, 0.5f);
    ASSERT_LT(glm::distance(frame.color[i], want), 1e-5) << i;
  }
  settings.samples = 8;
  const Frame smooth = draw(scene, camera, settings);
  int between = 0;
  for (const glm::vec4& color : smooth.color) between += color.a > 0.51f && color.a < 0.99f ? 1 : 0;
  EXPECT_GT(between, 50);
}

TEST_F(ScreenPictures, NeighboursLightWhatIsClosed) {
  // With light from the neighbourhood a pixel's light is O + L (1 - O), L being albedo times the openness of what it
  // faces, so that with an albedo of half as much green as red L has half as much green; a convex solid faces nothing
  // and keeps its picture to the last bit, and so does the openness everywhere.
  RenderSettings plain = screenSettings(ScreenEstimator::szirmayVolumetric);
  plain.albedo = {1, 0.5f, 0.25f};
  RenderSettings lit = plain;
  lit.screen->indirect = true;
  const GlScene room = makeRoom();
  const Frame closed = draw(room, roomCamera(), plain), open = draw(room, roomCamera(), lit);
  int lighted = 0;
  for (std::size_t i = 0; i < open.color.size(); ++i) {
    ASSERT_EQ(open.light[i].r, closed.light[i].r);
    if (!std::isfinite(open.depth[i])) continue;
    const glm::vec3 gained = glm::vec3(open.color[i] - closed.color[i]) / plain.albedo;
    ASSERT_GE(gained.r, 0);
    ASSERT_LE(gained.r, 1 - open.light[i].r + 1e-6f);
    ASSERT_NEAR(gained.g, gained.r / 2, 1e-6);
    ASSERT_NEAR(gained.b, gained.r / 4, 1e-6);
    lighted += gained.r > 0.05f ? 1 : 0;
  }
  EXPECT_GT(lighted, 100);
  const GlScene ball = makeSphere();
  const Frame dark = draw(ball, frameScene(ball), plain), same = draw(ball, frameScene(ball), lit);
  EXPECT_TRUE(sameBits(dark.color, same.color));
}

/// A floor, and a step of height 4 beyond x = 40.6, seen from behind the step: its riser is hidden.
GlScene makeStep() {
  return makeScene({64, 64, 64}, glm::dvec3(1), [](glm::dvec3 p) {
    return std::min(p.z - kFloorHeight, std::max(kWallX - p.x, p.z - kFloorHeight - 4));
  });
}
Camera stepCamera() {
  Camera camera;
  camera.target = {36, 32, 22};
  camera.eye = camera.target + glm::dvec3(50, 0, 90);
  camera.fovDegrees = 15;
  return camera;
}

TEST_F(ScreenPictures, WhatFacesAwayLightsNothing) {
  // The floor has the top of the step in its neighbourhood, above its tangent plane, but the top does not face it:
  // nothing is lighted, to the last bit.
  RenderSettings plain = screenSettings(ScreenEstimator::szirmayVolumetric);
  RenderSettings lit = plain;
  lit.screen->indirect = true;
  const GlScene scene = makeStep();
  const Frame dark = draw(scene, stepCamera(), plain), same = draw(scene, stepCamera(), lit);
  for (std::size_t i = 0; i < dark.color.size(); ++i)
    if (dark.normal[i].z > 0.999) {
      ASSERT_EQ(dark.color[i], same.color[i]);
    }
}

TEST_F(ScreenPictures, FilterKeepsSurfacesApart) {
  // Along the edge of the step its open top and the dark floor behind it are neighbours in the picture, with the same
  // normal: the filter mixes none of the dark into the top.
  // A coarse picture and a large pattern, so that windows reach over the voxel along the edge whose normals lean.
  RenderSettings settings = screenSettings(ScreenEstimator::szirmayVolumetric, {100, 80});
  settings.screen->interleaving = 8;
  const Frame frame = draw(makeStep(), stepCamera(), settings);
  int top = 0, dark = 0;
  for (std::size_t i = 0; i < frame.light.size(); ++i) {
    if (frame.normal[i].z < 0.999) continue;
    const bool onTop = frame.position[i].z > kFloorHeight + 2;
    if (onTop) {
      ASSERT_GT(frame.light[i].r, 0.998);
    }
    top += onTop ? 1 : 0;
    dark += !onTop && frame.light[i].r < 0.95 ? 1 : 0;
  }
  EXPECT_GT(top, 500);
  EXPECT_GT(dark, 100);
}

TEST_F(ScreenPictures, FilterTakesThePatternAway) {
  // Pixels of a pattern differ by what their samples make of the same place; the filter averages over exactly one
  // period, so on a flat wall seen in parallel nothing of the pattern is left. Without a pattern there is none.
  GlScene scene = makeRoom();
  Camera camera = roomCamera();
  camera.projection = Projection::orthographic;
  camera.heightWorld = 40;
  const auto roughness = [](const Frame& frame) {  // of neighbours along rows, on the floor near the wall
    Differences differences;
    for (std::size_t i = 0; i + 1 < frame.light.size(); ++i) {
      const bool flat = frame.normal[i].z > 0.999 && frame.normal[i + 1].z > 0.999;
      if (flat && frame.position[i].x > kWallX - 0.5 * kRadius)
        differences.add(frame.light[i].r - frame.light[i + 1].r);
    }
    return differences.rms();
  };
  RenderSettings settings = screenSettings(ScreenEstimator::szirmayContainment);
  const double filtered = roughness(draw(scene, camera, settings));
  settings.screen->filter = false;
  const double plain = roughness(draw(scene, camera, settings));
  settings.screen->interleaving = 1;
  const double same = roughness(draw(scene, camera, settings));
  EXPECT_LT(filtered, plain / 3);
  EXPECT_LT(same, plain);
}

TEST_F(ScreenPictures, SecondRadiusMultiplies) {
  // With a second radius loos10 is the product of the openness within each; with the same radius twice, the square.
  const GlScene scene = makeRoom();
  for (const ScreenEstimator estimator :
       {ScreenEstimator::loosLine, ScreenEstimator::loosPoint, ScreenEstimator::loosArea}) {
    RenderSettings settings = screenSettings(estimator);
    settings.screen->filter = false;
    const Frame once = draw(scene, roomCamera(), settings);
    settings.screen->secondRadius = 1;
    const Frame twice = draw(scene, roomCamera(), settings);
    for (std::size_t i = 0; i < once.light.size(); ++i)
      ASSERT_NEAR(twice.light[i].r, once.light[i].r * once.light[i].r, 1e-5);
  }
}

}  // namespace
}  // namespace isolume::test
