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
  /// Key, value. Keys: 1 to 79 printable ASCII characters without space at either end, and best of the form
  /// "isolume:command", since an EXR gives some plain names ("compression", "owner") a meaning of its own. Values:
  /// UTF-8.
  std::vector<std::pair<std::string, std::string>> metadata;
};

/// By the ending: .png (sRGB, bitDepth 8 or 16, colour channels only; anything else is a UsageError) or .exr (float32,
/// all channels, zip-compressed). Written atomically. OutputError on failure. Every pair of metadata is stored in
/// either format, or it is a std::logic_error. PNG stores straight alpha: colour is divided by A while still linear.
/// The same image gives the same bytes, for any number of threads.
struct ImageWriteOptions {
  int bitDepth = 8;
};
void writeImage(const std::string& path, const Image& image, const ImageWriteOptions& options = {});

/// Throws what writeImage would throw for such a file and channels, before minutes of work; writes nothing.
void checkImageTarget(const std::string& path, const std::vector<std::string>& channelNames,
                      const ImageWriteOptions& options = {});

/// All channels of a PNG or EXR file as float, with its metadata: for tests and later comparisons. The inverse of
/// writeImage: colour of a PNG is made linear and premultiplied. InputError on failure.
Image readImage(const std::string& path);

}  // namespace isolume
