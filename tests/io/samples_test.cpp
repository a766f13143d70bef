// The offset rule of samples.h, seen through files.
#include "io/samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/volume.h"
#include "sample_bytes.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

template <class T>
Volume readStored(const std::vector<T>& stored, const std::string& type) {
  TempFolder folder;
  return readVolume(folder.write("v_2x2x2_" + type + ".raw", bytesOf(stored)));
}

TEST(Samples, AnOffsetKeepsTheVariationOfLargeIntegers) {
  // Integers of which float32 would merge neighbours come back exactly, as value plus offset.
  std::vector<std::uint32_t> stored;
  for (std::uint32_t i = 0; i < 8; ++i) stored.push_back(4'000'000'000u + i);
  const Volume volume = readStored(stored, "uint32");
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(static_cast<double>(volume.values.data()[i]) + volume.valueOffset, stored[i]);
  EXPECT_THAT(volume.notes, testing::Contains(testing::HasSubstr("differences from")));
  EXPECT_THAT(volume.notes, testing::Not(testing::Contains(testing::HasSubstr("rounded"))));
}

TEST(Samples, NoOffsetWhereFloat32HoldsEverySample) {
  // Integers up to 2^24 are exact in float32, so neither an offset nor a note is due.
  const std::vector<std::int32_t> stored{16'777'210, 16'777'211, 16'777'212, 16'777'213,
                                         16'777'214, 16'777'215, 16'777'216, 16'777'209};
  const Volume volume = readStored(stored, "int32");
  EXPECT_EQ(volume.valueOffset, 0);
  EXPECT_THAT(volume.notes, testing::Not(testing::Contains(testing::HasSubstr("rounded"))));
  EXPECT_EQ(volume.values.data()[0], 16'777'210.f);
}

TEST(Samples, NoOffsetWhereTheRangeIsWide) {
  // float64 around 0 is rounded to float32 without an offset, and a note says so.
  const Volume volume = readStored(std::vector<double>{-0.1, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}, "float64");
  EXPECT_EQ(volume.valueOffset, 0);
  EXPECT_EQ(volume.values.data()[1], 0.1f);
  EXPECT_THAT(volume.notes, testing::Contains(testing::HasSubstr("float64 samples are rounded to float32")));
}

TEST(Samples, AnOffsetKeepsTheVariationOfFloat64) {
  // A pressure of 101325 Pa with variations of 1e-3 keeps them to the precision of float32 differences.
  std::vector<double> stored;
  for (int i = 0; i < 8; ++i) stored.push_back(101325.0 + 1e-3 * i);
  const Volume volume = readStored(stored, "float64");
  // Differences up to 3.5e-3 rounded to 24 bits: within 3.5e-3 / 2^24 = 2.1e-10.
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(static_cast<double>(volume.values.data()[i]) + volume.valueOffset, stored[i], 2.1e-10);
}

TEST(Samples, NotFiniteStaysNotFinite) {
  // NaN and infinities are kept, do not move the offset, and what float32 cannot hold becomes infinite with a note.
  const double inf = std::numeric_limits<double>::infinity();
  const Volume volume = readStored(std::vector<double>{std::nan(""), inf, -inf, 1e300, -1e300, 1, 2, 3}, "float64");
  EXPECT_TRUE(std::isnan(volume.values.data()[0]));
  EXPECT_EQ(volume.values.data()[1], std::numeric_limits<float>::infinity());
  EXPECT_EQ(volume.values.data()[2], -std::numeric_limits<float>::infinity());
  EXPECT_EQ(volume.values.data()[3], std::numeric_limits<float>::infinity());
  EXPECT_EQ(volume.values.data()[5], 1);
  EXPECT_EQ(volume.valueOffset, 0);
  EXPECT_THAT(volume.notes, testing::Contains(testing::HasSubstr("2 float64 samples are beyond")));
}

TEST(Samples, ConstantValuesNeedNoOffset) {
  // A constant float64 volume has no variation to lose.
  const Volume volume = readStored(std::vector<double>(8, 1234567.89), "float64");
  EXPECT_EQ(volume.valueOffset, 0);
}

TEST(Samples, Wide64BitIntegersKeepTheirDifferences) {
  // 64-bit integers beyond the 53 bits of a double still differ by what they differ.
  WideRange seen;
  const std::int64_t base = (std::int64_t{1} << 62) + 1024;
  const auto offset = static_cast<double>(base);
  EXPECT_EQ(narrowSample(base + 3, offset, seen) - narrowSample(base + 1, offset, seen), 2);
}

}  // namespace
}  // namespace isolume::test
