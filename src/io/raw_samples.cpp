#include "raw_samples.h"

#include <fmt/format.h>

#include <bit>

#include "errors.h"
#include "inflate.h"
#include "input_file.h"
#include "placement.h"

namespace isolume {
namespace {

std::string describe(const RawDescription& d) {
  std::string text = fmt::format("{}x{}x{} {}", d.dims.x, d.dims.y, d.dims.z, sampleTypeName(d.type));
  if (!d.dataAtEnd && d.offset > 0) text += fmt::format(" after {} bytes", d.offset);
  return text;
}

/// What else the size of the file would fit, for the message: another type, or bytes before the samples.
std::string suggestion(const RawDescription& d, std::uint64_t found, std::uint64_t samples) {
  constexpr std::uint64_t kLargestHeader = 65536;
  if (found > d.offset && (found - d.offset) % samples == 0) {
    const std::uint64_t each = (found - d.offset) / samples;
    if (each == 1 || each == 2 || each == 4 || each == 8)
      return fmt::format("; {} byte{} per sample would fit", each, each == 1 ? "" : "s");
  }
  const std::uint64_t needed = samples * bytesPerSample(d.type);
  if (found >= needed && found - needed <= kLargestHeader)
    return fmt::format("; an offset of {} would fit", found - needed);
  return "";
}

}  // namespace

Volume readRawSamples(const RawDescription& d) {
  std::uint64_t samples = 1;
  std::uint64_t bytes = bytesPerSample(d.type);
  bool overflow = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (d.dims[axis] < 1)
      throw InputError(
          fmt::format("{}: expected dimensions above 0, found {}x{}x{}", d.dataPath, d.dims.x, d.dims.y, d.dims.z));
    overflow |= __builtin_mul_overflow(samples, static_cast<std::uint64_t>(d.dims[axis]), &samples);
  }
  overflow |= __builtin_mul_overflow(bytes, samples, &bytes);
  std::uint64_t expected = bytes;
  if (!d.dataAtEnd) overflow |= __builtin_add_overflow(bytes, d.offset, &expected);
  const InputFile file(d.dataPath);
  if (overflow)
    throw InputError(fmt::format("{}: expected more bytes than 64 bits can count ({}), found {}", d.dataPath,
                                 describe(d), file.size()));
  const bool atLeast = d.dataAtEnd || d.trailing;
  if (!d.compressed && (atLeast ? file.size() < expected : file.size() != expected))
    throw InputError(fmt::format("{}: expected {}{} bytes ({}), found {}{}", d.dataPath, atLeast ? "at least " : "",
                                 expected, describe(d), file.size(),
                                 atLeast ? "" : suggestion(d, file.size(), samples)));

  Volume volume;
  volume.worldFromGrid = d.worldFromGrid;
  volume.values = makeGrid(d.dataPath, d.dims, d.worldFromGrid, d.compressed ? bytesPerSample(d.type) : 0);
  volume.sampleType = sampleTypeName(d.type);
  volume.files = {d.dataPath};
  const std::uint64_t start = d.dataAtEnd ? file.size() - bytes : d.offset;
  const auto unpacked = d.compressed ? inflateFile(d.dataPath, d.offset, bytes) : std::vector<std::byte>();
  const auto fetch = [&](std::size_t first, std::size_t count, std::byte* scratch) -> const std::byte* {
    if (d.compressed) return unpacked.data() + first;
    file.readAt(start + first, scratch, count);
    return scratch;
  };
  const bool swapBytes = d.bigEndian != (std::endian::native == std::endian::big);
  ConvertedSamples converted = convertSamples(fetch, d.type, swapBytes, volume.values.view());
  volume.valueOffset = converted.valueOffset;
  volume.notes = std::move(converted.notes);
  return volume;
}

}  // namespace isolume
