#include <gmock/gmock.h>

#include <boost/crc.hpp>
#include <stdexcept>

#include "src/io/png_text.h"

namespace isolume {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

// Signature, a header chunk (13 bytes of data) and an end chunk: all that the functions look at.
std::string bareChunk(const std::string& type, const std::string& data) {
  boost::crc_32_type crc;
  crc.process_bytes((type + data).data(), type.size() + data.size());
  const auto bytes = [](std::uint32_t v) {
    return std::string{static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8),
                       static_cast<char>(v)};
  };
  return bytes(static_cast<std::uint32_t>(data.size())) + type + data + bytes(crc.checksum());
}
const std::string kBarePng = "\x89PNG\r\n\x1a\n" + bareChunk("IHDR", std::string(13, '\1')) + bareChunk("IEND", "");

TEST(PngText, AsciiGoesIntoLatinChunk) {
  // Plain text becomes a tEXt chunk right behind the header, byte for byte as the standard lays it out.
  const std::string expected = "\x89PNG\r\n\x1a\n" + bareChunk("IHDR", std::string(13, '\1')) +
                               bareChunk("tEXt", std::string("isolume:a\0two\nlines", 19)) + bareChunk("IEND", "");
  EXPECT_EQ(insertPngText(kBarePng, {{"isolume:a", "two\nlines"}}), expected);
}

TEST(PngText, OtherTextGoesIntoUnicodeChunk) {
  // Anything but ASCII becomes an uncompressed iTXt chunk, since tEXt is Latin-1 by definition.
  const std::string png = insertPngText(kBarePng, {{"k", "Schädel"}});
  EXPECT_THAT(png, HasSubstr(bareChunk("iTXt", std::string("k\0\0\0\0\0", 6) + "Schädel")));
}

TEST(PngText, PairsComeBack) {
  // Reading gives what was inserted, in order, with empty values, repeated keys and long values.
  const TextPairs pairs{{"a", "1"}, {"b c", ""}, {"a", "2"}, {"µ", "x"}, {"d", std::string(100000, 'y')}};
  TextPairs ascii = pairs;
  ascii.erase(ascii.begin() + 3);
  ascii.emplace_back("e", "µ");
  EXPECT_EQ(readPngText(insertPngText(kBarePng, ascii)), ascii);
  EXPECT_THROW(insertPngText(kBarePng, pairs), std::logic_error);
}

TEST(PngText, InvalidKeysAreRefused) {
  // Keys that the standard forbids, and values that a NUL would cut short, are errors and never written.
  for (const std::string& key : {std::string(), std::string(80, 'k'), std::string(" a"), std::string("a "),
                                 std::string("a  b"), std::string("a\nb"), std::string("ä")})
    EXPECT_THROW(insertPngText(kBarePng, {{key, "x"}}), std::logic_error) << key;
  EXPECT_THROW(insertPngText(kBarePng, {{"a", std::string("x\0y", 3)}}), std::logic_error);
  EXPECT_NO_THROW(insertPngText(kBarePng, {{std::string(79, 'k'), "x"}}));
}

TEST(PngText, DamagedFilesAreSafeToRead) {
  // Every truncation of a PNG gives a prefix of the pairs, and a length beyond the end gives none.
  const TextPairs pairs{{"a", "1"}, {"b", "µ"}};
  const std::string png = insertPngText(kBarePng, pairs);
  for (std::size_t size = 0; size <= png.size(); ++size) {
    const TextPairs found = readPngText(std::string_view(png).substr(0, size));
    ASSERT_LE(found.size(), pairs.size());
    EXPECT_TRUE(std::equal(found.begin(), found.end(), pairs.begin()));
  }
  EXPECT_THAT(readPngText(std::string("\x89PNG\r\n\x1a\n\xff\xff\xff\xfftEXta\0b....", 25)), IsEmpty());
}

}  // namespace
}  // namespace isolume
