// Headers that make no sense.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "errors.h"
#include "ramp_volume.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

using testing::HasSubstr;

struct BadHeader {
  std::string name, text, message;
};

TEST(Headers, BadOnesAreNamed) {
  // Every header that makes no sense, or describes what cannot be drawn, is one line with the file and the field.
  const std::string mhd = "ObjectType = Image\nNDims = 3\n";
  const std::string good = mhd + "DimSize = 2 3 4\nElementType = MET_UCHAR\n", end = "ElementDataFile = d.bin\n";
  const std::string nrrdEnd = "endian: little\ndata file: d.bin\n";
  const std::vector<BadHeader> cases{
      {"a.mhd", "ObjectType = Image\n", "NDims"},
      {"a.mhd", "ObjectType = Scene\nNDims = 3\n", "expected Image, found 'Scene'"},
      {"a.mhd", "ObjectType = Image\nNDims = 2\n", "expected 3 dimensions, found 2"},
      {"a.mhd", good, "ElementDataFile"},
      {"a.mhd", mhd + "ElementType = MET_UCHAR\n" + end, "DimSize: expected 3 numbers, found ''"},
      {"a.mhd", mhd + "DimSize = 2 3\nElementType = MET_UCHAR\n" + end, "DimSize: expected 3 numbers, found '2 3'"},
      {"a.mhd", mhd + "DimSize = 2 3 four\nElementType = MET_UCHAR\n" + end, "'2 3 four'"},
      {"a.mhd", mhd + "DimSize = -2 3 4\nElementType = MET_UCHAR\n" + end, "-2x3x4"},
      {"a.mhd", mhd + "DimSize = 0 3 4\nElementType = MET_UCHAR\n" + end, "0x3x4"},
      {"a.mhd", mhd + "DimSize = 9000000000000 9000000000000 4\nElementType = MET_UCHAR\n" + end, "64 bits"},
      {"a.mhd", mhd + "DimSize = 99999999999999999999 3 4\nElementType = MET_UCHAR\n" + end, "DimSize"},
      {"a.mhd", mhd + "DimSize = 2 3 4\nElementType = MET_UCHAR_ARRAY\n" + end, "MET_UCHAR_ARRAY"},
      {"a.mhd", mhd + "DimSize = 2 3 4\n" + end, "ElementType"},
      {"a.mhd", good + "ElementNumberOfChannels = 3\n" + end, "ElementNumberOfChannels: expected 1, found 3"},
      {"a.mhd", good + "ElementSpacing = 0 1 1\n" + end, "spacing above 0"},
      {"a.mhd", good + "ElementSpacing = nan 1 1\n" + end, "finite"},
      {"a.mhd", good + "ElementSpacing = 1 inf 1\n" + end, "finite"},
      {"a.mhd", good + "TransformMatrix = 1 0 0 0.5 1 0 0 0 1\n" + end, "shear"},
      {"a.mhd", good + "TransformMatrix = 1 0 0 0 0 0 0 0 1\n" + end, "above 0"},
      {"a.mhd", good + "HeaderSize = -2\n" + end, "HeaderSize"},
      {"a.mhd", good + "ElementDataFile = nowhere.bin\n", "nowhere.bin: cannot be read"},
      {"a.mhd", good + "HeaderSize = 2\n" + end, "expected 26 bytes (2x3x4 uint8 after 2 bytes), found 24"},
      {"a.nhdr", nrrdHeader("block", nrrdEnd), "type: expected a scalar type"},
      {"a.nhdr", nrrdHeader("short", "data file: d.bin\n"), "endian"},
      {"a.nhdr", nrrdHeader("uchar", "spacings: 1 nan 1\n" + nrrdEnd), "finite"},
      {"a.nhdr", nrrdHeader("uchar", "spacings: 1 0 1\n" + nrrdEnd), "above 0"},
      {"a.nhdr", nrrdHeader("uchar", "spacings: 1 1\n" + nrrdEnd), "spacings: expected 3 numbers"},
      {"a.nhdr", nrrdHeader("uchar", "space directions: (1,0,0) (1,1,0) (0,0,1)\n" + nrrdEnd), "shear"},
      {"a.nhdr", nrrdHeader("uchar", "space directions: (1,0,0) none (0,0,1)\n" + nrrdEnd), "vectors"},
      {"a.nhdr", nrrdHeader("uchar", "space origin: (1,0)\n" + nrrdEnd), "vector"},
      {"a.nhdr", nrrdHeader("uchar", "byte skip: -3\n" + nrrdEnd), "byte skip"},
      {"a.nhdr", nrrdHeader("uchar", "endian: little\ndata file: gone.bin\n"), "gone.bin: cannot be read"},
      {"a.nhdr", nrrdHeader("ushort", nrrdEnd), "expected 48 bytes (2x3x4 uint16), found 24"},
  };
  for (const BadHeader& bad : cases) {
    TempFolder folder;
    folder.write("d.bin", ramp<std::uint8_t>());
    const std::string path = folder.write(bad.name, bad.text);
    EXPECT_THAT(messageOf<InputError>([&] { readVolume(path); }), HasSubstr(bad.message)) << bad.text;
  }
}

TEST(Headers, RawOptionsDoNotApply) {
  // An option that only raw files need is refused by name where the file describes itself, never ignored.
  TempFolder folder;
  folder.write("d.bin", ramp<std::uint8_t>());
  const std::string path = folder.write(
      "a.mhd", "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementType = MET_UCHAR\nElementDataFile = d.bin\n");
  const auto message = [&](auto set) {
    ReadOptions options;
    set(options);
    return messageOf<InputError>([&] { readVolume(path, options); });
  };
  EXPECT_THAT(message([](ReadOptions& o) { o.raw.dims = glm::ivec3(2); }), HasSubstr("--dims"));
  EXPECT_THAT(message([](ReadOptions& o) { o.raw.type = "uint8"; }), HasSubstr("--type"));
  EXPECT_THAT(message([](ReadOptions& o) { o.raw.bigEndian = true; }), HasSubstr("--endian"));
  EXPECT_THAT(message([](ReadOptions& o) { o.raw.offset = 0; }), HasSubstr("--offset"));
  EXPECT_THAT(message([](ReadOptions& o) { o.raw.spacing = glm::dvec3(1); }), HasSubstr("--spacing"));
  EXPECT_THAT(message([](ReadOptions& o) { o.raw.origin = glm::dvec3(1); }), HasSubstr("--origin"));
  EXPECT_THAT(message([](ReadOptions& o) { o.grid = "density"; }), HasSubstr("--grid"));
}

}  // namespace
}  // namespace isolume::test
