#include "stored_size.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>

#include "errors.h"
#include "header_text.h"
#include "inflate.h"
#include "input_file.h"

namespace isolume {
namespace {

constexpr std::size_t kHeadBytes = 1024;
using Head = std::array<char, kHeadBytes>;

/// The first bytes of a file, unpacked if it is compressed; the rest is 0.
Head headOf(const std::string& path) {
  Head head{};
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (file) gzread(file.get(), head.data(), static_cast<unsigned>(head.size()));
  return head;
}

template <class T>
T field(const Head& head, std::size_t at, bool swapBytes) {
  std::array<char, sizeof(T)> bytes;
  std::copy_n(head.begin() + static_cast<std::ptrdiff_t>(at), sizeof(T), bytes.begin());
  if (swapBytes) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

/// The samples of a NIfTI or Analyze pair lie beside the header.
std::string niftiDataFile(const std::string& path) {
  for (const auto& [header, data] : {std::pair{".hdr.gz", ".img.gz"}, {".hdr", ".img"}, {".HDR", ".IMG"}})
    if (path.ends_with(header)) {
      const std::string stem = path.substr(0, path.size() - std::strlen(header));
      const std::string other = stem + data + (std::string_view(data) == ".img" ? ".gz" : "");
      return !std::filesystem::exists(stem + data) && std::filesystem::exists(other) ? other : stem + data;
    }
  return path;
}

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = 0;
  return __builtin_mul_overflow(a, b, &result) ? ~std::uint64_t{0} : result;
}

}  // namespace

void requireContent(const std::string& path, std::uint64_t headerBytes, std::uint64_t sampleBytes) {
  const std::uint64_t found = contentSize(path);
  if (found >= headerBytes && found - headerBytes >= sampleBytes) return;
  throw InputError(fmt::format("{}: expected at least {} bytes of samples after {}, found {} bytes", path, sampleBytes,
                               headerBytes, found));
}

void requireWholeNifti(const std::string& path) {
  // Offsets of NIfTI-1 (and Analyze), then of NIfTI-2, which begin with their own lengths.
  constexpr std::int32_t kLength1 = 348, kLength2 = 540;
  const Head head = headOf(path);
  const auto length = field<std::int32_t>(head, 0, false);
  const bool swapBytes = length != kLength1 && length != kLength2;
  const bool second = field<std::int32_t>(head, 0, swapBytes) == kLength2;
  const auto dim = [&](std::size_t i) -> std::int64_t {
    return second ? field<std::int64_t>(head, 16 + 8 * i, swapBytes) : field<std::int16_t>(head, 40 + 2 * i, swapBytes);
  };
  const std::int16_t bits = field<std::int16_t>(head, second ? 14 : 72, swapBytes);
  const double offset = second ? static_cast<double>(field<std::int64_t>(head, 168, swapBytes))
                               : static_cast<double>(field<float>(head, 108, swapBytes));
  constexpr std::int64_t kMostDimensions = 7;
  constexpr int kBitsPerByte = 8;
  std::uint64_t bytes = static_cast<std::uint64_t>(std::max<int>(bits, 0) / kBitsPerByte);
  for (std::int64_t i = 1; i <= std::min(dim(0), kMostDimensions); ++i)
    bytes = product(bytes, static_cast<std::uint64_t>(std::max<std::int64_t>(dim(static_cast<std::size_t>(i)), 1)));
  const std::string data = niftiDataFile(path);
  constexpr double kLargestOffset = 1e15;  // far above any file; keeps the conversion defined
  requireContent(data, offset > 0 && offset < kLargestOffset ? static_cast<std::uint64_t>(offset) : 0, bytes);
}

void requireWholeMrc(const std::string& path) {
  constexpr std::int32_t kLargestMode = 127;  // a mode above it has its bytes swapped
  const Head head = headOf(path);
  const auto stored = field<std::int32_t>(head, 12, false);
  const bool swapBytes = stored < 0 || stored > kLargestMode;
  std::uint64_t bytes = 0;
  switch (field<std::int32_t>(head, 12, swapBytes)) {
    case 0:
      bytes = 1;
      break;
    case 1:
    case 6:
      bytes = 2;
      break;
    default:
      bytes = 4;
      break;
  }
  for (std::size_t i = 0; i < 3; ++i)
    bytes = product(bytes, static_cast<std::uint64_t>(std::max(field<std::int32_t>(head, 4 * i, swapBytes), 0)));
  const auto extended = std::max(field<std::int32_t>(head, 92, swapBytes), 0);
  requireContent(path, kHeadBytes + static_cast<std::uint64_t>(extended), bytes);
}

void requireWholeVtk(const std::string& path, std::uint64_t sampleBytes) {
  constexpr std::size_t kHeaderLimit = 1 << 16;
  const std::string text = InputFile(path).head(kHeaderLimit);
  std::size_t dataAt = 0;
  bool binary = false;
  for (const std::string_view line : splitLines(text)) {
    const std::string key = lowerCase(line);
    binary |= key == "binary";
    // Samples begin behind the line SCALARS, or behind LOOKUP_TABLE where that follows.
    if (dataAt > 0 && !key.starts_with("lookup_table")) break;
    if (key.starts_with("scalars") || key.starts_with("lookup_table"))
      dataAt = text.find('\n', static_cast<std::size_t>(line.data() - text.data())) + 1;
  }
  if (!binary)
    throw InputError(fmt::format("{}: expected a legacy VTK image marked BINARY, found samples as text", path));
  requireContent(path, dataAt, sampleBytes);
}

void requireWholeTiff(const std::string& path) {
  const InputFile file(path);
  const bool swapBytes = (file.head(1) == "M") == (std::endian::native == std::endian::little);
  const auto number = [&](std::uint64_t at, std::size_t bytes) {
    std::array<char, sizeof(std::uint64_t)> stored{};
    file.readAt(at, stored.data(), bytes);
    if (swapBytes) std::reverse(stored.begin(), stored.begin() + static_cast<std::ptrdiff_t>(bytes));
    return std::bit_cast<std::uint64_t>(stored);
  };
  constexpr std::uint64_t kBigTiff = 43;  // in the place where a TIFF has 42
  const bool big = number(2, 2) == kBigTiff;
  const std::size_t offsetBytes = big ? 8 : 4, countBytes = big ? 8 : 2, entryBytes = big ? 20 : 12;
  std::uint64_t at = number(big ? 8 : 4, offsetBytes);
  // A chain that bites its tail would have more directories than the file has room for.
  for (std::uint64_t page = 0; at != 0; ++page) {
    const bool inside = at <= file.size() && file.size() - at >= countBytes + offsetBytes && page < file.size();
    const std::uint64_t entries = inside ? number(at, countBytes) : 0;
    if (!inside || entries > (file.size() - at - countBytes - offsetBytes) / entryBytes)
      throw InputError(fmt::format("{}: expected page {} of the TIFF at byte {}, found {} bytes in all", path, page + 1,
                                   at, file.size()));
    at = number(at + countBytes + entries * entryBytes, offsetBytes);
  }
}

}  // namespace isolume
