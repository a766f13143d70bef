#include "samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "sweep/parallel.h"

namespace isolume {
namespace {

struct TypeRow {
  SampleType type;
  std::string_view name;
  std::size_t bytes;
};
constexpr std::array<TypeRow, 10> kTypes{{
    {SampleType::uint8, "uint8", 1},
    {SampleType::int8, "int8", 1},
    {SampleType::uint16, "uint16", 2},
    {SampleType::int16, "int16", 2},
    {SampleType::uint32, "uint32", 4},
    {SampleType::int32, "int32", 4},
    {SampleType::uint64, "uint64", 8},
    {SampleType::int64, "int64", 8},
    {SampleType::float32, "float32", 4},
    {SampleType::float64, "float64", 8},
}};

/// A chunk of the widest samples is 2 MiB: large enough for fast reads, small enough to stay in a core's cache.
constexpr std::size_t kChunkSamples = std::size_t{1} << 18;

template <std::size_t bytes>
using BitsOf = std::conditional_t<
    bytes == 1, std::uint8_t,
    std::conditional_t<bytes == 2, std::uint16_t, std::conditional_t<bytes == 4, std::uint32_t, std::uint64_t>>>;

template <class Bits>
Bits swapped(Bits bits) {
  if constexpr (sizeof(Bits) == 2) return __builtin_bswap16(bits);
  if constexpr (sizeof(Bits) == 4) return __builtin_bswap32(bits);
  if constexpr (sizeof(Bits) == 8) return __builtin_bswap64(bits);
  return bits;
}

/// Stored bytes need not be aligned: a header before them may have any length.
template <class T, bool swap>
T load(const std::byte* bytes) {
  BitsOf<sizeof(T)> bits;
  std::memcpy(&bits, bytes, sizeof(T));
  return std::bit_cast<T>(swap ? swapped(bits) : bits);
}

template <class T>
auto widened(T stored) {
  if constexpr (std::is_integral_v<T> && sizeof(T) == 8) {
    return stored;
  } else {
    return static_cast<double>(stored);
  }
}

template <class T, bool swap>
WideRange convertChunk(const std::byte* from, std::size_t count, double offset, float* to) {
  WideRange seen;
  if constexpr (sizeof(T) < 4 || std::is_same_v<T, float>) {
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<float>(load<T, swap>(from + i * sizeof(T)));
  } else {
    for (std::size_t i = 0; i < count; ++i)
      to[i] = narrowSample(widened(load<T, swap>(from + i * sizeof(T))), offset, seen);
  }
  return seen;
}

template <class T>
ConvertedSamples convertAll(const SampleBytes& from, std::string_view typeName, bool swapBytes, GridView<float> to) {
  const std::size_t chunks = (to.count() + kChunkSamples - 1) / kChunkSamples;
  const auto pass = [&](double offset) {
    std::vector<WideRange> parts(chunks);
    parallelFor(chunks, [&](std::size_t chunk) {
      const std::size_t first = chunk * kChunkSamples;
      const std::size_t count = std::min(kChunkSamples, to.count() - first);
      std::vector<std::byte> scratch(count * sizeof(T));
      const std::byte* bytes = from(first * sizeof(T), count * sizeof(T), scratch.data());
      parts[chunk] = swapBytes ? convertChunk<T, true>(bytes, count, offset, to.data + first)
                               : convertChunk<T, false>(bytes, count, offset, to.data + first);
    });
    WideRange all;
    for (const WideRange& part : parts) all.merge(part);
    return all;
  };
  WideRange seen = pass(0);
  const double offset = chooseValueOffset(seen, std::is_integral_v<T>);
  if (offset != 0) seen = pass(offset);
  return {offset, narrowingNotes(seen, typeName, offset)};
}

/// Shared by both 64-bit integers; 128 bits hold every difference.
template <class T>
float narrowWide(T stored, double offset, WideRange& seen) {
  const auto value = static_cast<double>(stored);
  seen.min = std::min(seen.min, value);
  seen.max = std::max(seen.max, value);
  const __int128 difference = static_cast<__int128>(stored) - static_cast<__int128>(offset);
  const auto narrow = static_cast<float>(difference);
  seen.rounded |= static_cast<__int128>(narrow) != difference;
  return narrow;
}

}  // namespace

std::string_view sampleTypeName(SampleType type) { return kTypes[static_cast<std::size_t>(type)].name; }

std::optional<SampleType> sampleTypeNamed(std::string_view name) {
  for (const TypeRow& row : kTypes)
    if (row.name == name) return row.type;
  return std::nullopt;
}

std::size_t bytesPerSample(SampleType type) { return kTypes[static_cast<std::size_t>(type)].bytes; }

void WideRange::merge(const WideRange& other) {
  min = std::min(min, other.min);
  max = std::max(max, other.max);
  rounded |= other.rounded;
  tooLarge += other.tooLarge;
}

float narrowSample(double stored, double offset, WideRange& seen) {
  const double value = stored - offset;
  const auto narrow = static_cast<float>(value);
  if (std::isfinite(narrow)) {
    seen.min = std::min(seen.min, stored);
    seen.max = std::max(seen.max, stored);
    seen.rounded |= static_cast<double>(narrow) != value;
  } else if (std::isfinite(stored)) {
    ++seen.tooLarge;
  }
  return narrow;
}

float narrowSample(std::int64_t stored, double offset, WideRange& seen) { return narrowWide(stored, offset, seen); }
float narrowSample(std::uint64_t stored, double offset, WideRange& seen) { return narrowWide(stored, offset, seen); }

double chooseValueOffset(const WideRange& seen, bool integers) {
  constexpr double kNeededSteps = 65536;
  constexpr double kFloatStep = std::numeric_limits<float>::epsilon();  // relative size of one step of float32
  const double extent = seen.max - seen.min;
  const double largest = std::max(std::abs(seen.min), std::abs(seen.max));
  if (!seen.rounded || extent == 0 || largest * kFloatStep * kNeededSteps <= extent) return 0;
  const double middle = seen.min + extent / 2;
  return integers ? std::round(middle) : middle;
}

std::vector<std::string> narrowingNotes(const WideRange& seen, std::string_view type, double offset) {
  std::vector<std::string> notes;
  if (offset != 0)
    notes.push_back(
        fmt::format("{} samples are kept as float32 differences from {}, since float32 alone would lose "
                    "their variation",
                    type, offset));
  if (seen.rounded) notes.push_back(fmt::format("{} samples are rounded to float32", type));
  if (seen.tooLarge > 0)
    notes.push_back(
        fmt::format("{} {} samples are beyond the range of float32 and count as infinite", seen.tooLarge, type));
  return notes;
}

ConvertedSamples convertSamples(const SampleBytes& from, SampleType type, bool swapBytes, GridView<float> to) {
  const std::string_view name = sampleTypeName(type);
  switch (type) {
    case SampleType::uint8:
      return convertAll<std::uint8_t>(from, name, swapBytes, to);
    case SampleType::int8:
      return convertAll<std::int8_t>(from, name, swapBytes, to);
    case SampleType::uint16:
      return convertAll<std::uint16_t>(from, name, swapBytes, to);
    case SampleType::int16:
      return convertAll<std::int16_t>(from, name, swapBytes, to);
    case SampleType::uint32:
      return convertAll<std::uint32_t>(from, name, swapBytes, to);
    case SampleType::int32:
      return convertAll<std::int32_t>(from, name, swapBytes, to);
    case SampleType::uint64:
      return convertAll<std::uint64_t>(from, name, swapBytes, to);
    case SampleType::int64:
      return convertAll<std::int64_t>(from, name, swapBytes, to);
    case SampleType::float32:
      return convertAll<float>(from, name, swapBytes, to);
    case SampleType::float64:
      return convertAll<double>(from, name, swapBytes, to);
  }
  return {};
}

}  // namespace isolume
