#include "io/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "sweep/parallel.h"

namespace isolume::test {
namespace {

Volume volumeOf(const std::vector<float>& values) {
  Volume volume;
  volume.values = Grid<float>({static_cast<int>(values.size()), 1, 1});
  std::copy(values.begin(), values.end(), volume.values.data());
  return volume;
}

TEST(Statistics, CountsRangeMeanAndHistogram) {
  // NaN and infinities are counted and left out of range, mean and histogram; the offset is added back.
  const float inf = std::numeric_limits<float>::infinity();
  Volume volume = volumeOf({0, 256, 64, NAN, inf, -inf, 128, NAN});
  volume.valueOffset = 1000;
  const VolumeStatistics s = computeStatistics(volume);
  EXPECT_EQ(s.count, 8u);
  EXPECT_EQ(s.nanCount, 2u);
  EXPECT_EQ(s.infCount, 2u);
  EXPECT_EQ(s.min, 1000);
  EXPECT_EQ(s.max, 1256);
  EXPECT_EQ(s.mean, 1112);
  EXPECT_EQ(s.histogram[0], 1u);
  EXPECT_EQ(s.histogram[64], 1u);
  EXPECT_EQ(s.histogram[128], 1u);
  EXPECT_EQ(s.histogram[255], 1u) << "the largest value belongs to the last bin";
  EXPECT_EQ(std::accumulate(s.histogram.begin(), s.histogram.end(), std::size_t{0}), 4u);
}

TEST(Statistics, NothingFinite) {
  // A volume of NaN alone has a range of 0 and an empty histogram, and a default isovalue that is finite.
  const Volume volume = volumeOf({NAN, NAN});
  const VolumeStatistics s = computeStatistics(volume);
  EXPECT_EQ(s.nanCount, 2u);
  EXPECT_EQ(std::accumulate(s.histogram.begin(), s.histogram.end(), std::size_t{0}), 0u);
  EXPECT_TRUE(std::isfinite(defaultIsovalue(volume, s).isovalue));
}

TEST(Statistics, SameBitsForAnyNumberOfThreads) {
  // Sums are formed over fixed chunks: one thread and three give the same mean, bit for bit.
  std::vector<float> values(1'500'000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(static_cast<float>(i)) * 1e3f;
  const Volume volume = volumeOf(values);
  setThreadCount(1);
  const VolumeStatistics one = computeStatistics(volume);
  setThreadCount(3);
  const VolumeStatistics three = computeStatistics(volume);
  setThreadCount(0);
  EXPECT_EQ(std::memcmp(&one.mean, &three.mean, sizeof(double)), 0);
  EXPECT_EQ(one.histogram, three.histogram);
}

TEST(Statistics, OtsuSeparatesTwoGroups) {
  // Two groups of values with a gap between them are cut in the middle of the gap, to one bin.
  std::vector<float> values;
  for (int i = 0; i < 1000; ++i) {
    values.push_back(static_cast<float>(i % 10));
    values.push_back(static_cast<float>(90 + i % 11));
  }
  const Volume volume = volumeOf(values);
  const IsovalueChoice choice = defaultIsovalue(volume, computeStatistics(volume));
  EXPECT_NEAR(choice.isovalue, 49.5, 100.0 / 256);
  EXPECT_NE(choice.reason.find("Otsu"), std::string::npos);
}

TEST(Statistics, KnownKindsHaveKnownIsovalues) {
  // A level set is drawn at 0 and a bool grid at 1/2, whatever the histogram is.
  Volume volume = volumeOf({-1, -1, -1, 5});
  volume.kind = GridKind::levelSet;
  EXPECT_EQ(defaultIsovalue(volume, computeStatistics(volume)).isovalue, 0);
  volume.kind = GridKind::unknown;
  volume.sampleType = "bool";
  EXPECT_EQ(defaultIsovalue(volume, computeStatistics(volume)).isovalue, 0.5);
}

}  // namespace
}  // namespace isolume::test
