#include "image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "image_codec.h"
#include "output_file.h"
#include "png_text.h"
#include "src/errors.h"
#include "srgb.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

ImageFormat formatOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".png") return ImageFormat::png;
  if (ending == ".exr") return ImageFormat::exr;
  throw UsageError(fmt::format("{}: expected a name that ends in .png or .exr, found {}", path,
                               ending.empty() ? "no ending" : ending));
}

ImageFormat checkedFormat(const std::string& path, const std::vector<std::string>& names, int bitDepth) {
  const ImageFormat format = formatOf(path);
  if (format == ImageFormat::exr) return format;
  if (bitDepth != 8 && bitDepth != 16)
    throw UsageError(fmt::format("{}: expected a PNG bit depth of 8 or 16, found {}", path, bitDepth));
  const std::vector<std::string> rgb{"R", "G", "B"}, rgba{"R", "G", "B", "A"};
  if (names != rgb && names != rgba)
    throw UsageError(
        fmt::format("{}: expected the channels R, G, B or R, G, B, A, which are all that a PNG holds, found {}", path,
                    fmt::join(names, ", ")));
  return format;
}

std::vector<std::string> channelNames(const Image& image) {
  std::vector<std::string> names;
  for (const ImageChannel& channel : image.channels) names.push_back(channel.name);
  return names;
}

// Colour of a premultiplied channel without its alpha; nothing shows where alpha is 0.
float straight(float premultiplied, float alpha) { return alpha > 0 ? premultiplied / alpha : 0.0f; }

// v in [0, 1] to the nearest of the 2^bits - 1 steps.
template <class Integer>
Integer quantized(float v) {
  constexpr float kMax = static_cast<float>(static_cast<Integer>(-1));
  return static_cast<Integer>(v * kMax + 0.5f);
}

template <class Integer>
void fillPngSamples(const Image& image, RawImage& raw) {
  const std::size_t width = static_cast<std::size_t>(image.size.x), channels = image.channels.size();
  const bool hasAlpha = channels == 4;
  raw.samples.resize(width * static_cast<std::size_t>(image.size.y) * channels * sizeof(Integer));
  parallelFor(static_cast<std::size_t>(image.size.y), [&](std::size_t row) {
    for (std::size_t pixel = row * width; pixel < (row + 1) * width; ++pixel) {
      const float a = hasAlpha ? image.channels[3].values[pixel] : 1.0f;
      const float alpha = a > 0 ? std::min(a, 1.0f) : 0.0f;  // NaN counts as 0
      for (std::size_t c = 0; c < channels; ++c) {
        const float v = c == 3 ? alpha : srgbFromLinear(straight(image.channels[c].values[pixel], alpha));
        const Integer code = quantized<Integer>(v);
        std::memcpy(raw.samples.data() + (pixel * channels + c) * sizeof code, &code, sizeof code);
      }
    }
  });
}

void fillFloatSamples(const Image& image, RawImage& raw) {
  const std::size_t pixels = image.channels.front().values.size(), channels = image.channels.size();
  raw.samples.resize(pixels * channels * sizeof(float));
  for (std::size_t c = 0; c < channels; ++c)
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
      std::memcpy(raw.samples.data() + (pixel * channels + c) * sizeof(float), &image.channels[c].values[pixel],
                  sizeof(float));
}

std::string encodePng(const Image& image, RawImage raw, int bitDepth) {
  raw.type = bitDepth == 8 ? SampleType::uint8 : SampleType::uint16;
  bitDepth == 8 ? fillPngSamples<std::uint8_t>(image, raw) : fillPngSamples<std::uint16_t>(image, raw);
  return insertPngText(imageCodec().encode(raw, ImageFormat::png, threadCount()), image.metadata);
}

std::string encodeExr(const Image& image, RawImage raw) {
  raw.metadata = image.metadata;
  fillFloatSamples(image, raw);
  return imageCodec().encode(raw, ImageFormat::exr, threadCount());
}

void requireWholeChannels(const Image& image) {
  assert(image.size.x > 0 && image.size.y > 0 && !image.channels.empty());
  for ([[maybe_unused]] const ImageChannel& channel : image.channels)
    assert(channel.values.size() == static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y));
}

}  // namespace

void checkImageTarget(const std::string& path, const std::vector<std::string>& names,
                      const ImageWriteOptions& options) {
  checkedFormat(path, names, options.bitDepth);
  checkWritable(path);
}

void writeImage(const std::string& path, const Image& image, const ImageWriteOptions& options) {
  const ImageFormat format = checkedFormat(path, channelNames(image), options.bitDepth);
  requireWholeChannels(image);
  std::string bytes;
  try {
    RawImage raw{image.size, SampleType::float32, channelNames(image), {}, {}};
    bytes = format == ImageFormat::png ? encodePng(image, std::move(raw), options.bitDepth)
                                       : encodeExr(image, std::move(raw));
  } catch (const std::runtime_error& error) {
    throw OutputError(fmt::format("{}: cannot encode the image: {}", path, error.what()));
  }
  writeFileAtomically(path, bytes);
}

}  // namespace isolume
