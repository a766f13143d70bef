// The eight octants in 15 bits, as pictures store them.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "support/plain_light.h"
#include "support/simd_targets.h"
#include "support/test_levels.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/octants/fixed_light.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

using test::noiseLevel;

// Distances without structure, more open than not, some of them infinite.
Grid<float> noiseDistance(glm::ivec3 size, glm::dvec3 spacing) {
  Grid<float> distance = noiseLevel(size, spacing, 18);
  for (std::size_t i = 0; i < distance.count(); ++i) {
    float& value = distance.data()[i];
    value = (value + 0.4F) * static_cast<float>(spacing.x);
    if (i % 50 == 7) value = std::copysign(std::numeric_limits<float>::infinity(), value);
  }
  return distance;
}

// A ball, and a slab that ends at the last plane: open, solid and shadowed parts larger than any block, some of them
// infinitely far.
Grid<float> blockyDistance(glm::ivec3 size, glm::dvec3 spacing) {
  Grid<float> distance(size, spacing);
  const glm::dvec3 centre = glm::dvec3(size) * glm::dvec3(0.6, 0.45, 0.5);
  const double radius = 0.3 * size.y;
  std::size_t i = 0;
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x, ++i) {
        const double ball = glm::length(glm::dvec3(x, y, z) - centre) - radius;
        const double slab = std::max(0.85 * size.y - y, 0.2 * size.x - x);
        const double voxels = std::min(ball, slab);
        const double limited =
            std::abs(voxels) > 6 ? std::copysign(std::numeric_limits<double>::infinity(), voxels) : voxels;
        distance.data()[i] = static_cast<float>(limited * smallestSpacing(spacing));
      }
  return distance;
}

// Voxels whose bytes are not those of the plain loops.
int wrongBytes(GridView<const float> distance, float opacity) {
  const OctantVisibility swept = sweepVisibility(distance, VisibilityStorage::rgba8, opacity);
  int wrong = 0;
  for (std::size_t s = 0; s < kOctants.size(); ++s) {
    const std::vector<std::int16_t> plain = test::plainFixedLight(distance, kOctants[s].sweep, opacity);
    for (std::size_t i = 0; i < plain.size(); ++i)
      wrong += swept.packed[s / 4].data()[i][static_cast<int>(s % 4)] == std::lround(255 * plain[i] / 32768.0) ? 0 : 1;
  }
  return wrong;
}

TEST(FixedLight, HasTheBytesOfPlainLoopsOnEveryInstructionSet) {
  // The bytes are those of plain integer loops for any size, spacing and opacity, on every SIMD target.
  const int tried = test::onEverySimdTarget([] {
    for (const glm::ivec3& size :
         {glm::ivec3(1, 1, 1), glm::ivec3(40, 1, 3), glm::ivec3(1, 40, 2), glm::ivec3(3, 2, 40), glm::ivec3(32, 32, 4),
          glm::ivec3(53, 37, 21), glm::ivec3(70, 15, 9)})
      for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(0.3, 1.1, 0.7), glm::dvec3(1e-6, 2e-6, 1e-6)}) {
        const Grid<float> distance = noiseDistance(size, spacing);
        for (const float opacity : {1.0F, 0.35F})
          EXPECT_EQ(wrongBytes(distance.view(), opacity), 0) << size.x << "x" << size.y << "x" << size.z;
      }
  });
  EXPECT_GE(tried, 1);
}

// round(65535 sum_s share_s V_s) of plain loops, as what is missing of each octant's rounded share.
std::vector<std::uint16_t> plainMean(GridView<const float> distance, const OctantIntensities& intensities) {
  constexpr int kOne = 32768, kFull = 32767;
  const auto product = [](int a, int b) { return (a * b + kOne / 2) >> 15; };
  double sum = 0;
  for (const float intensity : intensities) sum += intensity;
  std::vector<int> missing(distance.count(), 0);
  int total = 0;
  for (std::size_t s = 0; s < kOctants.size(); ++s) {
    const auto rounded = std::lround(kOne * static_cast<float>(intensities[s] / sum));
    const int share = std::min(static_cast<int>(rounded), kFull);
    total += product(share, kFull);
    const std::vector<std::int16_t> light = test::plainFixedLight(distance, kOctants[s].sweep, 1);
    for (std::size_t i = 0; i < light.size(); ++i) missing[i] += product(light[i] - kFull, -share);
  }
  std::vector<std::uint16_t> mean;
  for (const int part : missing)
    mean.push_back(static_cast<std::uint16_t>(
        std::nearbyint(65535.0F / static_cast<float>(total) * static_cast<float>(total - part))));
  return mean;
}

