#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "src/errors.h"
#include "src/io/image.h"
#include "src/io/image_codec.h"
#include "src/io/srgb.h"
#include "sweep/parallel.h"
#include "temporary_folder.h"

namespace isolume {
namespace {

using test::fileBytes;
using test::messageOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Key;
using ::testing::Not;
using ::testing::StartsWith;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

class ImageFile : public test::TemporaryFolder {};

Image makeImage(glm::ivec2 size, const std::vector<std::string>& names) {
  Image image{size, {}, {}};
  const int count = size.x * size.y;
  for (std::size_t c = 0; c < names.size(); ++c) {
    image.channels.push_back({names[c], {}});
    for (int i = 0; i < count; ++i)
      image.channels.back().values.push_back(static_cast<float>(i + 1) /
                                             static_cast<float>(count + static_cast<int>(c)));
  }
  return image;
}

const std::vector<std::pair<std::string, std::string>> kMetadata{
    {"isolume:command", "isolume render 'Schädel μCT.raw' -o a.png --isovalue 12.5"},
    {"isolume:gl", "line one\nline two"},
    {"isolume:long", std::string(20000, 'x')},
    {"Software", "isolume 0.1.0"},
};

TEST(Srgb, KnownValues) {
  // The curve goes through the points that the standard names and inverts itself.
  EXPECT_EQ(srgbFromLinear(0), 0);
  EXPECT_NEAR(srgbFromLinear(1), 1, 1e-7);
  EXPECT_NEAR(srgbFromLinear(0.0031308f), 0.04045, 1e-6);
  EXPECT_NEAR(srgbFromLinear(0.5f), 0.7353569831, 1e-6);  // 1.055 * .5^(1/2.4) - .055
  EXPECT_NEAR(srgbFromLinear(0.214041f), 0.5, 1e-6);      // ((.5 + .055) / 1.055)^2.4 = .2140411
  for (int i = 0; i <= 1000; ++i) {
    const float x = static_cast<float>(i) / 1000;
    EXPECT_NEAR(linearFromSrgb(srgbFromLinear(x)), x, 1e-6) << x;
  }
}

TEST(Srgb, OutOfRangeIsClamped) {
  // Whatever comes, NaN included, gives a number that a file can hold.
  EXPECT_EQ(srgbFromLinear(-1), 0);
  EXPECT_EQ(srgbFromLinear(std::nanf("")), 0);
  EXPECT_EQ(srgbFromLinear(kInfinity), srgbFromLinear(1));
  EXPECT_EQ(srgbFromLinear(-kInfinity), 0);
}

TEST_F(ImageFile, EveryCodeOfPngSurvives) {
  // A picture of all 256 (and 65536) sRGB codes is stored as exactly those codes: rounding is to the nearest.
  for (const int bits : {8, 16}) {
    const int last = (1 << bits) - 1;
    Image image{{1 << bits / 2, 1 << bits / 2}, {{"R", {}}, {"G", {}}, {"B", {}}}, {}};
    for (ImageChannel& channel : image.channels)
      for (int code = 0; code <= last; ++code)
        channel.values.push_back(linearFromSrgb(static_cast<float>(code) / static_cast<float>(last)));
    writeImage(at("codes.png"), image, {bits});
    const RawImage raw = imageCodec().decode(fileBytes(at("codes.png")), ImageFormat::png);
    ASSERT_EQ(raw.type, bits == 8 ? SampleType::uint8 : SampleType::uint16);
    const std::size_t bytes = bits == 8 ? 1 : 2;
    for (int code = 0; code <= last; ++code) {
      std::uint16_t green = 0;
      std::memcpy(&green, raw.samples.data() + (static_cast<std::size_t>(code) * 3 + 1) * bytes, bytes);
      ASSERT_EQ(green, code) << bits << " bits";
    }
  }
}

TEST_F(ImageFile, PngStoresStraightAlpha) {
  // Premultiplied linear colour is divided by alpha before it is encoded, and is 0 where alpha is.
  const Image image{
      {3, 1}, {{"R", {0.25f, 0.0f, 0.5f}}, {"G", {0.5f, 0.0f, 0.5f}}, {"B", {0, 0, 0.5f}}, {"A", {0.5f, 0, 1}}}, {}};
  writeImage(at("alpha.png"), image);
  const RawImage raw = imageCodec().decode(fileBytes(at("alpha.png")), ImageFormat::png);
  std::vector<int> codes;
  for (const std::byte byte : raw.samples) codes.push_back(static_cast<int>(byte));
  // sRGB(.5) = .73536 = 187.5 / 255 rounds to 188; alpha .5 = 127.5 / 255 rounds up.
  EXPECT_THAT(codes, ElementsAre(188, 255, 0, 128, 0, 0, 0, 0, 188, 188, 188, 255));
}

TEST_F(ImageFile, PngReadsBackLinear) {
  // Reading inverts writing to within the steps of 16 bits, premultiplied alpha included.
  const Image image = makeImage({7, 5}, {"R", "G", "B", "A"});
  Image premultiplied = image;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < 35; ++i) premultiplied.channels[c].values[i] *= image.channels[3].values[i];
  writeImage(at("a.png"), premultiplied, {16});
  const Image back = readImage(at("a.png"));
  ASSERT_EQ(back.size, image.size);
  ASSERT_EQ(back.channels.size(), 4u);
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t i = 0; i < 35; ++i)
      // Half a step is 8e-6; the curve's slope, at most 2.3 for decoding, doubles it.
      EXPECT_NEAR(back.channels[c].values[i], premultiplied.channels[c].values[i], 2e-5);
}

