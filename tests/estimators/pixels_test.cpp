// Whole pictures: which rays, which pixels, and that nothing depends on how the work is cut up.
#include <gtest/gtest.h>

#include <cstring>

#include "estimators/closed_form.h"
#include "sweep/parallel.h"

namespace isolume::test {
namespace {

/// A ball on a floor, seen from above by parallel rays straight down, one pixel per sample.
struct Picture {
  const TestScene scene{{33, 33, 25}, glm::dvec3(1), [](glm::dvec3 p) {
                          return std::max(floorLevel(p, 2), 6 - glm::length(p - glm::dvec3(16, 16, 12)));
                        }};
  PixelRays rays;

  Picture() {
    rays.size = {40, 33};
    rays.origin = {16, 16, 100};
    rays.originX = {1, 0, 0};
    rays.originY = {0, -1, 0};
    rays.direction = {0, 0, -1};
  }
  std::vector<ReferencePixel> trace(glm::ivec2 begin, glm::ivec2 end, const SamplingSettings& sampling = {.rays = 64},
                                    const IntegrandSettings& settings = {}) const {
    return traceReference(scene.scene(), rays, {begin, end}, settings, sampling);
  }
};

bool sameEstimate(const ReferencePixel& a, const ReferencePixel& b) {
  return a.hit == b.hit && a.point.hit.position == b.point.hit.position && a.point.normal == b.point.normal &&
         a.estimate.channels.value == b.estimate.channels.value &&
         a.estimate.channels.standardError == b.estimate.channels.standardError && a.estimate.rays == b.estimate.rays;
}

TEST(Pixels, RaysGoThroughPixelCentres) {
  // The middle of a row of 40 lies between its pixels 19 and 20, the middle of 33 rows in pixel 16: pixel (20, 16)
  // looks straight down at x = 16.5, y = 16 and meets the ball's top; the pixels beyond the box see nothing.
  const Picture picture;
  const std::vector<ReferencePixel> all = picture.trace({0, 0}, {40, 33});
  const ReferencePixel& middle = all[16 * 40 + 20];
  ASSERT_TRUE(middle.hit);
  EXPECT_EQ(middle.point.hit.position.x, 16.5);
  EXPECT_EQ(middle.point.hit.position.y, 16);
  EXPECT_NEAR(middle.point.hit.position.z, 12 + std::sqrt(36 - 0.25), 1 / 24.0);  // the interpolant's: 1 / (4 r)
  EXPECT_GT(middle.point.normal.x, 0);
  EXPECT_FALSE(all[0].hit);  // x = -3.5
  EXPECT_TRUE(all[4].hit);   // x = 0.5, y = 32
  EXPECT_EQ(all[4].point.hit.position.y, 32);
  EXPECT_EQ(all[4].point.hit.position.z, 2);
}

TEST(Pixels, ThreadsAndRectanglesChangeNoBit) {
  // One thread and two, the whole picture and a part of it, give the same bits for every pixel, also where each pixel
  // decides for itself how many rays it takes.
  const Picture picture;
  for (const SamplingSettings& sampling :
       {SamplingSettings{.rays = 64}, SamplingSettings{.targetError = 0.02, .maxRays = 1024}}) {
    setThreadCount(1);
    const std::vector<ReferencePixel> one = picture.trace({0, 0}, {40, 33}, sampling);
    setThreadCount(2);
    const std::vector<ReferencePixel> two = picture.trace({0, 0}, {40, 33}, sampling);
    const std::vector<ReferencePixel> part = picture.trace({7, 11}, {30, 20}, sampling);
    setThreadCount(0);
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_TRUE(sameEstimate(one[i], two[i])) << i;
    for (int y = 11; y < 20; ++y)
      for (int x = 7; x < 30; ++x)
        EXPECT_TRUE(sameEstimate(part[(y - 11) * 23 + (x - 7)], one[y * 40 + x])) << x << " " << y;
  }
}

TEST(Pixels, SeedsGiveOtherNoise) {
  // Another seed changes the estimate of a half-open point, and no point's hit.
  const Picture picture;
  const std::vector<ReferencePixel> a = picture.trace({0, 16}, {40, 17}, {.rays = 64, .seed = 0});
  const std::vector<ReferencePixel> b = picture.trace({0, 16}, {40, 17}, {.rays = 64, .seed = 1});
  int different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].point.hit.position, b[i].point.hit.position);
    if (a[i].estimate.channels.value != b[i].estimate.channels.value) ++different;
  }
  EXPECT_GT(different, 10);
}

