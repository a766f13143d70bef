#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "gl/gl_scene.h"
#include "raymarch/framebuffer.h"
#include "raymarch/view.h"

namespace isolume::test {
namespace {

TEST(Sampling, OffsetsAreEvenlySpread) {
  // The first offset is the centre; the first n are within the pixel, distinct, and centred to about 1 / n.
  EXPECT_EQ(sampleOffset(0), glm::vec2(0));
  constexpr int kCount = 64;
  glm::vec2 sum(0);
  float nearest = 1;
  for (int i = 0; i < kCount; ++i) {
    const glm::vec2 offset = sampleOffset(i);
    EXPECT_LE(std::max(std::abs(offset.x), std::abs(offset.y)), 0.5f);
    sum += offset;
    for (int j = 0; j < i; ++j) nearest = std::min(nearest, glm::length(offset - sampleOffset(j)));
  }
  EXPECT_LT(glm::length(sum) / kCount, 2.0f / kCount);
  // A square lattice of 64 points has 1/8; the sequence keeps at least half of that.
  EXPECT_GT(nearest, 1.0f / 16);
}

TEST(Sampling, PictureIsTheMeanOfShiftedPictures) {
  // Four samples give the mean of four single-sample pictures whose cameras are shifted by the offsets (orthographic,
  // so that a shift of the camera is a shift of the picture).
  const GlScene scene = makeSphere();
  const Camera camera = frameScene(scene, {.projection = Projection::orthographic});
  RenderSettings settings = layerSettings();
  settings.background = {0.2f, 0.4f, 0.6f, 0.5f};
  settings.layers = false;
  settings.samples = 4;
  const Frame together = renderOnce(scene, camera, settings);
  settings.samples = 1;
  std::vector<glm::vec4> mean(together.color.size());
  const CameraAxes axes = cameraAxes(camera);
  const double pixel = camera.heightWorld / settings.size.y;
  for (int i = 0; i < 4; ++i) {
    Camera shifted = camera;
    const glm::dvec2 offset(sampleOffset(i));
    const glm::dvec3 step = pixel * (offset.x * axes.right - offset.y * axes.up);
    shifted.eye += step;
    shifted.target += step;
    const Frame one = renderOnce(scene, shifted, settings);
    for (std::size_t p = 0; p < mean.size(); ++p) mean[p] += one.color[p] * 0.25f;
  }
  int differing = 0, partial = 0;
  for (std::size_t p = 0; p < mean.size(); ++p) {
    differing += !(glm::length(mean[p] - together.color[p]) < 1e-4f);
    partial += together.color[p].a > 0.51f && together.color[p].a < 0.99f;
  }
  EXPECT_LE(differing, 4);  // pixels whose ray grazes the sphere
  EXPECT_GT(partial, 50);   // the rim really is averaged
}

TEST(Sampling, LayersAreThoseOfThePixelCentre) {
  // Layers do not change with the number of samples, not by a bit.
  const GlScene scene = makeSphere();
  RenderSettings settings = layerSettings();
  const Frame one = renderOnce(scene, frameScene(scene), settings);
  settings.samples = 5;
  const Frame five = renderOnce(scene, frameScene(scene), settings);
  EXPECT_EQ(one.normal, five.normal);
  EXPECT_EQ(one.depth, five.depth);
  EXPECT_EQ(one.light, five.light);
  EXPECT_NE(one.color, five.color);
}

TEST(Sampling, LayersComeOnlyOnRequestAndMissesAreMarked) {
  // No layers unless asked for; a miss has ambient 1, normal 0, position NaN, depth +inf and the premultiplied
  // background.
  const GlScene scene = makeSphere(24, 7.3);
  RenderSettings settings = layerSettings();
  settings.shading = Shading::octants;
  settings.background = {1, 0.5f, 0, 0.5f};
  const Frame frame = renderOnce(scene, frameScene(scene), settings);
  const std::size_t corner = 0, centre = frame.color.size() / 2 + static_cast<std::size_t>(frame.size.x) / 2;
  EXPECT_EQ(frame.color[corner], glm::vec4(0.5f, 0.25f, 0, 0.5f));
  EXPECT_EQ(frame.light[corner], glm::vec3(1));
  EXPECT_EQ(frame.normal[corner], glm::vec3(0));
  EXPECT_TRUE(std::isnan(frame.position[corner].x));
  EXPECT_EQ(frame.depth[corner], std::numeric_limits<float>::infinity());
  EXPECT_EQ(frame.color[centre].a, 1);
  EXPECT_TRUE(std::isfinite(frame.depth[centre]));
  settings.layers = false;
  const Frame plain = renderOnce(scene, frameScene(scene), settings);
  EXPECT_TRUE(plain.light.empty() && plain.normal.empty() && plain.position.empty() && plain.depth.empty());
  EXPECT_EQ(plain.color, frame.color);
}

TEST(Sampling, LargePicturesAreTiledWithoutSeams) {
  // A picture of several tiles in both directions has, row for row, the bits of the same picture in one piece: a
  // smaller picture with the same pixels, cut out of the middle by the field of view.
  const GlScene scene = makeSphere();
  Camera camera = frameScene(scene, {.projection = Projection::orthographic});
  constexpr int kWide = kTileWidth + 600, kHigh = 2 * kTilePixels / kTileWidth - 100;
  RenderSettings settings = layerSettings(kWide, kHigh);
  settings.layers = false;
  const Frame tiled = renderOnce(scene, camera, settings);
  settings.size = {500, 500};
  camera.heightWorld *= 500.0 / kHigh;
  const Frame middle = renderOnce(scene, camera, settings);
  int differing = 0;
  for (int y = 0; y < 500; ++y) {
    for (int x = 0; x < 500; ++x) {
      const glm::vec4 a = tiled.color[static_cast<std::size_t>((y + kHigh / 2 - 250) * kWide + x + kWide / 2 - 250)];
      differing += !(glm::length(a - middle.color[static_cast<std::size_t>(y * 500 + x)]) < 1e-4f);
    }
  }
  EXPECT_LE(differing, 10);
}

}  // namespace
}  // namespace isolume::test