TEST_F(ImageFile, ExrKeepsEveryBit) {
  // All layers come back under their names and bit for bit, NaN, infinities, -0 and denormals included.
  Image image = makeImage({5, 3}, {"R", "G", "B", "A", "ambient.Y", "normal.X", "normal.Y", "normal.Z", "position.X",
                                   "position.Y", "position.Z", "Z"});
  const float payload = std::bit_cast<float>(0x7fc12345u);
  image.channels[8].values[4] = payload;
  image.channels[11].values[0] = kInfinity;
  image.channels[11].values[14] = -kInfinity;
  image.channels[5].values[3] = -0.0f;
  image.channels[6].values[3] = std::numeric_limits<float>::denorm_min();
  writeImage(at("a.exr"), image);
  const Image back = readImage(at("a.exr"));
  ASSERT_EQ(back.size, image.size);
  ASSERT_EQ(back.channels.size(), image.channels.size());
  for (const ImageChannel& wanted : image.channels) {
    const auto found = std::find_if(back.channels.begin(), back.channels.end(),
                                    [&](const ImageChannel& channel) { return channel.name == wanted.name; });
    ASSERT_NE(found, back.channels.end()) << wanted.name;
    for (std::size_t i = 0; i < wanted.values.size(); ++i)
      EXPECT_EQ(std::bit_cast<std::uint32_t>(found->values[i]), std::bit_cast<std::uint32_t>(wanted.values[i]))
          << wanted.name << " at " << i;
  }
}

TEST_F(ImageFile, MetadataSurvivesBothFormats) {
  // Every pair, with UTF-8, line breaks and 20,000 characters, comes back from either format; other programs find it
  // too.
  Image image = makeImage({4, 4}, {"R", "G", "B"});
  image.metadata = kMetadata;
  for (const char* name : {"a.png", "a.exr"}) {
    writeImage(at(name), image);
    EXPECT_THAT(readImage(at(name)).metadata, IsSupersetOf(kMetadata)) << name;
  }
  EXPECT_THAT(fileBytes(at("a.png")), HasSubstr(std::string("tEXtSoftware\0isolume 0.1.0", 26)));
  EXPECT_THAT(fileBytes(at("a.exr")), HasSubstr("isolume render 'Schädel μCT.raw'"));
}

