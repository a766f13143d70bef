// What the measures say of pictures that differ in a known way.
#include "src/compare/measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <glm/trigonometric.hpp>

#include "compare/pictures.h"
#include "sweep/parallel.h"

namespace isolume::test {
namespace {

constexpr glm::ivec2 kSize{37, 23};
constexpr std::size_t kPixels = 37 * 23;

TEST(Measures, IdenticalPicturesDifferByNothing) {
  // A picture against itself: every measure is exactly 0, similarity exactly 1, nothing is missed.
  const Image image = noisePicture(kSize, 1);
  const Comparison c = compare(image, image);
  ASSERT_EQ(c.measures.size(), 1u);
  const Measures& m = c.measures[0].measures;
  EXPECT_EQ(m.count, kPixels);
  for (const double value : {m.rmse, m.bias, m.mean, m.p95, m.max, c.pixels.miss()}) EXPECT_EQ(value, 0);
  EXPECT_EQ(c.ssim, 1.0);
}

TEST(Measures, ConstantOffsetIsBiasAndRmse) {
  // got = want + 1/16 in numbers that floats hold exactly: every measure is exactly 1/16, and -1/16 changes bias alone.
  const Image want = noisePicture(kSize, 2);
  for (const float offset : {0.0625f, -0.0625f}) {
    Image got = want;
    for (float& value : channelOf(got, "ambient.Y")) value += offset;
    const Measures m = compare(got, want).measures[0].measures;
    EXPECT_EQ(m.bias, offset);
    for (const double value : {m.rmse, m.mean, m.p95, m.max}) EXPECT_EQ(value, 0.0625);
    EXPECT_EQ(m.maxPixel, glm::ivec2(0, 0));
  }
}

TEST(Measures, OnePixelIsFound) {
  // One pixel changed by d among n: bias d / n, RMSE |d| / sqrt(n), 95th percentile 0, maximum |d| at that pixel.
  const Image want = noisePicture(kSize, 3);
  Image got = want;
  constexpr glm::ivec2 kPixel{5, 17};
  channelOf(got, "ambient.Y")[17 * 37 + 5] -= 0.5f;
  const Measures m = compare(got, want).measures[0].measures;
  EXPECT_EQ(m.bias, -0.5 / kPixels);
  EXPECT_EQ(m.mean, 0.5 / kPixels);
  EXPECT_DOUBLE_EQ(m.rmse, 0.5 / std::sqrt(double(kPixels)));
  EXPECT_EQ(m.p95, 0);
  EXPECT_EQ(m.max, 0.5);
  EXPECT_EQ(m.maxPixel, kPixel);
}

TEST(Measures, ShiftByOnePixelIsSeen) {
  // A ramp of 1/64 per pixel, shifted to the right by one: difference -1/64 everywhere but in the first column.
  Image want = picture({32, 8}, std::vector<float>(32 * 8));
  for (std::size_t i = 0; i < 32 * 8; ++i) channelOf(want, "ambient.Y")[i] = static_cast<float>(i % 32) / 64;
  Image got = want;
  for (std::size_t i = 0; i < 32 * 8; ++i)
    if (i % 32 > 0) channelOf(got, "ambient.Y")[i] = channelOf(want, "ambient.Y")[i - 1];
  const Measures m = compare(got, want).measures[0].measures;
  EXPECT_EQ(m.bias, -31.0 / 32 / 64);
  EXPECT_EQ(m.max, 1.0 / 64);
  EXPECT_EQ(m.maxPixel, glm::ivec2(1, 0));
  EXPECT_EQ(m.p95, 1.0 / 64);
}

TEST(Measures, PercentileIsNearestRank) {
  // For every count up to 120 and some percents: the element that a sort puts at rank ceil(p n / 100).
  for (int n = 1; n <= 120; ++n) {
    const std::vector<float> noise = dyadicNoise(static_cast<std::size_t>(n), 100u + static_cast<unsigned>(n));
    const Image zero = picture({n, 1}, std::vector<float>(noise.size()));
    const LayerPair pair = pairOf(picture({n, 1}, noise), zero);
    std::vector<double> sorted(noise.begin(), noise.end());
    std::sort(sorted.begin(), sorted.end());
    for (const int percent : {1, 50, 95, 99, 100}) {
      int rank = 1;  // the smallest with at least that share of the values at or below it
      while (100 * rank < percent * n) ++rank;
      EXPECT_EQ(magnitudePercentile(channelDifference(pair, pair.channels[0]), percent),
                sorted[static_cast<std::size_t>(rank - 1)])
          << n << " values, " << percent << " %";
    }
  }
}

TEST(Measures, ThreadsChangeNoBit) {
  // All measures and the similarity have the same bits with one thread and with four.
  const Image got = noisePicture({301, 207}, 4), want = noisePicture({301, 207}, 5);
  setThreadCount(1);
  const std::string one = comparisonJson(compare(got, want)).dump();
  setThreadCount(4);
  const std::string four = comparisonJson(compare(got, want)).dump();
  setThreadCount(0);
  EXPECT_EQ(one, four);
}

TEST(Measures, AngleBetweenNormalsInDegrees) {
  // Two normals apart by a known angle, of any lengths: that angle to 1e-5 degrees (floats), also where it is tiny.
  for (const double degrees : {0.0, 0.001, 1.0, 45.0, 90.0, 179.0}) {
    Image got = picture({1, 1}, {0}), want = got;
    const double radians = glm::radians(degrees);
    addVectors(got, "normal", {glm::vec3(2 * std::cos(radians), 2 * std::sin(radians), 0)});
    addVectors(want, "normal", {glm::vec3(1, 0, 0)});
    const Comparison c = compare(got, want, "normal");
    ASSERT_EQ(c.measures.size(), 4u);
    EXPECT_EQ(c.measures[0].name, "angle");
    EXPECT_EQ(c.measures[0].unit, "degrees");
    EXPECT_EQ(c.limitedMeasures, 1u);
    EXPECT_NEAR(c.measures[0].measures.max, degrees, 1e-5);
    EXPECT_EQ(c.measures[1].name, "normal.X");
    EXPECT_NEAR(c.measures[1].measures.bias, 2 * std::cos(radians) - 1, 1e-6);  // float32 near 1
  }
}

TEST(Measures, VectorsWithoutDirection) {
  // Zero vectors agree with each other; against one with a direction they are as wrong as can be, 180 degrees.
  Image got = picture({2, 1}, {0, 0}), want = got;
  addVectors(got, "bent", {{0, 0, 0}, {0, 0, 0}});
  addVectors(want, "bent", {{0, 0, 0}, {0, 1, 0}});
  const LayerPair pair = pairOf(got, want, "bent");
  EXPECT_EQ(vectorDifference(pair).values, (std::vector<double>{0, 180}));
}

TEST(Measures, PositionsDifferByTheirDistance) {
  // Positions: the first measure is the Euclidean distance in world units, here 3-4-12 to 13.
  Image got = picture({1, 1}, {0}), want = got;
  addVectors(got, "position", {{103, 4, -12}});
  addVectors(want, "position", {{100, 0, 0}});
  const Comparison c = compare(got, want, "position");
  EXPECT_EQ(c.measures[0].name, "distance");
  EXPECT_EQ(c.measures[0].measures.rmse, 13);
}

TEST(Measures, NoiseOfTheReferenceIsRemoved) {
  // Differences of 5/16 with standard errors of 3/16 and 4/16 in turn: noise sqrt(mean s^2), the rest by subtraction.
  Image got = picture({4, 1}, {0.3125f, 0.3125f, 0.3125f, 0.3125f}), want = picture({4, 1}, {0, 0, 0, 0});
  want.channels.push_back({"stderr.ambient.Y", {0.1875f, 0.25f, 0.1875f, 0.25f}});
  const Comparison c = compare(got, want);
  const double square = (0.1875 * 0.1875 + 0.25 * 0.25) / 2;
  ASSERT_TRUE(c.measures[0].noise && c.measures[0].rmseWithoutNoise);
  EXPECT_DOUBLE_EQ(*c.measures[0].noise, std::sqrt(square));
  EXPECT_DOUBLE_EQ(*c.measures[0].rmseWithoutNoise, std::sqrt(0.3125 * 0.3125 - square));
  channelOf(got, "ambient.Y").assign(4, 0.125f);  // less than the noise alone would give
  EXPECT_EQ(compare(got, want).measures[0].rmseWithoutNoise, 0.0);
  EXPECT_FALSE(compare(want, got).measures[0].noise);  // the standard error of GOT is not asked for
}

}  // namespace
}  // namespace isolume::test
