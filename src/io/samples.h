// Stored samples of any numeric type to float32.
//
// value = stored - valueOffset, rounded to float32. The offset is 0 unless float32 would resolve the range of the
// finite samples in fewer than 65,536 steps (what a 16-bit file has) and rounding would change a sample; it is then the
// middle of the range, a whole number for integers. float64 beyond the range of float32 becomes infinite. O(n),
// threaded over fixed chunks: bitwise the same for any number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/grid.h"

namespace isolume {

enum class SampleType { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };

std::string_view sampleTypeName(SampleType type);  ///< "uint8", ...
std::optional<SampleType> sampleTypeNamed(std::string_view name);
std::size_t bytesPerSample(SampleType type);

/// Gives the bytes [first, first + count) of the samples: a pointer to them, or to `scratch` filled with them (room for
/// one chunk). Called from several threads at once.
using SampleBytes = std::function<const std::byte*(std::size_t first, std::size_t count, std::byte* scratch)>;

struct ConvertedSamples {
  double valueOffset = 0;
  std::vector<std::string> notes;  ///< what was lost, one line each
};

/// Fills `to` from `from`, both in index order. swapBytes: the stored byte order is not this machine's.
ConvertedSamples convertSamples(const SampleBytes& from, SampleType type, bool swapBytes, GridView<float> to);

/// What a pass over samples wider than float32 finds out; ranges of parts are merged in order.
struct WideRange {
  double min = std::numeric_limits<double>::infinity();  ///< of the samples that float32 can hold as finite numbers
  double max = -std::numeric_limits<double>::infinity();
  bool rounded = false;      ///< float32 cannot hold a sample exactly
  std::size_t tooLarge = 0;  ///< finite samples beyond the range of float32
  void merge(const WideRange& other);
};

/// stored - offset as float32, and what that did to it. 64-bit integers are subtracted exactly.
float narrowSample(double stored, double offset, WideRange& seen);
float narrowSample(std::int64_t stored, double offset, WideRange& seen);
float narrowSample(std::uint64_t stored, double offset, WideRange& seen);

/// The offset that the rule above asks for, given what a pass with offset 0 saw.
double chooseValueOffset(const WideRange& seen, bool integers);

/// Notes for Volume::notes after the last pass.
std::vector<std::string> narrowingNotes(const WideRange& seen, std::string_view type, double offset);

}  // namespace isolume
