// The signed difference of two pictures in colour, with a scale bar below.
//
// A pixel that is compared has divergingColor(difference / range): blue where got < want, near white where they agree,
// orange where got > want; beyond the range the colour of the end. The others have shades that the map does not
// contain: hit by neither dark grey, by got alone light grey, by want alone black; faulty (not finite) magenta. Below,
// on white, the map from -range to +range with ticks at its ends, its quarters and 0, and numbers at -range, 0 and
// +range. The picture keeps its size, at the upper left; one narrower than the bar's numbers leaves white to its right.
#pragma once

#include <cstdint>
#include <span>

#include "src/compare/measures.h"
#include "src/io/image.h"

namespace isolume {

/// sRGB codes of the pixels that are not compared, and of the page.
constexpr std::uint32_t kNeitherShade = 0x505050, kGotOnlyShade = 0xb0b0b0, kWantOnlyShade = 0x000000,
                        kFaultShade = 0xff00ff, kPageShade = 0xffffff, kInkShade = 0x000000;

/// `value` > 0 rounded up to one significant decimal digit: 0.031 to 0.04, 0.3 stays.
double roundUpToOneDigit(double value);

/// A scale that shows nearly everything: the 99th percentile of |difference|, or where that is 0 the maximum, rounded
/// up to one digit; 1 if there is no difference at all.
double defaultHeatRange(const DifferenceField& difference);

/// Where the scale bar lies in the heat map of a picture: its colours, without frame.
struct ScaleBar {
  glm::ivec2 canvas{0};        ///< size of the whole heat map
  glm::ivec2 low{0}, size{0};  ///< upper left pixel, and extent
  int textTop = 0;             ///< first row of the numbers
  int zoom = 1;                ///< pixels per pixel of the font
};
ScaleBar layOutScaleBar(glm::ivec2 picture);

/// R, G, B, for a PNG. `pixels` are those of the LayerPair; range > 0.
Image drawHeatMap(const DifferenceField& difference, std::span<const std::uint8_t> pixels, double range);

}  // namespace isolume
