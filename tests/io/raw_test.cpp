#include "io/raw.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "errors.h"
#include "io/volume.h"
#include "sample_bytes.h"
#include "sweep/parallel.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

using testing::ElementsAreArray;
using testing::HasSubstr;

std::vector<float> samplesOf(const Volume& volume) {
  return {volume.values.data(), volume.values.data() + volume.values.count()};
}

template <class T>
class RawTypes : public testing::Test {};
struct U8 {
  using T = std::uint8_t;
  static constexpr const char* kName = "uint8";
};
struct I8 {
  using T = std::int8_t;
  static constexpr const char* kName = "int8";
};
struct U16 {
  using T = std::uint16_t;
  static constexpr const char* kName = "uint16";
};
struct I16 {
  using T = std::int16_t;
  static constexpr const char* kName = "int16";
};
struct U32 {
  using T = std::uint32_t;
  static constexpr const char* kName = "uint32";
};
struct I32 {
  using T = std::int32_t;
  static constexpr const char* kName = "int32";
};
struct F32 {
  using T = float;
  static constexpr const char* kName = "float32";
};
struct F64 {
  using T = double;
  static constexpr const char* kName = "float64";
};
using AllTypes = testing::Types<U8, I8, U16, I16, U32, I32, F32, F64>;
TYPED_TEST_SUITE(RawTypes, AllTypes);

TYPED_TEST(RawTypes, ReadsBothByteOrdersAndAnyOffset) {
  // Every type comes back exactly, in either byte order, behind a header of any length, aligned or not.
  using T = typename TypeParam::T;
  std::vector<T> stored;
  std::vector<float> expected;
  for (int i = 0; i < 24; ++i) {
    stored.push_back(static_cast<T>(i % 2 == 0 || !std::numeric_limits<T>::is_signed ? 5 * i : -5 * i));
    expected.push_back(static_cast<float>(stored.back()));
  }
  TempFolder folder;
  for (const bool bigEndian : {false, true})
    for (const std::size_t offset : {0, 1, 7}) {
      const std::string path =
          folder.write(std::string("v_2x3x4_") + TypeParam::kName + (bigEndian ? "_be.raw" : ".raw"),
                       std::string(offset, 'h') + bytesOf(stored, bigEndian));
      ReadOptions options;
      if (offset > 0) options.raw.offset = offset;
      const Volume volume = readVolume(path, options);
      EXPECT_EQ(volume.values.size(), glm::ivec3(2, 3, 4));
      EXPECT_THAT(samplesOf(volume), ElementsAreArray(expected));
      EXPECT_EQ(volume.sampleType, TypeParam::kName);
      EXPECT_EQ(volume.format, "raw");
      EXPECT_EQ(volume.worldFromGrid, glm::dmat4(1));
      EXPECT_EQ(volume.valueOffset, 0);
      EXPECT_THAT(volume.files, testing::ElementsAre(path));
    }
}

TEST(Raw, XVariesFastest) {
  // Sample (i, j, k) is the (i + nx (j + ny k))-th of the file.
  TempFolder folder;
  std::vector<std::uint8_t> stored(24);
  for (std::size_t i = 0; i < stored.size(); ++i) stored[i] = static_cast<std::uint8_t>(i);
  const Volume volume = readVolume(folder.write("v_2x3x4_uint8.raw", bytesOf(stored)));
  EXPECT_EQ(volume.values.view()(1, 0, 0), 1);
  EXPECT_EQ(volume.values.view()(0, 1, 0), 2);
  EXPECT_EQ(volume.values.view()(0, 0, 1), 6);
}

