// Surfaces coloured by a field on a grid of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "gl/gl_scene.h"
#include "raymarch/gpu_error.h"

namespace isolume::test {
namespace {

/// Three colours, bent in the middle.
const std::vector<glm::vec3> kColors{{0.1F, 0.2F, 0.9F}, {0.8F, 0.9F, 0.3F}, {0.6F, 0.1F, 0}};
const glm::vec3 kUnknown(0.25F, 0.5F, 0.75F);

glm::dvec3 colorAt(double place) {
  const double along = std::clamp(place, 0.0, 1.0) * 2;
  return along < 1 ? glm::mix(glm::dvec3(kColors[0]), glm::dvec3(kColors[1]), along)
                   : glm::mix(glm::dvec3(kColors[1]), glm::dvec3(kColors[2]), along - 1);
}

/// A coarse turned grid of its own around the sphere's, with places that are linear in the world.
struct Coloring {
  Grid<float> places;
  glm::dmat4 worldFromGrid;
  glm::dvec3 slope{0.09, -0.033, 0.051};
  double offset = -2.2;

  explicit Coloring(glm::ivec3 size = {9, 12, 10}, double spacing = 9) : places(size, glm::dvec3(spacing)) {
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(1, 2, -1));
    worldFromGrid = glm::translate(glm::dmat4(1), sphereCentre(48)) * turned *
                    glm::scale(glm::dmat4(1), glm::dvec3(spacing)) *
                    glm::translate(glm::dmat4(1), -0.5 * (glm::dvec3(size) - 1.0));
    for (int k = 0; k < size.z; ++k)
      for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i)
          places.view()(i, j, k) = static_cast<float>(placeAt(glm::dvec3(worldFromGrid * glm::dvec4(i, j, k, 1))));
  }
  double placeAt(glm::dvec3 world) const { return glm::dot(slope, world) + offset; }
  ColorField field() const { return {places.view(), worldFromGrid, kColors, kUnknown}; }
};

Frame draw(const GlScene& scene, const ColorField& color, RenderSettings settings) {
  settings.albedo = glm::vec3(0.7F);  // in vain
  SceneFields fields = scene.fields();
  fields.color = color;
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  renderer.upload(fields);
  return renderer.render(frameScene(scene), settings);
}

template <class Check>
void forEachHit(const Frame& frame, const Check& check) {
  int hits = 0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (!std::isfinite(frame.depth[i])) continue;
    ++hits;
    check(i);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(hits, 1000);
}

TEST(SurfaceColor, IsTheMapAtTheInterpolatedPlace) {
  // A field that is linear in the world gives each hit the colour of its place times its light, in every way of shading
  // and from the screen, beyond the ends too. Places are of float positions on a grid of 48: within 1e-5, times the
  // steepest colour 5.
  constexpr double kTolerance = 5e-5;
  GlScene scene = makeSphere();
  scene.worldFromGrid = glm::translate(glm::rotate(glm::dmat4(1), 0.1, glm::dvec3(1, 0, 2)), glm::dvec3(2, -3, 1));
  const Coloring coloring;
  RenderSettings screen = layerSettings();
  screen.screen = ScreenOcclusion{.radiusWorld = 4};
  RenderSettings octants = layerSettings(), lights = layerSettings();
  octants.shading = Shading::octants;
  lights.shading = Shading::lights;
  for (const RenderSettings& settings : {layerSettings(), octants, lights, screen}) {
    const Frame frame = draw(scene, coloring.field(), settings);
    double lowest = 1, highest = 0;
    forEachHit(frame, [&](std::size_t i) {
      const double place = coloring.placeAt(glm::dvec3(frame.position[i]));
      lowest = std::min(lowest, place);
      highest = std::max(highest, place);
      const glm::dvec3 expected = colorAt(place) * glm::dvec3(frame.light[i]);
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(frame.color[i][c], expected[c], kTolerance) << place;
    });
    EXPECT_LT(lowest, 0);
    EXPECT_GT(highest, 1);
  }
}

