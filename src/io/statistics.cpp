#include "statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "sweep/parallel.h"

namespace isolume {
namespace {

/// Fixed, so that sums are formed in the same order on any number of threads.
constexpr std::size_t kChunkSamples = std::size_t{1} << 18;

struct Part {
  std::size_t nanCount = 0, infCount = 0, finiteCount = 0;
  float min = std::numeric_limits<float>::infinity(), max = -std::numeric_limits<float>::infinity();
  double sum = 0;
  std::array<std::size_t, 256> histogram{};
};

template <class Body>
std::vector<Part> forChunks(GridView<const float> values, Body body) {
  std::vector<Part> parts((values.count() + kChunkSamples - 1) / kChunkSamples);
  parallelFor(parts.size(), [&](std::size_t chunk) {
    const float* first = values.data + chunk * kChunkSamples;
    body(parts[chunk], first, first + std::min(kChunkSamples, values.count() - chunk * kChunkSamples));
  });
  return parts;
}

Part summarise(GridView<const float> values) {
  const auto parts = forChunks(values, [](Part& part, const float* first, const float* last) {
    for (const float* v = first; v != last; ++v) {
      if (std::isfinite(*v)) {
        ++part.finiteCount;
        part.min = std::min(part.min, *v);
        part.max = std::max(part.max, *v);
        part.sum += static_cast<double>(*v);
      } else {
        ++(std::isnan(*v) ? part.nanCount : part.infCount);
      }
    }
  });
  Part all;
  for (const Part& part : parts) {
    all.nanCount += part.nanCount;
    all.infCount += part.infCount;
    all.finiteCount += part.finiteCount;
    all.min = std::min(all.min, part.min);
    all.max = std::max(all.max, part.max);
    all.sum += part.sum;
  }
  return all;
}

/// Bin of a finite value: equal bins over [min, max], the last one closed.
std::size_t binOf(double value, double min, double extent) {
  constexpr double kBins = 256;
  return static_cast<std::size_t>(std::min((value - min) / extent * kBins, kBins - 1));
}

/// The border between bins k and k + 1 that separates the histogram into the two classes of largest between-class
/// variance ([Otsu79] Eq. 18); the middle one where several do equally well, so an empty stretch is cut in its middle.
int otsuBorder(const std::array<std::size_t, 256>& histogram) {
  double count = 0, sum = 0;
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    count += static_cast<double>(histogram[i]);
    sum += static_cast<double>(i) * static_cast<double>(histogram[i]);
  }
  double below = 0, sumBelow = 0, best = -1;
  int first = 0, last = 0;
  for (std::size_t i = 0; i + 1 < histogram.size(); ++i) {
    below += static_cast<double>(histogram[i]);
    sumBelow += static_cast<double>(i) * static_cast<double>(histogram[i]);
    const double above = count - below;
    if (below == 0 || above == 0) continue;
    const double apart = sumBelow / below - (sum - sumBelow) / above;
    const double variance = below * above * apart * apart;
    if (variance > best) {
      best = variance;
      first = static_cast<int>(i);
    }
    if (variance == best) last = static_cast<int>(i);
  }
  return (first + last) / 2;
}

}  // namespace

VolumeStatistics computeStatistics(const Volume& volume) {
  const GridView<const float> values = volume.values.view();
  const Part all = summarise(values);
  VolumeStatistics statistics;
  statistics.count = values.count();
  statistics.nanCount = all.nanCount;
  statistics.infCount = all.infCount;
  if (all.finiteCount == 0) return statistics;
  const double min = static_cast<double>(all.min), extent = static_cast<double>(all.max) - min;
  statistics.min = min + volume.valueOffset;
  statistics.max = static_cast<double>(all.max) + volume.valueOffset;
  statistics.mean = all.sum / static_cast<double>(all.finiteCount) + volume.valueOffset;
  if (extent == 0) {
    statistics.histogram[0] = all.finiteCount;
    return statistics;
  }
  const auto parts = forChunks(values, [&](Part& part, const float* first, const float* last) {
    for (const float* v = first; v != last; ++v)
      if (std::isfinite(*v)) ++part.histogram[binOf(static_cast<double>(*v), min, extent)];
  });
  for (const Part& part : parts)
    for (std::size_t i = 0; i < part.histogram.size(); ++i) statistics.histogram[i] += part.histogram[i];
  return statistics;
}

IsovalueChoice defaultIsovalue(const Volume& volume, const VolumeStatistics& statistics) {
  constexpr double kBoolMiddle = 0.5;
  if (volume.kind == GridKind::levelSet) return {0, "0, the surface of a level set"};
  if (volume.sampleType == "bool") return {kBoolMiddle, "0.5, between false and true"};
  if (statistics.min == statistics.max) return {statistics.min, "the only value that there is"};
  const double width = (statistics.max - statistics.min) / static_cast<double>(statistics.histogram.size());
  const double isovalue = statistics.min + width * (otsuBorder(statistics.histogram) + 1);
  return {isovalue, "Otsu's threshold of the histogram, which separates its two classes best"};
}

}  // namespace isolume
