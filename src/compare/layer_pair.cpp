#include "src/compare/layer_pair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "src/errors.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

const ImageChannel* findChannel(const Image& image, std::string_view name) {
  for (const ImageChannel& channel : image.channels)
    if (channel.name == name) return &channel;
  return nullptr;
}

bool belongsTo(std::string_view channel, std::string_view layer) {
  if (channel == layer) return true;
  return channel.size() > layer.size() + 1 && channel.starts_with(layer) && channel[layer.size()] == '.' &&
         channel.find('.', layer.size() + 1) == channel.npos;
}

std::vector<std::string> channelsOf(const NamedImage& picture, const std::string& layer) {
  if (findChannel(picture.image, layer)) return {layer};
  std::vector<std::string> names, all;
  for (const ImageChannel& channel : picture.image.channels) {
    all.push_back(channel.name);
    if (belongsTo(channel.name, layer)) names.push_back(channel.name);
  }
  if (names.empty())
    throw InputError(fmt::format("{}: expected a layer or channel '{}', found the channels {}", picture.file, layer,
                                 fmt::join(all, ", ")));
  return names;
}

/// What LayerPair::vector says.
std::string vectorOf(const NamedImage& picture, const std::string& channel) {
  if (channel.starts_with("stderr.")) return {};
  const std::string layer = channel.substr(0, channel.rfind('.'));
  std::vector<std::string> names = channelsOf(picture, layer);
  std::sort(names.begin(), names.end());
  return names == std::vector<std::string>{layer + ".X", layer + ".Y", layer + ".Z"} ? layer : "";
}

LayerKind kindOf(const std::string& layer, const std::string& vector) {
  if (vector.empty() || layer != vector) return LayerKind::values;
  return layer == "position" ? LayerKind::position : LayerKind::direction;
}

struct Hits {
  std::string from;
  std::vector<std::uint8_t> hit;  ///< 0 or 1
};

Hits hitsOf(const NamedImage& picture) {
  const Image& image = picture.image;
  const auto pixels = static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y);
  std::vector<std::uint8_t> hit(pixels);
  if (const ImageChannel* depth = findChannel(image, "Z")) {
    for (std::size_t i = 0; i < pixels; ++i) hit[i] = depth->values[i] != std::numeric_limits<float>::infinity();
    return {"Z", std::move(hit)};
  }
  const ImageChannel *x = findChannel(image, "position.X"), *y = findChannel(image, "position.Y"),
                     *z = findChannel(image, "position.Z");
  if (x && y && z) {
    for (std::size_t i = 0; i < pixels; ++i)
      hit[i] = !(std::isnan(x->values[i]) && std::isnan(y->values[i]) && std::isnan(z->values[i]));
    return {"position", std::move(hit)};
  }
  if (const ImageChannel* alpha = findChannel(image, "A")) {
    for (std::size_t i = 0; i < pixels; ++i) hit[i] = alpha->values[i] >= 0.5f;
    if (std::find(hit.begin(), hit.end(), 0) != hit.end()) return {"A", std::move(hit)};
    throw InputError(
        fmt::format("{}: expected channels Z or position.X .Y .Z, which tell where something is hit, found "
                    "only A, opaque everywhere",
                    picture.file));
  }
  throw InputError(fmt::format(
      "{}: expected channels Z, position.X .Y .Z or A, which tell where something is hit, found none", picture.file));
}

/// The faults of a row of pixels.
struct RowFaults {
  std::size_t nan = 0, infinite = 0;
  int firstX = -1;
  bool firstInGot = false;
};

RowFaults markFaults(LayerPair& pair, std::size_t row) {
  RowFaults faults;
  const auto width = static_cast<std::size_t>(pair.size.x);
  for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
    const auto look = [&](float value, PixelBit hits) {
      if (!(pair.pixels[i] & hits) || std::isfinite(value)) return;
      ++(std::isnan(value) ? faults.nan : faults.infinite);
      pair.pixels[i] |= kNotFinite;
      if (faults.firstX >= 0) return;
      faults.firstX = static_cast<int>(i - row * width);
      faults.firstInGot = hits == kGotHits;
    };
    for (const ChannelPair& channel : pair.channels) look(channel.got[i], kGotHits);
    for (const ChannelPair& channel : pair.channels) look(channel.want[i], kWantHits);
  }
  return faults;
}

