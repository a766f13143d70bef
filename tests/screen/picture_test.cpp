// Pictures whose light comes from the screen, on the GPU: closed forms, and what must not change them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <numbers>

#include "gl/gl_scene.h"
#include "raymarch/gpu_error.h"
#include "volumes/scene_families.h"

namespace isolume::test {
namespace {

constexpr double kRadius = 8;  // voxels, spacing 1

RenderSettings screenSettings(ScreenEstimator estimator, glm::ivec2 size = {200, 160}) {
  RenderSettings settings = layerSettings(size.x, size.y);
  settings.screen = ScreenOcclusion{.estimator = estimator, .radiusWorld = kRadius, .samples = 16};
  return settings;
}

/// A floor below z = 20.3 and a wall beyond x = 40.6.
constexpr double kFloorHeight = 20.3, kWallX = 40.6;
GlScene makeRoom() {
  return makeScene({64, 64, 64}, glm::dvec3(1),
                   [](glm::dvec3 p) { return std::min(p.z - kFloorHeight, kWallX - p.x); });
}
/// Sees floor and wall, everything else being beyond the picture.
Camera roomCamera(double roll = 0) {
  Camera camera;
  camera.target = {36, 32, 22};
  camera.eye = camera.target + glm::dvec3(-60, -50, 70);
  camera.rollDegrees = roll;
  camera.fovDegrees = 20;
  return camera;
}

class Pictures : public ::testing::Test {
 protected:
  Frame draw(const GlScene& scene, const Camera& camera, const RenderSettings& settings) {
    renderer_.upload(scene.fields());
    return renderer_.render(camera, settings);
  }
  std::unique_ptr<Context> context_ = makeContext("osmesa");
  Renderer renderer_{*context_};
};

/// Largest and root mean square difference to a closed form, over the pixels that it holds for.
struct Differences {
  double largest = 0, square = 0;
  int count = 0;
  void add(double difference) {
    largest = std::max(largest, std::abs(difference));
    square += difference * difference;
    ++count;
  }
  double rms() const { return std::sqrt(square / count); }
};

TEST_F(Pictures, ConvexSolidIsOpen) {
  // A tilted plane, cut by the box, occludes nowhere: each estimator that gives 1 on a plane gives 1 at every pixel, in
  // perspective and at a coarse resolution, and so does the crytek ball its half. Tolerance: pixels at the edges, whose
  // smooth normals lean over.
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, -0.3, 0.8));
  const GlScene scene = makeScene({48, 48, 48}, glm::dvec3(1),
                                  [&](glm::dvec3 p) { return glm::dot(p - glm::dvec3(24, 24, 20), normal); });
  for (const ScreenEstimator estimator : screenEstimators()) {
    if (estimator == ScreenEstimator::loosArea) continue;  // loses some of a tilted plane: closed_form_test.cpp
    const Frame frame = draw(scene, frameScene(scene), screenSettings(estimator, {100, 80}));
    Differences flat;
    for (std::size_t i = 0; i < frame.light.size(); ++i) {
      const glm::vec3 p = frame.position[i];
      if (!std::isfinite(frame.depth[i]) || glm::dot(glm::dvec3(frame.normal[i]), normal) < 0.9999) continue;
      const bool inside = std::min({p.x, p.y, 47 - p.x, 47 - p.y, p.z, 47 - p.z}) > kRadius;
      if (estimator != ScreenEstimator::crytek)
        flat.add(frame.light[i].r - 1);
      else if (inside)
        flat.add(frame.light[i].r - 0.5);
    }
    ASSERT_GT(flat.count, 500);
    EXPECT_LT(flat.largest, estimator == ScreenEstimator::crytek ? 0.03 : 2e-3) << screenEstimatorName(estimator);
  }
}

/// Floor pixels at least a fifth of a radius from the wall, where they are told from it, and away from the border.
template <class Truth>
Differences floorDifferences(const Frame& frame, Truth truth) {
  Differences differences;
  for (std::size_t i = 0; i < frame.light.size(); ++i) {
    const int x = static_cast<int>(i) % frame.size.x, y = static_cast<int>(i) / frame.size.x;
    const int border = std::min({x, y, frame.size.x - 1 - x, frame.size.y - 1 - y});
    const double a = (kWallX - frame.position[i].x) / kRadius;
    if (border < frame.size.x / 5 || frame.normal[i].z < 0.999 || a < 0.2) continue;
    differences.add(frame.light[i].r - truth(a));
  }
  return differences;
}

