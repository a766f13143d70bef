// Pictures whose light comes from the screen, on the GPU, against closed forms.
#include <glm/geometric.hpp>
#include <numbers>

#include "screen/screen_pictures.h"
#include "volumes/scene_families.h"

namespace isolume::test {
namespace {

TEST_F(ScreenPictures, ConvexSolidIsOpen) {
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

template <class Truth>
Differences floorDifferences(const Frame& frame, Truth truth) {
  Differences differences;
  forFloorPixels(frame, [&](std::size_t i, double a) { differences.add(frame.light[i].r - truth(a)); });
  return differences;
}

double volumetricTruth(double a) {
  const double h = std::max(0.0, 0.5 - a);  // of the cap that the wall cuts from the tangent sphere
  return 1 - 2 * h * h * (1.5 - h);
}

TEST_F(ScreenPictures, FloorBeforeAWall) {
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

TEST_F(ScreenPictures, AreasBeforeAWall) {
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

TEST_F(ScreenPictures, GtaoBeforeAWall) {
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

TEST_F(ScreenPictures, UnderACeiling) {
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

TEST_F(ScreenPictures, CharacteristicFunctionsAgreeOnTerrain) {
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

}  // namespace
}  // namespace isolume::test
