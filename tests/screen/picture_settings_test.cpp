// What must not change pictures lighted from the screen, and what cannot be drawn.
#include "screen/screen_pictures.h"

namespace isolume::test {
namespace {

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

TEST_F(ScreenPictures, ResolutionDoesNotMatter) {
  // The radius is a length of the world: the mean openness of a picture is that of one with four times the pixels.
  // Tolerance: a pixel row along each silhouette and edge, where the mean over fewer pixels is a coarser sum.
  const GlScene scene = makeRoom();
  for (const ScreenEstimator estimator : screenEstimators())
    EXPECT_NEAR(meanAmbient(draw(scene, roomCamera(), screenSettings(estimator, {120, 120}))),
                meanAmbient(draw(scene, roomCamera(), screenSettings(estimator, {240, 240}))), 0.01)
        << screenEstimatorName(estimator);
}

TEST_F(ScreenPictures, RollTurnsThePicture) {
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
    forRolledPixels(kSide, [&](std::size_t from, std::size_t to) {
      if (upright.depth[from] == rolled.depth[to]) return;  // both see nothing
      ASSERT_NEAR(upright.depth[from], rolled.depth[to], 1e-3);
      differences.add(upright.light[from].r - rolled.light[to].r);
    });
    EXPECT_LT(differences.rms(), 0.02) << screenEstimatorName(estimator);
  }
}

TEST_F(ScreenPictures, LayersAreThoseOfAnyPicture) {
  // Position, depth and normal have the bits that the march without the screen gives: the G-buffer is the same trace.
  const GlScene scene = makeSphere();
  const Camera camera = frameScene(scene);
  const Frame local = draw(scene, camera, layerSettings());
  RenderSettings settings = layerSettings();
  settings.screen = ScreenOcclusion{.radiusWorld = kRadius};
  const Frame screen = draw(scene, camera, settings);
  EXPECT_TRUE(sameBits(local.position, screen.position));
  EXPECT_TRUE(sameBits(local.normal, screen.normal));
  EXPECT_TRUE(sameBits(local.depth, screen.depth));
  ASSERT_EQ(screen.light.size(), screen.depth.size());
}

TEST_F(ScreenPictures, NothingIsLeftOfThePictureBefore) {
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
  EXPECT_TRUE(sameBits(first.color, again.color));
  EXPECT_TRUE(sameBits(first.light, again.light));
  EXPECT_TRUE(sameBits(first.normal, again.normal));
  EXPECT_TRUE(sameBits(plain.color, plainAgain.color));
}

TEST_F(ScreenPictures, SettingsThatCannotBeDrawn) {
  // A radius, a number of samples, a pattern, a thickness or a membership that makes no sense is a GpuError of one
  // line.
  const GlScene scene = makeSphere(16, 5);
  const auto expectError = [&](auto change, const char* text) {
    RenderSettings settings = screenSettings(ScreenEstimator::gpuSphere);
    change(*settings.screen);
    expectRefused(scene, settings, text);
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
