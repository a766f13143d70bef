// What is read through ITK.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "errors.h"
#include "ramp_volume.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

using testing::HasSubstr;

TEST(Itk, ReadsOtherEncodings) {
  // NRRD as text arrives through ITK with its samples.
  TempFolder folder;
  std::string text;
  for (int i = 0; i < 24; ++i) text += fmt::format("{} ", i);
  expectRamp(readVolume(folder.write("b.nrrd",
                                     "NRRD0004\ntype: int\ndimension: 3\nsizes: 2 3 4\nspacings: 1 1 1\n"
                                     "encoding: ascii\n\n" +
                                         text + "\n")));
}

TEST(Itk, RefusesWhatIsNotOneScalarVolume) {
  // A vector per sample and a header whose sizes no memory holds are errors of one line.
  TempFolder folder;
  EXPECT_THAT(messageOf<InputError>([&] {
                readVolume(folder.write("d.nrrd",
                                        "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 2 2 2\n"
                                        "kinds: vector domain domain domain\nencoding: raw\n\n" +
                                            ramp<std::uint8_t>()));
              }),
              HasSubstr("expected one value per sample, found 3"));
  EXPECT_THAT(messageOf<InputError>([&] {
                readVolume(folder.write("e.nrrd",
                                        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 90000 90000 90000\n"
                                        "encoding: raw\n\n1234"));
              }),
              HasSubstr("of memory"));
}

TEST(Itk, FilesThatEndTooSoon) {
  // A raw NRRD, a legacy VTK image and a GIPL image, each one byte short, are refused.
  TempFolder folder;
  const std::string samples = ramp<std::uint8_t>();
  std::string gipl(256, '\0');
  const auto put = [&](std::size_t at, std::initializer_list<int> bytes) {
    for (const int byte : bytes) gipl[at++] = static_cast<char>(byte);
  };
  put(0, {0, 2, 0, 3, 0, 4, 0, 1});                                   // sizes, big-endian
  put(8, {0, 8});                                                     // type: unsigned 8 bit
  for (std::size_t i = 0; i < 4; ++i) put(10 + 4 * i, {0x3f, 0x80});  // spacings of 1
  put(252, {0xef, 0xff, 0xe9, 0xb0});                                 // the magic number
  const std::vector<std::pair<std::string, std::string>> headers{
      {"a.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nspacings: 1 1 1\nencoding: raw\n\n"},
      {"a.vtk",
       "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 3 4\nSPACING 1 1 1\n"
       "ORIGIN 0 0 0\nPOINT_DATA 24\nSCALARS v unsigned_char 1\nLOOKUP_TABLE default\n"},
      {"a.gipl", gipl}};
  for (const auto& [name, header] : headers) {
    expectRamp(readVolume(folder.write(name, header + samples)));
    const std::string cut = folder.write(name, header + samples.substr(0, samples.size() - 1));
    EXPECT_THAT(messageOf<InputError>([&] { readVolume(cut); }), HasSubstr(cut + ": ")) << name;
  }
}
/// A TIFF of so many pages of 4x3 uint8 samples, which hold the page's number; all directories before all samples, or
/// each behind its samples.
std::string tiff(int pages, bool directoriesFirst) {
  constexpr std::uint32_t kWidth = 4, kHeight = 3, kEntries = 9, kDirectory = 2 + kEntries * 12 + 4, kHeader = 8;
  constexpr std::uint32_t kSamples = kWidth * kHeight;
  std::string samples, directories;
  const auto count = static_cast<std::uint32_t>(pages);
  const std::uint32_t samplesAt = directoriesFirst ? kHeader + count * kDirectory : kHeader;
  const std::uint32_t directoriesAt = directoriesFirst ? kHeader : kHeader + count * kSamples;
  for (std::uint32_t i = 0; i < count; ++i) {
    samples += std::string(kSamples, static_cast<char>(i));
    directories += bytesOf<std::uint16_t>({kEntries});
    const std::uint32_t entries[kEntries][2] = {{256, kWidth}, {257, kHeight}, {258, 8},
                                                {259, 1},      {262, 1},       {273, samplesAt + i * kSamples},
                                                {277, 1},      {278, kHeight}, {279, kSamples}};
    for (const auto& entry : entries)
      directories +=
          bytesOf<std::uint16_t>({static_cast<std::uint16_t>(entry[0]), 4}) + bytesOf<std::uint32_t>({1, entry[1]});
    directories += bytesOf<std::uint32_t>({i + 1 < count ? directoriesAt + (i + 1) * kDirectory : 0});
  }
  const std::string head = "II" + bytesOf<std::uint16_t>({42}) + bytesOf<std::uint32_t>({directoriesAt});
  return head + (directoriesFirst ? directories + samples : samples + directories);
}

TEST(Itk, TiffStacks) {
  // A stack of pages is a volume; one that lacks a page, or part of one, is refused and never a shorter volume.
  TempFolder folder;
  for (const bool directoriesFirst : {false, true}) {
    const std::string whole = tiff(3, directoriesFirst);
    const Volume volume = readVolume(folder.write("a.tif", whole));
    ASSERT_EQ(volume.values.size(), glm::ivec3(4, 3, 3));
    EXPECT_EQ(volume.values.view()(3, 2, 1), 1);
    EXPECT_EQ(volume.values.view()(0, 0, 2), 2);
    for (const std::size_t less : {1, 5, 13, 50, 120}) {
      const std::string cut = folder.write("cut.tif", whole.substr(0, whole.size() - less));
      EXPECT_THAT(messageOf<InputError>([&] { readVolume(cut); }), HasSubstr("cut.tif: ")) << less;
    }
  }
}

}  // namespace
}  // namespace isolume::test