TEST(Raw, OptionsWinOverTheName) {
  // What the user says about size, type, byte order and place holds, whatever the name says, and a note tells so.
  TempFolder folder;
  const std::string path = folder.write("v_9x9x9_uint8_be.raw", bytesOf<std::int16_t>({1, 2, 3, 4, 5, 6, 7, 8}));
  ReadOptions options;
  options.raw.dims = glm::ivec3(2);
  options.raw.type = "int16";
  options.raw.bigEndian = false;
  options.raw.spacing = glm::dvec3(0.5, 1, 2);
  options.raw.origin = glm::dvec3(-1, 0, 10);
  const Volume volume = readVolume(path, options);
  EXPECT_THAT(samplesOf(volume), testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_EQ(volume.values.view().spacing, glm::dvec3(0.5, 1, 2));
  EXPECT_EQ(volume.values.view().origin, glm::dvec3(-1, 0, 10));
  EXPECT_EQ(volume.worldFromGrid[3], glm::dvec4(-1, 0, 10, 1));
  EXPECT_THAT(volume.notes, testing::Contains(HasSubstr("9x9x9")));
}

TEST(Raw, OptionsFillWhatTheNameLeavesOpen) {
  // Each of size, type and byte order may come from either place, for any ending once options make the file raw.
  TempFolder folder;
  ReadOptions options;
  options.raw.type = "int16";
  const Volume volume =
      readVolume(folder.write("v_2x2x2_int16_be.dat", bytesOf<std::int16_t>({1, 2, 3, 4, 5, 6, 7, 8}, true)), options);
  EXPECT_EQ(samplesOf(volume).front(), 1);
  ReadOptions all;
  all.raw.dims = glm::ivec3(2);
  all.raw.type = "uint8";
  EXPECT_EQ(samplesOf(readVolume(folder.write("noending", "abcdefgh"), all)).front(), 'a');
}

TEST(Raw, ManyChunksAgreeForAnyNumberOfThreads) {
  // A volume of several chunks has the same bits for one thread and for three.
  TempFolder folder;
  std::vector<double> stored(std::size_t{130} * 130 * 70);
  for (std::size_t i = 0; i < stored.size(); ++i) stored[i] = 1e9 + 1e-3 * static_cast<double>(i);
  const std::string path = folder.write("v_130x130x70_float64.raw", bytesOf(stored));
  setThreadCount(1);
  const Volume one = readVolume(path);
  setThreadCount(3);
  const Volume three = readVolume(path);
  setThreadCount(0);
  EXPECT_EQ(one.valueOffset, three.valueOffset);
  EXPECT_EQ(samplesOf(one), samplesOf(three));
  EXPECT_NEAR(one.values.data()[stored.size() - 1] + one.valueOffset, stored.back(), 1e-4);
}

TEST(Raw, HintsAtTheWrongByteOrder) {
  // Smooth samples in the other byte order get a note that says so, in the right one and as noise they get none.
  TempFolder folder;
  std::vector<std::int16_t> smooth, noise;
  std::vector<float> waves;
  unsigned state = 1;
  for (int i = 0; i < 4096; ++i) {
    smooth.push_back(static_cast<std::int16_t>(1000 * std::sin(i * 0.01)));
    waves.push_back(static_cast<float>(300 + 20 * std::sin(i * 0.01)));
    state = state * 1664525u + 1013904223u;
    noise.push_back(static_cast<std::int16_t>(state >> 16));
  }
  const auto notes = [&](const std::string& type, const std::string& bytes) {
    std::string all;
    for (const auto& note : readVolume(folder.write("v_16x16x16_" + type + ".raw", bytes)).notes) all += note + "\n";
    return all;
  };
  EXPECT_THAT(notes("int16", bytesOf(smooth, true)), HasSubstr("--endian big"));
  EXPECT_THAT(notes("int16_be", bytesOf(smooth)), HasSubstr("--endian little"));
  EXPECT_THAT(notes("float32", bytesOf(waves, true)), HasSubstr("--endian big"));
  EXPECT_THAT(notes("int16", bytesOf(smooth)), testing::Not(HasSubstr("--endian")));
  EXPECT_THAT(notes("float32", bytesOf(waves)), testing::Not(HasSubstr("--endian")));
  EXPECT_THAT(notes("int16", bytesOf(noise)), testing::Not(HasSubstr("--endian")));
}

struct BadRaw {
  std::string name;
  std::size_t bytes;
  RawLayout layout;
  std::vector<std::string> message;
};

TEST(Raw, SaysWhatIsMissingOrWrong) {
  // Every incomplete, contradictory or unfitting description is one line naming the file, expected and found.
  const auto with = [](auto set) {
    RawLayout layout;
    set(layout);
    return layout;
  };
  const std::vector<BadRaw> cases{
      {"a.raw", 8, {}, {"dimensions unknown", "--dims", "skull_256x256x108_int16.raw"}},
      {"a_2x2x2.raw", 8, {}, {"type unknown", "--type"}},
      {"a_uint8.raw", 8, {}, {"dimensions unknown"}},
      {"a_2x2x2_uint8.raw", 7, {}, {"expected 8 bytes (2x2x2 uint8), found 7"}},
      {"a_2x2x2_uint8.raw", 9, {}, {"expected 8 bytes", "found 9", "an offset of 1 would fit"}},
      {"a_2x2x2_uint8.raw", 16, {}, {"found 16", "2 bytes per sample would fit"}},
      {"a_2x2x2_uint8.raw", 8, with([](RawLayout& l) { l.offset = 4; }), {"expected 12 bytes", "after 4 bytes"}},
      {"a_2x2x2_uint8.raw", 8, with([](RawLayout& l) { l.offset = ~std::size_t{0}; }), {"64 bits"}},
      {"a_2x2x2_3x3x3_uint8.raw", 8, {}, {"found two"}},
      {"a_2x2x2_uint8_int16.raw", 8, {}, {"found two"}},
      {"a_0x2x2_uint8.raw", 8, {}, {"dimensions above 0", "0x2x2"}},
      {"a_4294967296x4294967296x4294967296_uint8.raw", 8, {}, {"64 bits"}},
      {"a_99999999999999999999x2x2_uint8.raw", 8, {}, {"dimensions unknown"}},
      {"a_1x2x4_uint8.raw", 8, {}, {"at least 2 samples"}},
      {"a_2x2x2_uint8.raw", 8, with([](RawLayout& l) { l.dims = glm::ivec3(-2, 2, 2); }), {"-2x2x2"}},
      {"a_2x2x2_uint8.raw", 8, with([](RawLayout& l) { l.type = "uchar"; }), {"--type", "uint8", "'uchar'"}},
      {"a_2x2x2_uint8.raw", 8, with([](RawLayout& l) { l.spacing = glm::dvec3(0, 1, 1); }), {"--spacing"}},
      {"a_2x2x2_uint8.raw", 8, with([](RawLayout& l) { l.spacing = glm::dvec3(1, -1, 1); }), {"--spacing"}},
      {"a_2x2x2_uint8.raw", 8, with([](RawLayout& l) { l.spacing = glm::dvec3(1, 1, std::nan("")); }), {"--spacing"}},
      {"a_2x2x2_uint8.raw", 8, with([](RawLayout& l) { l.origin = glm::dvec3(1, 1, std::nan("")); }), {"origin"}},
  };
  for (const BadRaw& bad : cases) {
    TempFolder folder;
    const std::string path = folder.write(bad.name, std::string(bad.bytes, 'a'));
    const std::string message = messageOf<InputError>([&] { readVolume(path, {.grid = "", .raw = bad.layout}); });
    EXPECT_THAT(message, testing::StartsWith(path + ": "));
    for (const std::string& part : bad.message) EXPECT_THAT(message, HasSubstr(part));
  }
}

}  // namespace
}  // namespace isolume::test