double volumetricTruth(double a) {
  const double h = std::max(0.0, 0.5 - a);  // of the cap that the wall cuts from the tangent sphere
  return 1 - 2 * h * h * (1.5 - h);
}

TEST_F(Pictures, FloorBeforeAWall) {
  // On a floor before a wall volumetric ambient occlusion is the tangent sphere less a cap, by all three characteristic
  // functions, of which the z-buffer and the implicit one know the wall as it is; a height field that ends at the
  // wall's top does as well. 16 pipes in a pattern of 16 leave an error of about a percent.
  const GlScene scene = makeRoom();
  for (const Characteristic surface :
       {Characteristic::zBuffer, Characteristic::heightField, Characteristic::implicit}) {
    RenderSettings settings = screenSettings(ScreenEstimator::szirmayVolumetric);
    settings.screen->surface = surface;
    const Frame frame = draw(scene, roomCamera(), settings);
    const Differences differences = floorDifferences(frame, volumetricTruth);
    ASSERT_GT(differences.count, 1000);
    EXPECT_LT(differences.rms(), 0.02) << static_cast<int>(surface);
    EXPECT_LT(differences.largest, 0.08) << static_cast<int>(surface);
  }
}

TEST_F(Pictures, AreasBeforeAWall) {
  // loos10-area is the half ball less what the wall cuts, (1 - a)^2 (2 + a) / 4, up to what depths that spread cost on
  // tilted surfaces: with 64 areas a few percent, to the dark side.
  const GlScene scene = makeRoom();
  RenderSettings settings = screenSettings(ScreenEstimator::loosArea);
  settings.screen->samples = 64;
  const Frame frame = draw(scene, roomCamera(), settings);
  const Differences differences =
      floorDifferences(frame, [](double a) { return a < 1 ? 1 - (1 - a) * (1 - a) * (2 + a) / 4 : 1.0; });
  ASSERT_GT(differences.count, 1000);
  EXPECT_LT(differences.rms(), 0.05);
}

TEST_F(Pictures, GtaoBeforeAWall) {
  // The horizons of a floor before a wall leave open what does not project to the strip of the unit disk beyond a:
  // 1 - (acos a - a sqrt(1 - a^2)) / pi. With 256 samples the steps see the wall's top to a few percent, from below.
  const GlScene scene = makeRoom();
  RenderSettings settings = screenSettings(ScreenEstimator::gtao);
  settings.screen->samples = 256;
  const Frame frame = draw(scene, roomCamera(), settings);
  const Differences differences = floorDifferences(
      frame, [](double a) { return a < 1 ? 1 - (std::acos(a) - a * std::sqrt(1 - a * a)) / std::numbers::pi : 1.0; });
  ASSERT_GT(differences.count, 1000);
  EXPECT_LT(differences.rms(), 0.04);
}

/// Root mean square difference of openness on the isosurface, away from the border.
double difference(const Frame& a, const Frame& b, int side) {
  Differences differences;
  const auto last = static_cast<float>(side - 1);
  for (std::size_t i = 0; i < a.light.size(); ++i) {
    const glm::vec3 p = a.position[i];
    if (std::isfinite(a.depth[i]) && std::min({p.x, p.y, last - p.x, last - p.y}) > kRadius)
      differences.add(a.light[i].r - b.light[i].r);
  }
  return differences.rms();
}

