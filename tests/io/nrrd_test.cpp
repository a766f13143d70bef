// NRRD, alone and against ITK's own reading of the same files.
#include "io/nrrd.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "errors.h"
#include "io/itk_reader.h"
#include "ramp_volume.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

using testing::HasSubstr;

TEST(Nrrd, SpacingsAndByteOrder) {
  // Spacings stand on the diagonal, big-endian samples are turned round, and no space means no claim about the world.
  TempFolder folder;
  folder.write("d.bin", ramp<std::int16_t>(true));
  const std::string path =
      folder.write("a.nhdr", nrrdHeader("short", "spacings: 0.5 2 3\nendian: big\ndata file: d.bin\n"));
  const Volume volume = readVolume(path);
  expectRamp(volume);
  EXPECT_EQ(volume.values.view().spacing, glm::dvec3(0.5, 2, 3));
  EXPECT_EQ(volume.worldFromGrid[3], glm::dvec4(0, 0, 0, 1));
  EXPECT_EQ(volume.world, "");
  EXPECT_EQ(volume.format, "NRRD");
#ifdef ISOLUME_HAVE_ITK
  expectSame(volume, readItk(path, "NRRD"));
#endif
}

TEST(Nrrd, AnatomicalSpacesBecomeLps) {
  // RAS and LAS directions and origins are turned to LPS, as ITK does, and `world` says so.
  TempFolder folder;
  folder.write("d.bin", ramp<std::uint8_t>());
  struct Case {
    std::string space, world;
    glm::dvec3 sign;
  };
  for (const Case& c :
       {Case{"right-anterior-superior", "LPS millimetres, converted from right-anterior-superior", {-1, -1, 1}},
        Case{"RAS", "LPS millimetres, converted from ras", {-1, -1, 1}},
        Case{"left-anterior-superior", "LPS millimetres, converted from left-anterior-superior", {1, -1, 1}},
        Case{"left-posterior-superior", "LPS millimetres", {1, 1, 1}},
        Case{"3D-right-handed", "3d-right-handed", {1, 1, 1}}}) {
    const std::string path =
        folder.write("a.nhdr", nrrdHeader("uchar", "space: " + c.space +
                                                       "\nspace directions: (0,2,0) (-0.5,0,0) (0, 0, 3)\n"
                                                       "space origin: (10,20,30)\ndatafile: d.bin\n"));
    const Volume volume = readVolume(path);
    expectRamp(volume);
    EXPECT_EQ(glm::dvec3(volume.worldFromGrid[0]), c.sign * glm::dvec3(0, 2, 0));
    EXPECT_EQ(glm::dvec3(volume.worldFromGrid[1]), c.sign * glm::dvec3(-0.5, 0, 0));
    EXPECT_EQ(glm::dvec3(volume.worldFromGrid[3]), c.sign * glm::dvec3(10, 20, 30));
    EXPECT_EQ(volume.world, c.world);
#ifdef ISOLUME_HAVE_ITK
    // Older ITK flips the wrong axis of left-anterior-superior images.
    if (c.sign != glm::dvec3(1, -1, 1)) expectSame(volume, readItk(path, "NRRD"));
    const std::string attached =
        folder.write("a.nrrd", nrrdHeader("uchar", "space: " + c.space +
                                                       "\nspace directions: (0,2,0) (-0.5,0,0) (0, 0, 3)\n"
                                                       "space origin: (10,20,30)\n\n") +
                                   ramp<std::uint8_t>());
    expectSame(volume, readVolume(attached));
#endif
  }
}

TEST(Nrrd, TypeSpellings) {
  // Every spelling of the NRRD definition names its type.
  TempFolder folder;
  const std::vector<std::pair<std::string, std::vector<std::string>>> types{
      {ramp<std::int8_t>(), {"signed char", "int8", "int8_t"}},
      {ramp<std::uint8_t>(), {"uchar", "unsigned char", "uint8", "uint8_t"}},
      {ramp<std::int16_t>(), {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
      {ramp<std::uint16_t>(), {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {ramp<std::int32_t>(), {"int", "signed int", "int32", "int32_t"}},
      {ramp<std::uint32_t>(), {"uint", "unsigned int", "uint32", "uint32_t"}},
      {ramp<std::int64_t>(),
       {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t"}},
      {ramp<std::uint64_t>(), {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
      {ramp<float>(), {"float", "FLOAT"}},
      {ramp<double>(), {"double"}}};
  for (const auto& [bytes, names] : types)
    for (const std::string& name : names) {
      folder.write("d.bin", bytes);
      expectRamp(readVolume(folder.write("a.nhdr", nrrdHeader(name, "endian: little\ndata file: d.bin\n"))));
    }
}

TEST(Nrrd, ByteSkip) {
  // A positive skip must fit to the byte; -1 takes the file's last bytes.
  TempFolder folder;
  folder.write("d.bin", "header!" + ramp<float>());
  expectRamp(
      readVolume(folder.write("a.nhdr", nrrdHeader("float", "endian: little\nbyte skip: 7\ndata file: d.bin\n"))));
  expectRamp(
      readVolume(folder.write("b.nhdr", nrrdHeader("float", "endian: little\nbyte skip: -1\ndata file: d.bin\n"))));
  EXPECT_THAT(messageOf<InputError>([&] {
                readVolume(folder.write("c.nhdr", nrrdHeader("float", "endian: little\ndata file: d.bin\n")));
              }),
              HasSubstr("an offset of 7 would fit"));
}

}  // namespace
}  // namespace isolume::test
