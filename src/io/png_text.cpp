#include "png_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cstdint>
#include <stdexcept>

namespace isolume {
namespace {

constexpr std::size_t kSignatureSize = 8;
constexpr std::size_t kLengthSize = 4, kTypeSize = 4, kCrcSize = 4;
constexpr std::size_t kHeaderChunkSize = kLengthSize + kTypeSize + 13 + kCrcSize;  // IHDR has 13 bytes, [PNG] 11.2.2
constexpr std::size_t kMaxKeySize = 79;                                            // [PNG] 11.3.3.2

std::string bigEndian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

std::uint32_t fromBigEndian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char c : bytes.substr(0, kLengthSize)) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

bool isPrintableAscii(char c) { return c >= ' ' && c <= '~'; }

void requireValid(const std::string& key, const std::string& value) {
  const bool ok = !key.empty() && key.size() <= kMaxKeySize && key.front() != ' ' && key.back() != ' ' &&
                  key.find("  ") == std::string::npos && std::all_of(key.begin(), key.end(), isPrintableAscii);
  if (!ok)
    throw std::logic_error(fmt::format("image metadata: expected a key of 1 to 79 ASCII characters, found '{}'", key));
  if (value.find('\0') != std::string::npos)
    throw std::logic_error(fmt::format("image metadata: expected a value without NUL for '{}'", key));
}

// [PNG] 5.3: length of the data, type, data, CRC of type and data.
std::string chunk(std::string_view type, const std::string& data) {
  const std::string body = std::string(type) + data;
  boost::crc_32_type crc;
  crc.process_bytes(body.data(), body.size());
  return bigEndian(static_cast<std::uint32_t>(data.size())) + body + bigEndian(crc.checksum());
}

std::string textChunk(const std::string& key, const std::string& value) {
  const bool ascii = std::all_of(value.begin(), value.end(), [](char c) { return isPrintableAscii(c) || c == '\n'; });
  if (ascii) return chunk("tEXt", key + '\0' + value);
  // Compression flag and method, then empty language tag and translated key, each of the latter ended by a NUL.
  return chunk("iTXt", key + std::string(1 + 2 + 2, '\0') + value);
}

// Everything after the count-th NUL behind `from`, or nothing.
std::string_view afterNuls(std::string_view data, std::size_t from, int count) {
  for (; count > 0; --count) {
    const std::size_t end = data.find('\0', from);
    if (end == std::string_view::npos) return {};
    from = end + 1;
  }
  return data.substr(std::min(from, data.size()));
}

}  // namespace

std::string insertPngText(std::string_view png, const TextPairs& pairs) {
  const std::size_t head = kSignatureSize + kHeaderChunkSize;
  std::string result(png.substr(0, head));
  for (const auto& [key, value] : pairs) {
    requireValid(key, value);
    result += textChunk(key, value);
  }
  return result.append(png.substr(std::min(head, png.size())));
}

TextPairs readPngText(std::string_view png) {
  TextPairs pairs;
  std::size_t at = kSignatureSize;
  while (at + kLengthSize + kTypeSize + kCrcSize <= png.size()) {
    const std::size_t length = fromBigEndian(png.substr(at));
    const std::string_view type = png.substr(at + kLengthSize, kTypeSize);
    const std::string_view data = png.substr(at + kLengthSize + kTypeSize, length);
    const std::size_t keyEnd = data.find('\0');
    if (data.size() < length || type == "IEND") break;
    if (type == "tEXt" && keyEnd != std::string_view::npos) {
      pairs.emplace_back(data.substr(0, keyEnd), data.substr(keyEnd + 1));
    } else if (type == "iTXt" && keyEnd + 2 < data.size() && data[keyEnd + 1] == 0) {
      pairs.emplace_back(data.substr(0, keyEnd), afterNuls(data, keyEnd + 1 + 2, 2));
    }
    at += kLengthSize + kTypeSize + length + kCrcSize;
  }
  return pairs;
}

}  // namespace isolume