TEST_F(Pictures, CharacteristicFunctionsAgreeOnTerrain) {
  // On a height field seen along z all three characteristic functions describe one solid, and the openness is the same:
  // to half a percent by pipes, whose ends move by what a Taylor step and half a pixel are off, and to two by
  // containment, where each sample near the surface may change sides. From aside the height field and the implicit
  // function still agree, while the z-buffer takes what hills hide for solid.
  constexpr int kSide = 64;
  const GlScene scene = makeScene(glm::ivec3(kSide), glm::dvec3(1),
                                  [](glm::dvec3 p) { return kSide * terrainValue((p + 0.5) / double(kSide)); });
  Camera above;
  above.target = glm::dvec3(kSide / 2.0);
  above.eye = above.target + glm::dvec3(0, 0, 100);
  above.up = {0, 1, 0};
  above.projection = Projection::orthographic;
  above.heightWorld = kSide;
  Camera aside = above;
  aside.eye = above.target + glm::dvec3(0, -100, 12);
  aside.up = {0, 0, 1};
  for (const ScreenEstimator estimator : {ScreenEstimator::szirmayVolumetric, ScreenEstimator::szirmayContainment}) {
    const auto by = [&](Characteristic surface, const Camera& camera) {
      RenderSettings settings = screenSettings(estimator, {160, 160});
      settings.screen->surface = surface;
      return draw(scene, camera, settings);
    };
    const double tolerance = estimator == ScreenEstimator::szirmayVolumetric ? 0.005 : 0.02;
    const Frame implicit = by(Characteristic::implicit, above);
    EXPECT_LT(difference(implicit, by(Characteristic::zBuffer, above), kSide), tolerance);
    EXPECT_LT(difference(implicit, by(Characteristic::heightField, above), kSide), tolerance);
    const Frame implicitAside = by(Characteristic::implicit, aside);
    const double heights = difference(implicitAside, by(Characteristic::heightField, aside), kSide);
    EXPECT_LT(heights, tolerance);
    EXPECT_GT(difference(implicitAside, by(Characteristic::zBuffer, aside), kSide), 1.5 * heights);
  }
}

double meanAmbient(const Frame& frame) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < frame.light.size(); ++i) {
    if (!std::isfinite(frame.depth[i])) continue;
    sum += frame.light[i].r;
    ++count;
  }
  return sum / count;
}

TEST_F(Pictures, ResolutionDoesNotMatter) {
  // The radius is a length of the world: the mean openness of a picture is that of one with four times the pixels.
  // Tolerance: a pixel row along each silhouette and edge, where the mean over fewer pixels is a coarser sum.
  const GlScene scene = makeRoom();
  for (const ScreenEstimator estimator : screenEstimators())
    EXPECT_NEAR(meanAmbient(draw(scene, roomCamera(), screenSettings(estimator, {120, 120}))),
                meanAmbient(draw(scene, roomCamera(), screenSettings(estimator, {240, 240}))), 0.01)
        << screenEstimatorName(estimator);
}

TEST_F(Pictures, RollTurnsThePicture) {
  // A camera that rolls by a quarter turn gives the same picture turned, beyond the noise of the samples: the pattern
  // does not turn with it.
  const GlScene scene = makeRoom();
  constexpr int kSide = 160;
  for (const ScreenEstimator estimator : screenEstimators()) {
    RenderSettings settings = screenSettings(estimator, {kSide, kSide});
    settings.screen->samples = 64;
    const Frame upright = draw(scene, roomCamera(), settings);
    const Frame rolled = draw(scene, roomCamera(90), settings);
    Differences differences;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        // The camera turns clockwise, the picture the other way: right becomes up.
        const auto from = static_cast<std::size_t>(y * kSide + x);
        const auto to = static_cast<std::size_t>((kSide - 1 - x) * kSide + y);
        if (upright.depth[from] == rolled.depth[to]) continue;  // both see nothing
        ASSERT_NEAR(upright.depth[from], rolled.depth[to], 1e-3);
        differences.add(upright.light[from].r - rolled.light[to].r);
      }
    }
    EXPECT_LT(differences.rms(), 0.02) << screenEstimatorName(estimator);
  }
}

TEST_F(Pictures, LayersAreThoseOfAnyPicture) {
  // Position, depth and normal have the bits that the march without the screen gives: the G-buffer is the same trace.
  const GlScene scene = makeSphere();
  const Camera camera = frameScene(scene);
  const Frame local = draw(scene, camera, layerSettings());
  RenderSettings settings = layerSettings();
  settings.screen = ScreenOcclusion{.radiusWorld = kRadius};
  const Frame screen = draw(scene, camera, settings);
  const auto same = [](const auto& a, const auto& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
  };
  EXPECT_TRUE(same(local.position, screen.position));
  EXPECT_TRUE(same(local.normal, screen.normal));
  EXPECT_TRUE(same(local.depth, screen.depth));
  ASSERT_EQ(screen.light.size(), screen.depth.size());
}

