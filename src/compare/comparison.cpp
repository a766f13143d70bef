#include "src/compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/compare/ssim.h"
#include "src/errors.h"

namespace isolume {
namespace {

PixelCounts countPixels(const LayerPair& pair) {
  PixelCounts counts;
  counts.all = pair.pixels.size();
  for (const std::uint8_t pixel : pair.pixels) {
    const bool got = pixel & kGotHits, want = pixel & kWantHits;
    counts.both += got && want;
    counts.gotOnly += got && !want;
    counts.wantOnly += !got && want;
    counts.compared += pixel == kCompared;
  }
  return counts;
}

/// The L of structural similarity: see the header.
double similarityRange(const LayerPair& pair) {
  if (pair.layer != "Z" && pair.vector != "position") return pair.vector.empty() ? 1 : 2;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ChannelPair& channel : pair.channels)
    for (std::size_t i = 0; i < pair.pixels.size(); ++i) {
      if (pair.pixels[i] != kCompared) continue;
      low = std::min(low, static_cast<double>(channel.want[i]));
      high = std::max(high, static_cast<double>(channel.want[i]));
    }
  return high > low ? high - low : 1;
}

std::optional<double> meanSimilarity(const LayerPair& pair) {
  std::vector<std::uint8_t> compared(pair.pixels.size());
  std::transform(pair.pixels.begin(), pair.pixels.end(), compared.begin(),
                 [](std::uint8_t pixel) { return pixel == kCompared; });
  const double range = similarityRange(pair);
  double sum = 0;
  for (const ChannelPair& channel : pair.channels) {
    const std::optional<double> ssim = structuralSimilarity(pair.size, channel.got, channel.want, compared, range);
    if (!ssim) return std::nullopt;
    sum += *ssim;
  }
  return sum / static_cast<double>(pair.channels.size());
}

NamedMeasures named(const DifferenceField& difference) {
  return {difference.name, difference.unit, measure(difference), {}, {}};
}

NamedMeasures channelMeasures(const LayerPair& pair, const ChannelPair& channel) {
  NamedMeasures result = named(channelDifference(pair, channel));
  result.noise = referenceNoise(pair, channel);
  const double rmse = result.measures.rmse;
  if (result.noise) result.rmseWithoutNoise = std::sqrt(std::max(0.0, rmse * rmse - *result.noise * *result.noise));
  return result;
}

}  // namespace

double PixelCounts::miss() const {
  const std::size_t one = gotOnly + wantOnly;
  return one == 0 ? 0 : static_cast<double>(one) / static_cast<double>(one + both);
}

Comparison compareLayer(const LayerPair& pair) {
  Comparison comparison{pair.layer, pair.gotFile,        pair.wantFile, pair.gotHitsFrom, pair.wantHitsFrom,
                        pair.size,  countPixels(pair),   pair.faults,   pair.notes,       {},
                        0,          meanSimilarity(pair)};
  if (pair.kind != LayerKind::values) comparison.measures.push_back(named(vectorDifference(pair)));
  for (const ChannelPair& channel : pair.channels) comparison.measures.push_back(channelMeasures(pair, channel));
  comparison.limitedMeasures = pair.kind == LayerKind::values ? comparison.measures.size() : 1;
  return comparison;
}

DifferenceField shownDifference(const LayerPair& pair) {
  if (pair.kind != LayerKind::values) return vectorDifference(pair);
  if (pair.channels.size() == 1) return channelDifference(pair, pair.channels.front());
  throw UsageError(
      fmt::format("--heat: expected a vector or a layer of one channel, such as --layer {}, found {} channels",
                  pair.channels.front().name, pair.channels.size()));
}

}  // namespace isolume