TEST(FixedLight, HasTheBitsOfPlainLoopsWhereBlocksAreLeftOut) {
  // Bytes and means are those of plain integer loops too where most blocks are open, solid or dark and so passed over,
  // whatever the blocks' ends, on every SIMD target.
  const OctantIntensities uneven{0, 0.5F, 3, 1, 0, 2, 0.25F, 7};
  const int tried = test::onEverySimdTarget([&] {
    for (const glm::ivec3& size : {glm::ivec3(100, 97, 31), glm::ivec3(33, 64, 40), glm::ivec3(20, 130, 5)})
      for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(0.3, 1.1, 0.7), glm::dvec3(0.2, 3, 3)}) {
        const Grid<float> distance = blockyDistance(size, spacing);
        for (const float opacity : {1.0F, 0.35F})
          EXPECT_EQ(wrongBytes(distance.view(), opacity), 0) << size.x << "x" << size.y << "x" << size.z;
        const OctantVisibility swept = sweepVisibility(distance.view(), VisibilityStorage::combined, 1, uneven);
        const std::vector<std::uint16_t> plain = plainMean(distance.view(), uneven);
        EXPECT_TRUE(std::equal(plain.begin(), plain.end(), swept.combined.data())) << size.x;
      }
  });
  EXPECT_GE(tried, 1);
}

TEST(FixedLight, PassesFullAndDarkLightOnUnchanged) {
  // Eq. 6 in 15 bits gives the common value of three equal neighbours, full or dark, for all weights and every dither,
  // and clear voxels hand full light on: what lets a sweep pass over even blocks.
  const auto product = [](int a, int b) { return (a * b + (1 << 14)) >> 15; };
  for (int weight = 0; weight <= 32767; ++weight)
    for (const int dither : {-1, 0, 1}) {
      if (dither != 0 && weight >= 1 << 14) continue;  // left out there
      ASSERT_EQ(product(-weight, -dither), 0) << weight;
    }
  EXPECT_EQ(product(kFullLight, kClear), -kFullLight);
  EXPECT_EQ(product(0, kClear), 0);
}

TEST(FixedLight, KeepsOpenSpaceFullAndSolidDark) {
  // However far the light goes, open space is 255 and deep solid 0, exactly, whatever the weights.
  for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(7, 0.1, 2.2)}) {
    const glm::ivec3 n(150, 70, 60);
    Grid<float> open(n, spacing), solid(n, spacing);
    std::fill_n(open.data(), open.count(), 10.0F);
    std::fill_n(solid.data(), solid.count(), -10.0F);
    const OctantVisibility full = sweepVisibility(std::as_const(open).view(), VisibilityStorage::rgba8);
    const OctantVisibility dark = sweepVisibility(std::as_const(solid).view(), VisibilityStorage::rgba8);
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t i = 0; i < open.count(); ++i) ASSERT_EQ(full.packed[k].data()[i], glm::u8vec4(255));
    for (int k = 0; k < 2; ++k)
      EXPECT_EQ(dark.packed[static_cast<std::size_t>(k)].view()(n.x / 2, n.y / 2, n.z / 2), glm::u8vec4(0));
  }
}

TEST(FixedLight, StaysWithinAThousandthOfTheFloatOctants) {
  // Bytes are the float octants rounded, but for what 15 bits lose on the way: nowhere a thousandth beside the half
  // step, behind balls whose shadows cross the grid and in noise alike.
  constexpr double kLoss = 1e-3;
  std::vector<Grid<float>> distances;
  distances.push_back(noiseDistance({90, 80, 70}, {1, 1.5, 0.8}));
  distances.push_back(
      sweepOcclusion(test::ballLevel(150, 20, glm::dvec3(31, 35, 38)).view(), {.visibility = VisibilityStorage::none})
          .distance);
  for (const Grid<float>& distance : distances) {
    const OctantVisibility exact = sweepVisibility(distance.view(), VisibilityStorage::float32);
    const OctantVisibility bytes = sweepVisibility(distance.view(), VisibilityStorage::rgba8);
    double largest = 0;
    for (std::size_t s = 0; s < kOctants.size(); ++s)
      for (std::size_t i = 0; i < distance.count(); ++i) {
        const double stored = bytes.packed[s / 4].data()[i][static_cast<int>(s % 4)] / 255.0;
        largest = std::max(largest, std::abs(stored - exact.octants[s].data()[i]));
      }
    EXPECT_LT(largest, 0.5 / 255 + kLoss);
  }
}

TEST(FixedLight, ThreadsDoNotChangeABit) {
  // One, two, five and twelve threads, which take one, two and six layers at a time, give the same bytes and means, of
  // noise and of even blocks.
  const OctantIntensities uneven{0, 0.5F, 3, 1, 0, 2, 0.25F, 7};
  const Grid<float> noise = noiseDistance({70, 43, 57}, glm::dvec3(1)),
                    blocks = blockyDistance({70, 83, 57}, glm::dvec3(1));
  for (const Grid<float>* grid : {&noise, &blocks}) {
    const Grid<float>& distance = *grid;
    std::vector<OctantVisibility> bytes, means;
    for (const int threads : {1, 2, 5, 12}) {
      setThreadCount(threads);
      bytes.push_back(sweepVisibility(distance.view(), VisibilityStorage::rgba8));
      means.push_back(sweepVisibility(distance.view(), VisibilityStorage::combined, 1, uneven));
    }
    setThreadCount(0);
    for (std::size_t i = 1; i < bytes.size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_EQ(std::memcmp(bytes[i].packed[k].data(), bytes[0].packed[k].data(), 4 * distance.count()), 0);
      EXPECT_EQ(std::memcmp(means[i].combined.data(), means[0].combined.data(), 2 * distance.count()), 0);
    }
  }
}

}  // namespace
}  // namespace isolume
