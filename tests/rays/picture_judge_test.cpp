// Pictures of the renderer, judged ray by ray from awkward cameras.
#include "bench/rays/picture_judge.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "bench/rays/random_views.h"
#include "raymarch/context.h"
#include "src/jobs/reference_camera.h"
#include "support/test_levels.h"
#include "sweep/level.h"
#include "volumes/scenes.h"

namespace isolume::test {
namespace {

using namespace isolume::bench;

struct Rendered {
  Grid<float> level;
  ViewedBox box;
  glm::dmat4 matrix{1};
  std::unique_ptr<Context> context = makeContext("osmesa");
  Renderer renderer{*context};

  Rendered(Grid<float> data) : level(std::move(data)) {
    const GridView<const float> view = level.view();
    box.high = glm::dvec3(view.size - 1) * view.spacing;
    box.solidHigh = box.high;
    for (int axis = 0; axis < 3; ++axis) matrix[axis][axis] = view.spacing[axis];
    SceneFields fields;
    fields.worldFromGrid = matrix;
    fields.level = view;
    renderer.upload(fields);
  }
  RayCounts judged(const RayJudge& judge, int views) {
    RenderSettings settings{.size = kViewSize, .shading = Shading::local};
    settings.layers = true;
    RayCounts counts;
    for (int number = 0; number < views; ++number) {
      const Camera camera = randomView(box, static_cast<std::uint64_t>(number));
      counts.add(
          judgePicture(judge, renderer.render(camera, settings), pixelRays(camera, kViewSize, makeGridFrame(matrix))));
    }
    return counts;
  }
};

Grid<float> sceneLevel(const char* name, int size) {
  const Grid<float> sampled = sampleScene(*findScene(name), size);
  Grid<float> level(sampled.size());
  std::copy_n(sampled.data(), sampled.count(), level.data());
  makeLevel(level.view(), 0, Inside::below);
  return level;
}

void expectRight(RayCounts& counts) {
  for (const std::string& line : counts.wrong) ADD_FAILURE() << line;
  EXPECT_EQ(counts.missed, 0);
  EXPECT_EQ(counts.falseHits, 0);
  EXPECT_GT(counts.hits, counts.rays / 20);
  // A silhouette is hit within rounding by one ray in some 1e4.
  EXPECT_LT(counts.ties + counts.grazing, counts.rays / 1000);
  // Of the hits that are off by more, the ray runs along the surface; across it they are as near as the rest. Both
  // numbers are what the product promises.
  EXPECT_LT(quantile(counts.distance, 0.999), kSamePlace);
  EXPECT_LT(quantile(counts.across, 1), kSamePlace);
  EXPECT_LT(quantile(counts.normal, 1), kNormalTarget);
}

TEST(PictureJudge, EveryRayOfEveryKindOfViewIsRight) {
  // From all kinds of views, on a scene of thin tubes and on noise with voxels of three lengths, no ray is wrong.
  Rendered tubes(sceneLevel("capillaries", 64));
  const RayJudge judgeTubes(tubes.level.view());
  RayCounts counts = tubes.judged(judgeTubes, kViewKinds);
  expectRight(counts);
  Grid<float> noise = noiseLevel({23, 31, 17}, {1, 1.25, 2}, 3);
  for (std::size_t i = 0; i < noise.count(); ++i) noise.data()[i] -= 0.5F;
  Rendered rough(std::move(noise));
  const RayJudge judgeRough(rough.level.view());
  RayCounts roughCounts = rough.judged(judgeRough, kViewKinds);
  expectRight(roughCounts);
}

TEST(PictureJudge, SeesASurfaceThatIsElsewhere) {
  // Judged by a surface a hundredth of a voxel inside of what was drawn, nearly every hit from outside is wrong.
  const auto ball = [](double radius) { return ballLevel(32, radius, {15.6, 15.1, 15.4}); };
  Rendered drawn(ball(10.31));
  const Grid<float> other = ball(10.30);
  const RayJudge judge(other.view());
  const RayCounts counts = drawn.judged(judge, 2);
  EXPECT_GT(counts.falseHits, counts.hits * 9 / 10);
  EXPECT_FALSE(counts.wrong.empty());
}

TEST(PictureJudge, ViewsAreTheSameEveryTimeAndSeeTheGrid) {
  // A view depends on its number alone, and of each kind some rays meet the box.
  const ViewedBox box{{40, 50, 60}, {5, 6, 7}, {30, 40, 50}};
  for (std::uint64_t number = 0; number < 3 * kViewKinds; ++number) {
    const Camera camera = randomView(box, number), again = randomView(box, number);
    EXPECT_EQ(camera.eye, again.eye);
    EXPECT_EQ(camera.target, again.target);
    const PixelRays rays = pixelRays(camera, kViewSize, makeGridFrame(glm::dmat4(1)));
    const GridRay centre = pixelRay(rays, kViewSize / 2, glm::dvec3(1));
    EXPECT_NEAR(glm::length(centre.direction), 1, 1e-12);
    const glm::dvec3 toTarget = camera.target - centre.origin;
    // The centre of the picture looks at the target, to the half pixel that the centre of a pixel is off.
    const double reach = glm::dot(toTarget, centre.direction);
    EXPECT_GT(reach, 0);
    EXPECT_LT(glm::length(toTarget - reach * centre.direction), 0.01 * reach + 1)
        << viewKindName(static_cast<int>(number % kViewKinds));
  }
}

TEST(PictureJudge, QuantilesAreOfTheSortedValues) {
  // The share 1/2 of 0 to 9 is 5, the share 1 the largest; of nothing it is 0.
  std::vector<float> values{9, 3, 7, 1, 5, 0, 2, 8, 4, 6}, none;
  EXPECT_EQ(quantile(values, 0.5), 5);
  EXPECT_EQ(quantile(values, 1), 9);
  EXPECT_EQ(quantile(none, 0.5), 0);
}

}  // namespace
}  // namespace isolume::test