std::string cameraOf(const Image& image) {
  for (const auto& [key, value] : image.metadata)
    if (key == "isolume:camera") return value;
  return {};
}

void findFaults(LayerPair& pair) {
  std::vector<RowFaults> rows(static_cast<std::size_t>(pair.size.y));
  parallelFor(rows.size(), [&](std::size_t row) { rows[row] = markFaults(pair, row); });
  Faults& faults = pair.faults;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows[row].firstX >= 0 && faults.firstFile.empty()) {
      faults.firstFile = rows[row].firstInGot ? pair.gotFile : pair.wantFile;
      faults.firstPixel = {rows[row].firstX, static_cast<int>(row)};
    }
    faults.nan += rows[row].nan;
    faults.infinite += rows[row].infinite;
  }
}

void checkStandardErrors(const LayerPair& pair) {
  const auto width = static_cast<std::size_t>(pair.size.x);
  for (const ChannelPair& channel : pair.channels)
    for (std::size_t i = 0; i < channel.standardError.size(); ++i) {
      const float error = channel.standardError[i];
      if (pair.pixels[i] != kCompared || (std::isfinite(error) && error >= 0)) continue;
      throw InputError(
          fmt::format("{}: stderr.{}: expected finite values of at least 0 where something is hit, found {} at pixel "
                      "({}, {})",
                      pair.wantFile, channel.name, error, i % width, i / width));
    }
}

}  // namespace

LayerPair pairLayer(const std::string& layer, const NamedImage& got, const NamedImage& want) {
  return pairLayers(layer, layer, got, want);
}

LayerPair pairLayers(const std::string& layer, const std::string& wantLayer, const NamedImage& got,
                     const NamedImage& want) {
  if (got.image.size != want.image.size)
    throw InputError(fmt::format("{}: expected {} x {} pixels as in {}, found {} x {}", got.file, want.image.size.x,
                                 want.image.size.y, want.file, got.image.size.x, got.image.size.y));
  const std::vector<std::string> names = channelsOf(want, wantLayer), gotNames = channelsOf(got, layer);
  const bool alike = layer == wantLayer;
  if (alike && !std::is_permutation(names.begin(), names.end(), gotNames.begin(), gotNames.end()))
    throw InputError(fmt::format("{}: layer '{}': expected the channels {} as in {}, found {}", got.file, layer,
                                 fmt::join(names, ", "), want.file, fmt::join(gotNames, ", ")));
  if (!alike && (names.size() != 1 || gotNames.size() != 1))
    throw InputError(fmt::format("{}: layer '{}': expected one channel to compare with another of {}, found {} and {}",
                                 got.file, layer, want.file, fmt::join(gotNames, ", "), fmt::join(names, ", ")));
  const std::string vector = vectorOf(want, names.front());
  LayerPair pair{wantLayer, kindOf(wantLayer, vector), vector, want.image.size, got.file, want.file, {}, {}, {}, {}, {},
                 {}};
  for (const std::string& name : names) {
    const ImageChannel* error = findChannel(want.image, "stderr." + name);
    pair.channels.push_back({name, findChannel(got.image, alike ? name : gotNames.front())->values,
                             findChannel(want.image, name)->values, error ? error->values : std::vector<float>()});
  }
  Hits gotHits = hitsOf(got), wantHits = hitsOf(want);
  pair.gotHitsFrom = gotHits.from;
  pair.wantHitsFrom = wantHits.from;
  pair.pixels = std::move(gotHits.hit);
  for (std::size_t i = 0; i < pair.pixels.size(); ++i) {
    const bool gotHit = pair.pixels[i] != 0, wantHit = wantHits.hit[i] != 0;
    pair.pixels[i] = static_cast<std::uint8_t>((gotHit ? kGotHits : 0) | (wantHit ? kWantHits : 0));
  }
  const std::string gotCamera = cameraOf(got.image), wantCamera = cameraOf(want.image);
  if (!gotCamera.empty() && !wantCamera.empty() && gotCamera != wantCamera)
    pair.notes.push_back("taken by different cameras, as their metadata say (isolume:camera)");
  findFaults(pair);
  checkStandardErrors(pair);
  return pair;
}

}  // namespace isolume
