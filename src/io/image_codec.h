// OpenImageIO behind a plain interface, loaded at run time.
//
// Debian's OpenImageIO depends on 260 shared libraries, and linking them took 0.3 s of every start of the program, even
// of `--help`. So the code that calls it is a module of its own (isolume_image_codec.so, found relative to the
// program), which is loaded when it is first needed, or ahead of that and beside other work by preloadImageCodec().
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isolume {

enum class ImageFormat { png, exr };
enum class SampleType { uint8, uint16, float32 };

/// Samples as they are stored in a file.
struct RawImage {
  glm::ivec2 size{0};
  SampleType type = SampleType::float32;
  std::vector<std::string> channels;
  std::vector<std::byte> samples;  ///< row-major, top row first, channels interleaved, in the machine's byte order
  std::vector<std::pair<std::string, std::string>> metadata;  ///< EXR alone; a PNG's are the business of png_text.h
};

/// Both throw std::runtime_error with OpenImageIO's message, without the path, which they do not know. Thread-safe.
struct ImageCodec {
  std::string (*encode)(const RawImage& image, ImageFormat format, int threads);
  RawImage (*decode)(std::string_view bytes, ImageFormat format);
};

/// Loads the module on the first call; std::runtime_error that lists where it was looked for.
const ImageCodec& imageCodec();

/// Starts loading in the background and returns at once. A failure is reported by imageCodec().
void preloadImageCodec();

}  // namespace isolume