TEST(SurfaceColor, AConstantFieldIsAnAlbedo) {
  // A field of one place draws what the albedo of that colour draws, light from the neighbourhood included.
  const GlScene scene = makeScene({32, 32, 32}, glm::dvec3(1), [](glm::dvec3 p) {
    return std::max(10 - p.z, -(std::hypot(p.x - 15.2, p.y - 15.7) - 7));  // a round hole with a rim
  });
  Coloring coloring;
  for (std::size_t i = 0; i < coloring.places.count(); ++i) coloring.places.data()[i] = 0.3F;
  RenderSettings settings = layerSettings();
  settings.screen = ScreenOcclusion{.radiusWorld = 6, .indirect = true};
  const Frame colored = draw(scene, coloring.field(), settings);
  settings.albedo = glm::vec3(colorAt(0.3));
  const Frame plain = renderOnce(scene, frameScene(scene), settings);
  settings.screen->indirect = false;
  const Frame direct = renderOnce(scene, frameScene(scene), settings);
  double gained = 0;
  for (std::size_t i = 0; i < plain.color.size(); ++i) {
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(colored.color[i][c], plain.color[i][c], 1e-5);
    gained = std::max(gained, static_cast<double>(plain.color[i].g - direct.color[i].g));
  }
  EXPECT_GT(gained, 0.05);
}

TEST(SurfaceColor, UnknownSamplesAreLeftOut) {
  // Where unknown samples weigh more than half, or the field ends more than half a voxel before, the colour is that of
  // the unknown; elsewhere the known ones alone are averaged: of a constant field they give the constant.
  const GlScene scene = makeSphere();
  Coloring coloring;
  coloring.worldFromGrid = glm::scale(glm::dmat4(1), glm::dvec3(9));  // x up to 72, y 99; z ends at 27
  coloring.places = Grid<float>({9, 12, 4});
  for (std::size_t i = 0; i < coloring.places.count(); ++i)
    coloring.places.data()[i] = i % 9 < 3 ? kUnknownPlace : 0.25F;  // unknown below x = 27
  const Frame frame = draw(scene, coloring.field(), layerSettings());
  int known = 0, unknown = 0;
  forEachHit(frame, [&](std::size_t i) {
    const glm::vec3 at = frame.position[i];
    constexpr float kEdgeX = 22.5F, kEdgeZ = 31.5F, kNear = 1e-3F;
    if (std::abs(at.x - kEdgeX) < kNear || std::abs(at.z - kEdgeZ) < kNear) return;
    const bool seen = at.x > kEdgeX && at.z < kEdgeZ;
    (seen ? known : unknown) += 1;
    const glm::dvec3 expected = (seen ? colorAt(0.25) : glm::dvec3(kUnknown)) * glm::dvec3(frame.light[i]);
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(frame.color[i][c], expected[c], 1e-6) << at.x << " " << at.z;
  });
  EXPECT_GT(known, 100);
  EXPECT_GT(unknown, 100);
}

TEST(SurfaceColor, PlacesAreNotClampedBeforeTheyAreInterpolated) {
  // Between samples far below and far above the map the colours stand where the field crosses its range, for a field of
  // the same grid as the level: the surface of a ball coloured by its own distance has one colour.
  const GlScene scene = makeSphere();
  Grid<float> places({48, 48, 48});
  for (std::size_t i = 0; i < places.count(); ++i) places.data()[i] = 0.5F + 40 * scene.level.data()[i];
  const Frame frame = draw(scene, {places.view(), glm::dmat4(1), kColors, kUnknown}, layerSettings());
  // A hit is a zero of the level to about 1e-6 of it; 40 times that, at the steepest colour.
  forEachHit(frame, [&](std::size_t i) {
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(frame.color[i][c], colorAt(0.5)[c] * frame.light[i][c], 1e-3);
  });
}

TEST(SurfaceColor, ComesAndGoesWithTheScene) {
  // The same renderer draws a scene without colours, with them and without again: first and last have the same bits,
  // from the surface as from the screen.
  const GlScene scene = makeSphere();
  const Coloring coloring;
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  RenderSettings screen = layerSettings();
  screen.screen = ScreenOcclusion{.radiusWorld = 4};
  for (const RenderSettings& settings : {layerSettings(), screen}) {
    std::vector<std::vector<glm::vec4>> pictures;
    for (const bool colored : {false, true, false}) {
      SceneFields fields = scene.fields();
      if (colored) fields.color = coloring.field();
      renderer.upload(fields);
      pictures.push_back(renderer.render(frameScene(scene), settings).color);
    }
    EXPECT_EQ(pictures[0], pictures[2]);
    EXPECT_NE(pictures[0], pictures[1]);
  }
}

TEST(SurfaceColor, AMapNeedsTwoColors) {
  // One colour is no map: refused at upload.
  const GlScene scene = makeSphere();
  const Coloring coloring;
  ColorField field = coloring.field();
  field.colors.resize(1);
  EXPECT_THROW(draw(scene, field, layerSettings()), GpuError);
}

}  // namespace
}  // namespace isolume::test