TEST_F(Pictures, ColourIsAlbedoTimesOpenness) {
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

TEST_F(Pictures, FilterTakesThePatternAway) {
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

TEST_F(Pictures, SecondRadiusMultiplies) {
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

TEST_F(Pictures, NeighboursLightWhatIsClosed) {
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
  EXPECT_EQ(std::memcmp(dark.color.data(), same.color.data(), dark.color.size() * sizeof(glm::vec4)), 0);
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

TEST_F(Pictures, WhatFacesAwayLightsNothing) {
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

TEST_F(Pictures, FilterKeepsSurfacesApart) {
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

TEST_F(Pictures, UnderACeiling) {
  // Between floor and ceiling the lines through the tangent sphere leave the solid of the ceiling as they go away from
  // the eye: by the implicit function the sphere less the cap that the ceiling cuts is open.
  constexpr double kGap = 6;
  const GlScene scene = makeScene({64, 64, 64}, glm::dvec3(1),
                                  [](glm::dvec3 p) { return std::min(p.z - kFloorHeight, kFloorHeight + kGap - p.z); });
  Camera camera;
  camera.target = {32, 32, kFloorHeight};
  camera.eye = camera.target + glm::dvec3(0, -95, 5.5);
  camera.fovDegrees = 20;
  RenderSettings settings = screenSettings(ScreenEstimator::szirmayVolumetric);
  settings.screen->surface = Characteristic::implicit;
  const Frame frame = draw(scene, camera, settings);
  Differences differences;
  for (std::size_t i = 0; i < frame.light.size(); ++i) {
    const glm::vec3 p = frame.position[i];
    if (frame.normal[i].z > 0.999 && std::min({p.x, p.y, 63 - p.x, 63 - p.y}) > kRadius)
      differences.add(frame.light[i].r - volumetricTruth(kGap / kRadius - 0.5));
  }
  ASSERT_GT(differences.count, 200);
  EXPECT_LT(differences.largest, 0.03);
}

TEST_F(Pictures, NothingIsLeftOfThePictureBefore) {
  // Drawn again after pictures of other sizes, estimators, scenes and shadings, every layer has the same bits; so has
  // the picture without the screen that is drawn between.
  const GlScene room = makeRoom();
  RenderSettings settings = screenSettings(ScreenEstimator::szirmayVolumetric);
  settings.screen->surface = Characteristic::heightField;
  settings.screen->indirect = true;
  settings.samples = 2;
  const Frame first = draw(room, roomCamera(), settings);
  const Frame plain = draw(room, roomCamera(), layerSettings());
  draw(makeSphere(), frameScene(makeSphere()), screenSettings(ScreenEstimator::loosArea, {31, 77}));
  const Frame again = draw(room, roomCamera(), settings);
  const Frame plainAgain = draw(room, roomCamera(), layerSettings());
  const auto same = [](const auto& a, const auto& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
  };
  EXPECT_TRUE(same(first.color, again.color));
  EXPECT_TRUE(same(first.light, again.light));
  EXPECT_TRUE(same(first.normal, again.normal));
  EXPECT_TRUE(same(plain.color, plainAgain.color));
}

TEST_F(Pictures, SettingsThatCannotBeDrawn) {
  // A radius, a number of samples, a pattern, a thickness or a membership that makes no sense is a GpuError of one
  // line.
  const GlScene scene = makeSphere(16, 5);
  renderer_.upload(scene.fields());
  const auto expectError = [&](auto change, const char* text) {
    RenderSettings settings = screenSettings(ScreenEstimator::gpuSphere);
    change(*settings.screen);
    try {
      renderer_.render(frameScene(scene), settings);
      ADD_FAILURE() << "no error: " << text;
    } catch (const GpuError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  expectError([](ScreenOcclusion& s) { s.radiusWorld = 0; }, "a radius above 0, found 0");
  expectError([](ScreenOcclusion& s) { s.samples = 257; }, "1 to 256 samples, found 257");
  expectError([](ScreenOcclusion& s) { s.interleaving = 0; }, "a pattern of side 1 to 8, found 0");
  expectError([](ScreenOcclusion& s) { s.thicknessWorld = -1; }, "a thickness above 0, found -1");
  expectError([](ScreenOcclusion& s) { s.secondRadius = 0; }, "a second radius above 0, found 0");
  expectError([](ScreenOcclusion& s) { s.membership = Membership::classical; }, "a membership function");
}

}  // namespace
}  // namespace isolume::test
