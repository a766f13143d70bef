#include "src/compare/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <glm/common.hpp>
#include <string>

#include "src/compare/color_map.h"
#include "src/compare/glyphs.h"
#include "src/io/srgb.h"

namespace isolume {
namespace {

/// Layout of the strip below the picture, in units of ScaleBar::zoom pixels.
constexpr int kMargin = 6, kBarHeight = 10, kTickLength = 3, kGap = 2;
constexpr int kStripHeight = kMargin + kBarHeight + kTickLength + kGap + kGlyphHeight + kMargin;
/// Room for three numbers of the longest kind, "-1.23e-05", and gaps between them.
constexpr int kMinWidth = 200;
/// Pictures get a scale bar of twice the size for every so many pixels of width, so that it stays readable when they
/// are shown small.
constexpr int kWidthPerZoom = 400;
constexpr int kTicks = 5;

glm::vec3 linearOf(std::uint32_t shade) {
  const auto channel = [shade](int shift) {
    return linearFromSrgb(static_cast<float>((shade >> shift) & 0xff) / 255.0f);
  };
  return {channel(16), channel(8), channel(0)};
}

class Canvas {
 public:
  explicit Canvas(glm::ivec2 size) {
    image_.size = size;
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    for (const char* name : {"R", "G", "B"}) image_.channels.push_back({name, std::vector<float>(count)});
    fill({0, 0}, size, linearOf(kPageShade));
  }
  void set(glm::ivec2 p, glm::vec3 color) {
    const std::size_t i =
        static_cast<std::size_t>(p.y) * static_cast<std::size_t>(image_.size.x) + static_cast<std::size_t>(p.x);
    for (int c = 0; c < 3; ++c) image_.channels[static_cast<std::size_t>(c)].values[i] = color[c];
  }
  /// A rectangle, cut at the border.
  void fill(glm::ivec2 low, glm::ivec2 size, glm::vec3 color) {
    const glm::ivec2 start = glm::max(low, glm::ivec2(0)), end = glm::min(low + size, image_.size);
    for (int y = start.y; y < end.y; ++y)
      for (int x = start.x; x < end.x; ++x) set({x, y}, color);
  }
  Image take() { return std::move(image_); }

 private:
  Image image_;
};

void drawText(Canvas& canvas, std::string_view text, glm::ivec2 low, int zoom) {
  for (std::size_t i = 0; i < text.size(); ++i)
    for (int y = 0; y < kGlyphHeight; ++y)
      for (int x = 0; x < kGlyphWidth; ++x)
        if (glyphInk(text[i], x, y))
          canvas.fill(low + zoom * glm::ivec2(static_cast<int>(i) * kGlyphAdvance + x, y), glm::ivec2(zoom),
                      linearOf(kInkShade));
}

/// Column of the bar, from its left end, at a tick: 0 at the first, size - 1 at the last.
int tickColumn(const ScaleBar& bar, int tick) { return (bar.size.x - 1) * tick / (kTicks - 1); }

void drawScaleBar(Canvas& canvas, const ScaleBar& bar, double range) {
  canvas.fill(bar.low - 1, bar.size + 2, linearOf(kInkShade));
  for (int x = 0; x < bar.size.x; ++x) {
    const double t = bar.size.x == 1 ? 0 : 2.0 * x / (bar.size.x - 1) - 1;
    canvas.fill(bar.low + glm::ivec2(x, 0), {1, bar.size.y}, divergingColor(t));
  }
  for (int tick = 0; tick < kTicks; ++tick)
    canvas.fill(bar.low + glm::ivec2(tickColumn(bar, tick), bar.size.y), {1, kTickLength * bar.zoom},
                linearOf(kInkShade));
  const std::string labels[] = {fmt::format("{:.3g}", -range), "0", fmt::format("{:+.3g}", range)};
  for (int i = 0; i < 3; ++i) {
    const int width = textWidth(labels[i]) * bar.zoom;
    const int centred = bar.low.x + tickColumn(bar, i * (kTicks - 1) / 2) - width / 2;
    const int left = std::clamp(centred, bar.zoom, bar.canvas.x - bar.zoom - width);
    drawText(canvas, labels[i], {left, bar.textTop}, bar.zoom);
  }
}

glm::vec3 pixelColor(double difference, std::uint8_t pixel, double range) {
  if (pixel & kNotFinite) return linearOf(kFaultShade);
  if (pixel == kCompared) return divergingColor(difference / range);
  return linearOf(pixel == kGotHits ? kGotOnlyShade : pixel == kWantHits ? kWantOnlyShade : kNeitherShade);
}

}  // namespace

double roundUpToOneDigit(double value) {
  assert(value > 0);
  const auto numberOf = [](const std::string& text) {
    double number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
  };
  const std::string nearest = fmt::format("{:.0e}", value);  // one digit, then the exponent
  if (numberOf(nearest) >= value) return numberOf(nearest);
  return numberOf(std::to_string(nearest[0] - '0' + 1) + nearest.substr(1));  // after 9e-03 comes 10e-03
}

double defaultHeatRange(const DifferenceField& difference) {
  constexpr int kNearlyAll = 99, kAll = 100;
  for (const int percent : {kNearlyAll, kAll})
    if (const double magnitude = magnitudePercentile(difference, percent); magnitude > 0)
      return roundUpToOneDigit(magnitude);
  return 1;
}

ScaleBar layOutScaleBar(glm::ivec2 picture) {
  ScaleBar bar;
  bar.zoom = std::max(1, picture.x / kWidthPerZoom);
  bar.canvas = {std::max(picture.x, kMinWidth), picture.y + kStripHeight * bar.zoom};
  bar.low = {kMargin * bar.zoom, picture.y + kMargin * bar.zoom};
  bar.size = {bar.canvas.x - 2 * kMargin * bar.zoom, kBarHeight * bar.zoom};
  bar.textTop = bar.low.y + bar.size.y + (kTickLength + kGap) * bar.zoom;
  return bar;
}

Image drawHeatMap(const DifferenceField& difference, std::span<const std::uint8_t> pixels, double range) {
  assert(range > 0 && pixels.size() == difference.values.size());
  const ScaleBar bar = layOutScaleBar(difference.size);
  Canvas canvas(bar.canvas);
  std::size_t i = 0;
  for (int y = 0; y < difference.size.y; ++y)
    for (int x = 0; x < difference.size.x; ++x, ++i)
      canvas.set({x, y}, pixelColor(difference.values[i], pixels[i], range));
  drawScaleBar(canvas, bar, range);
  return canvas.take();
}

}  // namespace isolume
