// One layer of two pictures, pixel beside pixel, and which pixels can be compared.
//
// A layer is a channel with exactly that name ("Z", "ambient.Y") or all channels "LAYER.x" with one more part
// ("normal": normal.X, normal.Y, normal.Z). Both files must have the same channels of it and the same size.
//
// Whether a pixel shows a surface is told by each file by itself, from the first of these that it holds:
//   Z           hit unless +inf, which is how a miss is written (a NaN counts as a hit, so that it is found as a
//   fault); position    hit unless all three components are NaN; A           hit where A >= 1/2: exact with one sample
//   per pixel; refused if A >= 1/2 everywhere, since that is also
//               what an opaque background gives.
// A pixel is compared if both hit and every channel of the layer is finite in both. NaN or infinity where its own file
// hits is a fault, which is counted; where it misses, values mean nothing and are not looked at. The standard errors
// that `isolume reference` writes beside a layer ("stderr." + channel) are taken from WANT where it has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "src/io/image.h"

namespace isolume {

enum class LayerKind {
  values,     ///< every channel counts for itself
  direction,  ///< X, Y, Z of a vector of which the direction matters: normals, bent normals
  position,   ///< X, Y, Z of a point, world units: the layer `position`
};

/// What is known of a pixel; bits.
enum PixelBit : std::uint8_t { kGotHits = 1, kWantHits = 2, kNotFinite = 4 };
constexpr std::uint8_t kCompared = kGotHits | kWantHits;  ///< the pixels that are compared: exactly these bits

struct ChannelPair {
  std::string name;
  std::vector<float> got, want;
  std::vector<float> standardError;  ///< of `want`; empty if the file has none
};

/// Values that are no numbers where something is hit.
struct Faults {
  std::size_t nan = 0, infinite = 0;  ///< over the pixels, channels and both files
  std::string firstFile;              ///< where the first is, in row-major order
  glm::ivec2 firstPixel{0};
};

struct LayerPair {
  std::string layer;
  LayerKind kind = LayerKind::values;
  /// The layer of X, Y and Z in WANT that the channels are of, also if the layer is but one of them: "normal" for
  /// normal and normal.X. "" otherwise: ambient.Y stands alone, its Y is that of luminance.
  std::string vector;
  glm::ivec2 size{0};
  std::string gotFile, wantFile;
  std::string gotHitsFrom, wantHitsFrom;  ///< "Z", "position" or "A"
  std::vector<ChannelPair> channels;      ///< in WANT's order
  std::vector<std::uint8_t> pixels;       ///< PixelBit; row-major, top row first
  Faults faults;
  std::vector<std::string> notes;  ///< for the user: that the cameras differ (metadata isolume:camera)
};

struct NamedImage {
  std::string file;
  const Image& image;
};

/// InputError if the sizes differ, a file lacks the layer or what tells its hits, the files hold different channels of
/// it, or a standard error is not finite or below 0 at a pixel that is compared. O(pixels).
LayerPair pairLayer(const std::string& layer, const NamedImage& got, const NamedImage& want);
/// The same for a channel that has another name in WANT: `irradiance.G` against `ambient.Y`. InputError also where either
/// layer is more than one channel.
LayerPair pairLayers(const std::string& layer, const std::string& wantLayer, const NamedImage& got,
                     const NamedImage& want);

}  // namespace isolume
