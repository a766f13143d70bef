// MetaImage, alone and against ITK's own reading of the same files.
#include "io/metaimage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "errors.h"
#include "io/itk_reader.h"
#include "ramp_volume.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

using testing::HasSubstr;

TEST(MetaImage, KeepsSpacingOriginAndDirection) {
  // The three columns are the three triples of TransformMatrix times the spacing; ITK's reading agrees.
  TempFolder folder;
  folder.write("d.bin", ramp<std::int16_t>(true));
  const std::string path = folder.write("a.mhd",
                                        "ObjectType = Image\r\nNDims = 3\r\nBinaryData = True\r\n"
                                        "BinaryDataByteOrderMSB = True\r\nTransformMatrix = 0 1 0 -1 0 0 0 0 1\r\n"
                                        "Offset = -10 20 30.5\r\nElementSpacing = 0.5 2 3\r\nDimSize = 2 3 4\r\n"
                                        "ElementType = MET_SHORT\r\nElementDataFile = d.bin\r\n");
  const Volume volume = readVolume(path);
  expectRamp(volume);
  EXPECT_EQ(volume.worldFromGrid[0], glm::dvec4(0, 0.5, 0, 0));
  EXPECT_EQ(volume.worldFromGrid[1], glm::dvec4(-2, 0, 0, 0));
  EXPECT_EQ(volume.worldFromGrid[2], glm::dvec4(0, 0, 3, 0));
  EXPECT_EQ(volume.worldFromGrid[3], glm::dvec4(-10, 20, 30.5, 1));
  EXPECT_EQ(volume.values.view().spacing, glm::dvec3(0.5, 2, 3));
  EXPECT_EQ(volume.world, "LPS millimetres");
  EXPECT_EQ(volume.files, (std::vector<std::string>{path, folder.path("d.bin")}));
#ifdef ISOLUME_HAVE_ITK
  expectSame(volume, readItk(path, "MetaImage"));
#endif
}

TEST(MetaImage, SynonymsAndDefaults) {
  // The other spellings of origin, direction, byte order and spacing count, and what is missing is the identity.
  TempFolder folder;
  folder.write("d.bin", "head" + ramp<float>(true));
  const std::string common = "NDims = 3\nDimSize = 2 3 4\nElementType = MET_FLOAT\n";
  const Volume named = readVolume(
      folder.write("a.mhd", "ObjectType = Image\n" + common +
                                "Position = 1 2 3\nRotation = 1 0 0 0 0 1 0 -1 0\nElementSize = 2 2 2\nHeaderSize = 4\n"
                                "ElementByteOrderMSB = True\nElementDataFile = d.bin\n"));
  expectRamp(named);
  EXPECT_EQ(named.worldFromGrid[1], glm::dvec4(0, 0, 2, 0));
  EXPECT_EQ(named.worldFromGrid[2], glm::dvec4(0, -2, 0, 0));
  EXPECT_EQ(named.worldFromGrid[3], glm::dvec4(1, 2, 3, 1));
  folder.write("e.bin", "any header" + ramp<float>());
  const Volume bare = readVolume(folder.write("b.mhd", common + "HeaderSize = -1\nElementDataFile = e.bin\n"));
  expectRamp(bare);
  EXPECT_EQ(bare.worldFromGrid, glm::dmat4(1));
}

TEST(MetaImage, NegativeSpacingIsAReflection) {
  // An axis with negative spacing runs backwards, as ITK reads it.
  TempFolder folder;
  folder.write("d.bin", ramp<std::uint8_t>());
  const std::string path = folder.write("a.mhd",
                                        "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementType = MET_UCHAR\n"
                                        "ElementSpacing = 1 -2 1\nElementDataFile = d.bin\n");
  const Volume volume = readVolume(path);
  EXPECT_EQ(volume.worldFromGrid[1], glm::dvec4(0, -2, 0, 0));
  EXPECT_EQ(volume.values.view().spacing.y, 2);
#ifdef ISOLUME_HAVE_ITK
  expectSame(volume, readItk(path, "MetaImage"));
#endif
}

