#include "byte_order_hint.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "input_file.h"

namespace isolume {
namespace {

constexpr std::uint64_t kHintSamples = 4096;

/// The bits of a sample as a number that grows with its value: for floats too, whose steps then count alike.
double ordered(const unsigned char* bytes, std::size_t count, SampleType type, bool bigEndian) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < count; ++i) bits = bits << 8 | bytes[bigEndian ? i : count - 1 - i];
  const std::uint64_t sign = std::uint64_t{1} << (8 * count - 1);
  const bool isFloat = type == SampleType::float32 || type == SampleType::float64;
  const bool isSigned = type == SampleType::int16 || type == SampleType::int32 || type == SampleType::int64;
  if (isFloat && (bits & sign) != 0) return -static_cast<double>(bits ^ sign);
  if (isSigned && (bits & sign) != 0) return static_cast<double>(bits) - 2 * static_cast<double>(sign);
  return static_cast<double>(bits);
}

/// Mean difference of neighbours, relative to the range; 0 for a constant.
double roughness(const std::vector<unsigned char>& bytes, SampleType type, bool bigEndian) {
  const std::size_t each = bytesPerSample(type);
  double low = 0, high = 0, before = 0, sum = 0;
  for (std::size_t i = 0; i < bytes.size(); i += each) {
    const double value = ordered(bytes.data() + i, each, type, bigEndian);
    low = i == 0 ? value : std::min(low, value);
    high = i == 0 ? value : std::max(high, value);
    if (i > 0) sum += std::abs(value - before);
    before = value;
  }
  return high > low ? sum / (high - low) / static_cast<double>(bytes.size() / each) : 0;
}

}  // namespace

std::string byteOrderHint(const RawDescription& d) {
  constexpr double kClearly = 4;
  constexpr std::uint64_t kFewest = 64;  // fewer neighbours prove nothing
  const std::uint64_t total = static_cast<std::uint64_t>(d.dims.x) * static_cast<std::uint64_t>(d.dims.y) *
                              static_cast<std::uint64_t>(d.dims.z);
  const std::size_t each = bytesPerSample(d.type);
  if (each == 1 || total < kFewest) return "";
  const std::uint64_t count = std::min(total, kHintSamples);
  std::vector<unsigned char> bytes(static_cast<std::size_t>(count) * each);
  InputFile(d.dataPath).readAt(d.offset + (total - count) / 2 * each, bytes.data(), bytes.size());
  const double asRead = roughness(bytes, d.type, d.bigEndian), swapped = roughness(bytes, d.type, !d.bigEndian);
  if (swapped == 0 || asRead < kClearly * swapped) return "";
  return d.bigEndian ? "the samples look little-endian: is --endian little meant?"
                     : "the samples look big-endian: is --endian big meant?";
}

}  // namespace isolume
