// Images with named layers and provenance, to PNG and EXR through OpenImageIO.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <utility>
#include <vector>

namespace isolume {

struct ImageChannel {
  std::string name;           ///< "R", "ambient.Y", "normal.X", ...
  std::vector<float> values;  ///< row-major, top row first
};

/// Colour channels R G B (A) are linear and, with A, premultiplied.
struct Image {
  glm::ivec2 size{0};
  std::vector<ImageChannel> channels;
  std::vector<std::pair<std::string, std::string>> metadata;  ///< key, value
};

/// By the ending: .png (sRGB, bitDepth 8 or 16, colour channels only; anything else is a UsageError) or .exr (float32,
/// all channels, zip-compressed). Written atomically. OutputError on failure.
struct ImageWriteOptions {
  int bitDepth = 8;
};
void writeImage(const std::string& path, const Image& image, const ImageWriteOptions& options = {});

/// All channels of an image file as float, with its metadata: for tests and later comparisons. InputError on failure.
Image readImage(const std::string& path);

}  // namespace isolume