TEST(MetaImage, EveryElementType) {
  // Each scalar MET_ type reads as the C++ type that MetaImage defines for it.
  TempFolder folder;
  const std::vector<std::pair<std::string, std::string>> types{{"MET_CHAR", ramp<std::int8_t>()},
                                                               {"MET_UCHAR", ramp<std::uint8_t>()},
                                                               {"MET_SHORT", ramp<std::int16_t>()},
                                                               {"MET_USHORT", ramp<std::uint16_t>()},
                                                               {"MET_INT", ramp<std::int32_t>()},
                                                               {"MET_UINT", ramp<std::uint32_t>()},
                                                               {"MET_LONG", ramp<std::int32_t>()},
                                                               {"MET_ULONG", ramp<std::uint32_t>()},
                                                               {"MET_LONG_LONG", ramp<std::int64_t>()},
                                                               {"MET_ULONG_LONG", ramp<std::uint64_t>()},
                                                               {"MET_FLOAT", ramp<float>()},
                                                               {"MET_DOUBLE", ramp<double>()}};
  for (const auto& [type, bytes] : types) {
    folder.write("d.bin", bytes);
    expectRamp(readVolume(
        folder.write("a.mhd", "NDims = 3\nDimSize = 2 3 4\nElementType = " + type + "\nElementDataFile = d.bin\n")));
  }
}

/// A zlib stream of the bytes.
std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  packed.resize(size);
  return packed;
}

TEST(MetaImage, AttachedAndCompressed) {
  // Samples behind the header or in another file, compressed or not, and a fourth dimension of 1 read alike.
  TempFolder folder;
  const std::string common =
      "ObjectType = Image\nBinaryData = True\nElementType = MET_SHORT\nNDims = 3\nDimSize = 2 3 4\nOffset = 1 2 3\n";
  const std::string samples = ramp<std::int16_t>(), packed = deflated(samples);
  const std::string zipped = common + "CompressedData = True\n";
  folder.write("d.zraw", packed);
  const Volume plain = readVolume(folder.write("a.mha", common + "ElementDataFile = LOCAL\n" + samples));
  expectRamp(plain);
  EXPECT_EQ(plain.worldFromGrid[3], glm::dvec4(1, 2, 3, 1));
  EXPECT_EQ(plain.files.size(), 1u);
  expectSame(plain, readVolume(folder.write("b.mha", zipped + "ElementDataFile = LOCAL\n" + packed)));
  expectSame(plain, readVolume(folder.write("c.mhd", zipped + "ElementDataFile = d.zraw\n")));
  expectSame(plain, readVolume(folder.write("d.mha",
                                            "ObjectType = Image\nNDims = 4\nDimSize = 2 3 4 1\n"
                                            "Offset = 1 2 3 9\nElementSpacing = 1 1 1 7\n"
                                            "TransformMatrix = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n"
                                            "ElementType = MET_SHORT\nElementDataFile = LOCAL\n" +
                                                samples)));
  const auto fails = [&](const std::string& bytes) {
    return messageOf<InputError>([&] { readVolume(folder.write("e.mha", bytes)); });
  };
  EXPECT_THAT(fails(common + "ElementDataFile = LOCAL\n" + samples.substr(1)), HasSubstr("expected at least"));
  EXPECT_THAT(fails(zipped + "ElementDataFile = LOCAL\n" + packed.substr(0, packed.size() - 1)),
              HasSubstr("cut short or damaged"));
  std::string damaged = packed;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  EXPECT_THAT(fails(zipped + "ElementDataFile = LOCAL\n" + damaged), HasSubstr("e.mha: "));
  EXPECT_THAT(fails(zipped + "ElementDataFile = LOCAL\n" + deflated(samples + "x")),
              HasSubstr("expected 48 bytes once unpacked, found 49"));
  EXPECT_THAT(fails("ObjectType = Image\nNDims = 4\nDimSize = 2 3 2 2\nElementType = MET_UCHAR\n"
                    "ElementDataFile = LOCAL\n" +
                    samples),
              HasSubstr("expected a 3D image, found 2x3x2x2"));
  EXPECT_THAT(fails(common + "ElementDataFile = LIST\na.raw\n"), HasSubstr("expected one file, found several"));
  EXPECT_THAT(fails("BinaryData = False\n" + common + "ElementDataFile = LOCAL\n"), HasSubstr("samples as text"));
}

}  // namespace
}  // namespace isolume::test