TEST_F(ImageFile, MetadataThatWouldVanishIsRefused) {
  // A key that means something else to the EXR format is an error, not a silent loss, and nothing is written.
  Image image = makeImage({4, 4}, {"R", "G", "B"});
  for (const char* key : {"compression", "oiio:ColorSpace", "png:text"}) {
    image.metadata = {{key, "my value"}};
    EXPECT_THROW(writeImage(at("a.exr"), image), std::logic_error) << key;
  }
  EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(ImageFile, SameImageSameBytes) {
  // Nothing in a file depends on the time or on the number of threads.
  Image image = makeImage({200, 150}, {"R", "G", "B", "A"});
  image.metadata = kMetadata;
  for (const char* name : {"1.png", "1.exr", "2.png", "2.exr"}) {
    setThreadCount(name[0] - '0');
    writeImage(at(name), image);
  }
  setThreadCount(0);
  EXPECT_TRUE(fileBytes(at("1.png")) == fileBytes(at("2.png")));
  // Two files of the same second would agree in the date as well, which OpenImageIO likes to add.
  EXPECT_THAT(readImage(at("1.exr")).metadata, Not(Contains(Key("DateTime"))));
  EXPECT_TRUE(fileBytes(at("1.exr")) == fileBytes(at("2.exr")));
}

TEST_F(ImageFile, WrongTargetsAreUsageErrors) {
  // The ending decides on the format; a PNG takes colour alone, in 8 or 16 bits. Early check and writing agree.
  const std::vector<std::string> rgb{"R", "G", "B"}, layers{"R", "G", "B", "A", "Z"};
  const auto expectBoth = [&](const std::string& name, const std::vector<std::string>& channels, int bits,
                              const std::string& message) {
    EXPECT_EQ(messageOf<UsageError>([&] { checkImageTarget(at(name), channels, {bits}); }), at(name) + message);
    EXPECT_EQ(messageOf<UsageError>([&] {
                writeImage(at(name), makeImage({2, 2}, channels), {bits});
              }),
              at(name) + message);
  };
  expectBoth("a.jpg", rgb, 8, ": expected a name that ends in .png or .exr, found .jpg");
  expectBoth("a", rgb, 8, ": expected a name that ends in .png or .exr, found no ending");
  expectBoth("a.png", rgb, 12, ": expected a PNG bit depth of 8 or 16, found 12");
  expectBoth("a.png", layers, 8,
             ": expected the channels R, G, B or R, G, B, A, which are all that a PNG holds, found R, G, B, A, Z");
  EXPECT_NO_THROW(checkImageTarget(at("a.PNG"), rgb, {8}));
  EXPECT_NO_THROW(checkImageTarget(at("a.exr"), layers, {8}));
  EXPECT_THROW(checkImageTarget(at("none/a.png"), rgb, {8}), OutputError);
  EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(ImageFile, UnicodeNames) {
  // Names beyond ASCII work for both formats.
  const Image image = makeImage({2, 2}, {"R", "G", "B"});
  for (const char* name : {"Schädel μ 頭.png", "Schädel μ 頭.exr"}) {
    writeImage(at(name), image);
    EXPECT_EQ(readImage(at(name)).size, image.size);
  }
}

TEST_F(ImageFile, DamagedImagesAreInputErrors) {
  // Missing, foreign, empty and truncated files are input errors that name the file.
  const Image image = makeImage({64, 64}, {"R", "G", "B"});
  for (const std::string name : {"a.png", "a.exr"}) {
    writeImage(at(name), image);
    const std::string bytes = fileBytes(at(name));
    std::ofstream(at("cut"), std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    EXPECT_THAT(messageOf<InputError>([&] { readImage(at("cut")); }),
                StartsWith(at("cut") + ": cannot decode the image: "));
  }
  std::ofstream(at("text")) << "no image";
  EXPECT_EQ(messageOf<InputError>([&] { readImage(at("text")); }),
            at("text") + ": expected a PNG or EXR image, found neither signature");
  EXPECT_EQ(messageOf<InputError>([&] { readImage(at("none")); }),
            at("none") + ": cannot read: No such file or directory");
}

}  // namespace
}  // namespace isolume
