#include <algorithm>
#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>

#include "image.h"
#include "image_codec.h"
#include "png_text.h"
#include "src/errors.h"
#include "srgb.h"

namespace isolume {
namespace {

std::optional<ImageFormat> formatBySignature(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return ImageFormat::png;  // [PNG] 5.2
  if (bytes.starts_with("\x76\x2f\x31\x01")) return ImageFormat::exr;   // OpenEXR file layout, magic number
  return std::nullopt;
}

std::string readFile(const std::string& path) {
  const auto close = [](std::FILE* f) { std::fclose(f); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
  std::string bytes;
  std::array<char, 1 << 16> block;
  while (const std::size_t count = file ? std::fread(block.data(), 1, block.size(), file.get()) : 0)
    bytes.append(block.data(), count);
  if (!file || std::ferror(file.get()))
    throw InputError(fmt::format("{}: cannot read: {}", path, std::strerror(errno)));
  return bytes;
}

float sampleAt(const RawImage& raw, std::size_t index) {
  const auto load = [&](auto value) {
    std::memcpy(&value, raw.samples.data() + index * sizeof value, sizeof value);
    return value;
  };
  if (raw.type == SampleType::uint8) return static_cast<float>(load(std::uint8_t{})) / 255.0f;
  if (raw.type == SampleType::uint16) return static_cast<float>(load(std::uint16_t{})) / 65535.0f;
  return load(0.0f);
}

const ImageChannel* findChannel(const Image& image, std::string_view name) {
  for (const ImageChannel& channel : image.channels)
    if (channel.name == name) return &channel;
  return nullptr;
}

// From what a PNG stores, sRGB and straight, to what Image holds, linear and premultiplied.
void makeLinear(Image& image) {
  const ImageChannel* alpha = findChannel(image, "A");
  for (ImageChannel& channel : image.channels) {
    if (&channel == alpha) continue;
    for (std::size_t i = 0; i < channel.values.size(); ++i)
      channel.values[i] = linearFromSrgb(channel.values[i]) * (alpha ? alpha->values[i] : 1.0f);
  }
}

}  // namespace

Image readImage(const std::string& path) {
  const std::string bytes = readFile(path);
  const std::optional<ImageFormat> format = formatBySignature(bytes);
  if (!format) throw InputError(fmt::format("{}: expected a PNG or EXR image, found neither signature", path));
  RawImage raw;
  try {
    raw = imageCodec().decode(bytes, *format);
  } catch (const std::runtime_error& error) {
    std::string reason = error.what();  // of several lines for some damage; an error is one
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw InputError(fmt::format("{}: cannot decode the image: {}", path, reason));
  }
  Image image{raw.size, {}, *format == ImageFormat::png ? readPngText(bytes) : raw.metadata};
  const std::size_t count = raw.channels.size();
  const std::size_t pixels = static_cast<std::size_t>(raw.size.x) * static_cast<std::size_t>(raw.size.y);
  for (std::size_t c = 0; c < count; ++c) {
    ImageChannel channel{raw.channels[c], std::vector<float>(pixels)};
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) channel.values[pixel] = sampleAt(raw, pixel * count + c);
    image.channels.push_back(std::move(channel));
  }
  if (*format == ImageFormat::png) makeLinear(image);
  return image;
}

}  // namespace isolume