TEST(Pixels, TargetIsReachedOrReported) {
  // With a target every pixel ends at or below it, or at the cap and says so; the cap is never exceeded, and no pixel
  // stops before 1 / target rays.
  const Picture picture;
  constexpr double kTarget = 0.01;
  constexpr int kCap = 400;  // not a power of two times the start
  const std::vector<ReferencePixel> pixels = picture.trace({0, 0}, {40, 33}, {.targetError = kTarget, .maxRays = kCap});
  int early = 0, late = 0;
  for (const ReferencePixel& pixel : pixels) {
    if (!pixel.hit) continue;
    const PointEstimate& estimate = pixel.estimate;
    EXPECT_GE(estimate.rays, 1 / kTarget);
    EXPECT_LE(estimate.rays, kCap);
    if (estimate.converged) {
      EXPECT_LE(estimate.channels.standardError[0], kTarget);
      ++early;
    } else {
      EXPECT_EQ(estimate.rays, kCap);
      ++late;
    }
  }
  EXPECT_GT(early, 100);
  EXPECT_GT(late, 10);
}

TEST(Pixels, NormalsAreThoseAskedFor) {
  // `data` is the tracer's smooth gradient, `exact` that of the cell, both turned out of the solid and in physical
  // axes; on a cap both are the face's.
  const glm::dvec3 spacing(1, 1, 2);
  const TestScene ball({21, 21, 11}, spacing, [](glm::dvec3 p) { return 7 - glm::length(p - glm::dvec3(10, 10, 10)); });
  const auto hit = ball.tracer.firstHit({{12.3, 11.1, 30}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  const glm::dvec3 viewer(0, 0, 1);
  const glm::dvec3 smooth = shadingNormal(ball.tracer, *hit, ReferenceNormals::data, viewer);
  const glm::dvec3 exact = shadingNormal(ball.tracer, *hit, ReferenceNormals::exact, viewer);
  const glm::dvec3 radial = glm::normalize(hit->position * spacing - glm::dvec3(10, 10, 10));
  // Differences over two samples along z, 4 units of a sphere of radius 7: 5 degrees; the cell's own: 10.
  EXPECT_GT(glm::dot(smooth, radial), std::cos(5 * kPi / 180));
  EXPECT_GT(glm::dot(exact, radial), std::cos(10 * kPi / 180));
  EXPECT_NE(smooth, exact);
  const SurfacePoint cap{0, {3.5, 4, 10}, 2};
  EXPECT_EQ(shadingNormal(ball.tracer, cap, ReferenceNormals::exact, viewer), glm::dvec3(0, 0, 1));
  EXPECT_EQ(shadingNormal(ball.tracer, {0, {3.5, 0, 5}, 1}, ReferenceNormals::data, viewer), glm::dvec3(0, -1, 0));
}

TEST(Pixels, FlatSpotLooksAtTheViewer) {
  // Where the level has no gradient at all the normal is the direction to the viewer, as in the renderer.
  const TestScene flat(glm::ivec3(5), glm::dvec3(1), [](glm::dvec3) { return -1; });
  const glm::dvec3 viewer = glm::normalize(glm::dvec3(1, 2, 3));
  EXPECT_EQ(shadingNormal(flat.tracer, {0, {2, 2, 2}, -1}, ReferenceNormals::data, viewer), viewer);
}

}  // namespace
}  // namespace isolume::test
