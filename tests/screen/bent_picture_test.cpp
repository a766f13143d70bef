// Pictures lighted by bent normals and cones, on the GPU.
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "raymarch/screen/sky_convolution.h"
#include "screen/screen_pictures.h"

namespace isolume::test {
namespace {

const std::array kSources{BentSource::crytek2d, BentSource::crytek3d, BentSource::hbao};

RenderSettings bentSettings(BentSource source, BentLight light, std::shared_ptr<const SkyCube> sky) {
  RenderSettings settings = screenSettings(ScreenEstimator::klehm11, {160, 128});
  settings.screen->bentFrom = source;
  settings.screen->bent = light;
  settings.screen->sky = std::move(sky);
  return settings;
}

std::shared_ptr<const SkyCube> evenSky(glm::vec3 radiance) {
  auto sky = std::make_shared<SkyCube>();
  addEvenSky(*sky, radiance);
  return sky;
}

/// Radiance 1 + x, 1 + y and 1 + z of the direction along the grid's axes, of which a surface in the open receives
/// 1 + (2/3) N.
std::shared_ptr<const SkyCube> linearSky() {
  auto sky = std::make_shared<SkyCube>();
  const auto edge = static_cast<std::size_t>(sky->side);
  for (std::size_t i = 0; i < sky->radiance.size(); ++i) {
    const std::size_t texel = i % (edge * edge);
    sky->radiance[i] =
        glm::vec3(1) +
        glm::vec3(cubeDirection(sky->side, static_cast<int>(i / (edge * edge)),
                                {static_cast<double>(texel % edge) + 0.5, static_cast<double>(texel / edge) + 0.5}));
  }
  return sky;
}

/// Root mean square distance of a frame's light from 1 + (2/3) N along the grid's axes, on the solid.
double offLinearSky(const Frame& frame, const GlScene& scene) {
  const glm::dmat3 axesFromWorld = glm::transpose(glm::dmat3(scene.worldFromGrid));
  Differences differences;
  for (std::size_t i = 0; i < frame.light.size(); ++i)
    if (std::isfinite(frame.depth[i])) {
      const glm::dvec3 want = 1.0 + 2.0 / 3 * (axesFromWorld * glm::dvec3(frame.normal[i]));
      differences.add(glm::distance(glm::dvec3(frame.light[i]), want));
    }
  EXPECT_GT(differences.count, 2000);
  return differences.rms();
}
GlScene makeTurnedBall() {
  GlScene ball = makeSphere();
  ball.worldFromGrid = glm::rotate(glm::dmat4(1), 0.8, glm::normalize(glm::dvec3(1, -2, 0.5)));
  return ball;
}

using BentPictures = ScreenPictures;

TEST_F(BentPictures, EvenSkyIsOpenness) {
  // Under an even white sky, given or not, every lookup shows the openness alone: to rounding the picture without bent
  // normals, which without a sky it is to the last bit.
  const GlScene room = makeRoom();
  for (const BentSource source : kSources) {
    const Frame plain = draw(room, roomCamera(), bentSettings(source, BentLight::none, nullptr));
    for (const BentLight light : {BentLight::none, BentLight::normal, BentLight::cone, BentLight::cap}) {
      const Frame same = draw(room, roomCamera(), bentSettings(source, light, nullptr));
      EXPECT_TRUE(sameBits(plain.light, same.light));
      const Frame given = draw(room, roomCamera(), bentSettings(source, light, evenSky({1, 0.5f, 2})));
      for (std::size_t i = 0; i < plain.light.size(); ++i) {
        if (!std::isfinite(plain.depth[i])) continue;
        ASSERT_LT(glm::distance(given.light[i], plain.light[i].r * glm::vec3(1, 0.5f, 2)), 1e-3f)
            << bentSourceName(source) << bentLightName(light);
      }
    }
  }
}

TEST_F(BentPictures, ConvexSolidReceivesWhatItsNormalSays) {
  // A ball occludes nothing of itself: under a sky that is linear in the direction along the grid's axes each pixel has
  // 1 + (2/3) N, however the grid lies in the world. Tolerance: texels of 2.8 degrees, and the voxels of the ball.
  const GlScene ball = makeTurnedBall();
  for (const BentSource source : kSources)
    for (const BentLight light : {BentLight::none, BentLight::normal, BentLight::cone}) {
      RenderSettings settings = bentSettings(source, light, linearSky());
      settings.screen->radiusWorld = 3;
      EXPECT_LT(offLinearSky(draw(ball, frameScene(ball), settings), ball), 0.02)
          << bentSourceName(source) << bentLightName(light);
    }
}

TEST_F(BentPictures, SumsOverDirectionsReceiveTheSame) {
  // On the ball ssdo and importance sampling add up to 1 + (2/3) N as well, to three percent with 64 samples.
  const GlScene ball = makeTurnedBall();
  for (const ScreenEstimator estimator : {ScreenEstimator::ssdo, ScreenEstimator::envImportance}) {
    RenderSettings settings = bentSettings(BentSource::hbao, BentLight::none, linearSky());
    settings.screen->estimator = estimator;
    settings.screen->radiusWorld = 3;
    settings.screen->samples = 64;
    EXPECT_LT(offLinearSky(draw(ball, frameScene(ball), settings), ball), 0.03) << screenEstimatorName(estimator);
  }
}

/// Closed directions at the foot of a wall: see wallTruth() in bent_test.cpp; here of crytek-3d.
glm::dvec4 bendBeforeWall(double a) {
  constexpr int kPoints = 200;
  glm::dvec4 closed(0);
  for (int i = 0; i < kPoints && a < 1; ++i) {
    const double x = a + (1 - a) * (i + 0.5) / kPoints;
    closed += (1 - a) / kPoints / 2 * (1 - std::pow(a / x, 3)) *
              glm::dvec4(x, 0, 2 / std::numbers::pi * std::sqrt(1 - x * x), 1);
  }
  const double share = 1 - closed.w;
  return {-closed.x, 0, 0.5 - closed.z - share / 2, share};
}

TEST_F(BentPictures, FloorBeforeAWallLooksAway) {
  // On a floor before a wall light by the bent normal under a linear sky is share (1 + (2/3) N_b), N_b in closed form.
  const GlScene room = makeRoom();
  RenderSettings settings = bentSettings(BentSource::crytek3d, BentLight::normal, linearSky());
  settings.screen->samples = 64;
  const Frame frame = draw(room, roomCamera(), settings);
  Differences differences;
  double lean = 0;
  forFloorPixels(frame, [&](std::size_t i, double a) {
    const glm::dvec4 bend = bendBeforeWall(a);
    const glm::dvec3 mean = glm::normalize(glm::dvec3(bend) / bend.w + glm::dvec3(0, 0, 0.5));
    differences.add(glm::distance(glm::dvec3(frame.light[i]), bend.w * (1.0 + 2.0 / 3 * mean)));
    lean = std::min(lean, mean.x);
  });
  ASSERT_GT(differences.count, 1000);
  EXPECT_LT(lean, -0.3);
  EXPECT_LT(differences.rms(), 0.03);
}

TEST_F(BentPictures, FilterKeepsNormals) {
  // What is filtered is the difference to the normal: on a convex solid, where nothing bends, filtered and plain
  // pictures are the same to rounding under any sky.
  const GlScene ball = makeSphere();
  RenderSettings settings = bentSettings(BentSource::hbao, BentLight::normal, linearSky());
  settings.screen->radiusWorld = 3;
  const Frame filtered = draw(ball, frameScene(ball), settings);
  settings.screen->filter = false;
  const Frame plain = draw(ball, frameScene(ball), settings);
  int open = 0;
  for (std::size_t i = 0; i < plain.light.size(); ++i) {
    const bool convex =
        std::isfinite(plain.depth[i]) && glm::distance(plain.light[i], 1.0f + 2.0f / 3 * plain.normal[i]) < 2e-3f;
    if (!convex) continue;
    ASSERT_LT(glm::distance(filtered.light[i], plain.light[i]), 0.01f);
    ++open;
  }
  EXPECT_GT(open, 2000);
}

TEST_F(BentPictures, RollTurnsThePicture) {
  // A camera that rolls by a quarter turn gives the same light, turned, beyond the noise of the samples: two and a
  // half percent in each of three colours.
  const GlScene room = makeRoom();
  constexpr int kSide = 120;
  for (const BentSource source : kSources) {
    RenderSettings settings = bentSettings(source, BentLight::cap, linearSky());
    settings.size = {kSide, kSide};
    settings.screen->samples = 64;
    const Frame upright = draw(room, roomCamera(), settings), rolled = draw(room, roomCamera(90), settings);
    Differences differences;
    forRolledPixels(kSide, [&](std::size_t from, std::size_t to) {
      if (std::isfinite(upright.depth[from])) differences.add(glm::distance(upright.light[from], rolled.light[to]));
    });
    EXPECT_LT(differences.rms(), 0.025 * std::sqrt(3)) << bentSourceName(source);
  }
}

TEST_F(BentPictures, SkiesAndLookupsDoNotMix) {
  // Drawn again after other skies, other lookups and other estimators a picture has the same bits, and those show none
  // of its sky: under a green one nothing is red.
  const GlScene room = makeRoom();
  const RenderSettings settings = bentSettings(BentSource::crytek3d, BentLight::cone, linearSky());
  const Frame first = draw(room, roomCamera(), settings);
  const Frame green =
      draw(room, roomCamera(), bentSettings(BentSource::crytek3d, BentLight::normal, evenSky({0, 1, 0})));
  for (std::size_t i = 0; i < green.light.size(); ++i)
    if (std::isfinite(green.depth[i])) {
      ASSERT_EQ(green.light[i].r, 0);
    }
  draw(room, roomCamera(), bentSettings(BentSource::hbao, BentLight::cone, nullptr));
  const Frame again = draw(room, roomCamera(), settings);
  EXPECT_TRUE(sameBits(first.light, again.light));
}

TEST_F(BentPictures, SettingsThatCannotBeDrawn) {
  // Too many steps, a sky that no one reads, and sweeps that are not there are each a GpuError of one line.
  const GlScene room = makeSphere(16, 5);
  const auto expectError = [&](auto change, const char* text) {
    RenderSettings settings = bentSettings(BentSource::crytek3d, BentLight::cone, linearSky());
    change(*settings.screen);
    expectRefused(room, settings, text);
  };
  expectError([](ScreenOcclusion& s) { s.steps = 4; }, "0 to 3 steps, found 4");
  expectError([](ScreenOcclusion& s) { s.estimator = ScreenEstimator::gtao; },
              "a sky with an estimator that takes one");
  expectError([](ScreenOcclusion& s) { s.bentFrom = BentSource::sweep; }, "openness and three components swept");
}

}  // namespace
}  // namespace isolume::test
