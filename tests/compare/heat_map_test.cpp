// The picture of the difference.
#include "src/compare/heat_map.h"

#include <gtest/gtest.h>

#include <set>

#include "compare/pictures.h"
#include "src/compare/color_map.h"
#include "src/compare/glyphs.h"
#include "src/io/srgb.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

using Code = std::uint32_t;

Code codeOf(glm::vec3 linear) {
  Code code = 0;
  for (int c = 0; c < 3; ++c) code = code << 8 | static_cast<Code>(srgbFromLinear(linear[c]) * 255 + 0.5f);
  return code;
}

/// As a reader of the PNG sees it.
Code codeAt(const Image& image, glm::ivec2 p) {
  const auto i = static_cast<std::size_t>(p.y * image.size.x + p.x);
  return codeOf({image.channels[0].values[i], image.channels[1].values[i], image.channels[2].values[i]});
}

Image heatOf(const Image& got, const Image& want, double range) {
  const LayerPair pair = pairOf(got, want);
  return drawHeatMap(shownDifference(pair), pair.pixels, range);
}

TEST(HeatMap, DifferencesHaveTheColoursOfTheMap) {
  // -R, -R/2, 0, R/2, R and beyond have the map's colours, after a round through a PNG file.
  const std::vector<float> values{-0.5f, -0.25f, 0, 0.25f, 0.5f, 4, -4};
  const Image zero = picture({7, 1}, std::vector<float>(7));
  const TempFolder folder;
  writeImage(folder.path("heat.png"), heatOf(picture({7, 1}, values), zero, 0.5));
  const Image heat = readImage(folder.path("heat.png"));
  const double positions[] = {-1, -0.5, 0, 0.5, 1, 1, -1};
  for (int x = 0; x < 7; ++x) EXPECT_EQ(codeAt(heat, {x, 0}), codeOf(divergingColor(positions[x]))) << x;
}

TEST(HeatMap, OtherPixelsHaveShadesOfTheirOwn) {
  // Hit by neither, by one alone, faulty: four shades, all different, and none on the scale.
  Image got = picture({5, 1}, {0, 0, 0, 0, kNan}), want = picture({5, 1}, std::vector<float>(5));
  channelOf(got, "Z") = {1, 1, kInf, kInf, 1};
  channelOf(want, "Z") = {1, kInf, 1, kInf, 1};
  const Image heat = heatOf(got, want, 1);
  const std::vector<Code> shades{codeAt(heat, {1, 0}), codeAt(heat, {2, 0}), codeAt(heat, {3, 0}),
                                 codeAt(heat, {4, 0})};
  EXPECT_EQ(shades, (std::vector<Code>{kGotOnlyShade, kWantOnlyShade, kNeitherShade, kFaultShade}));
  std::set<Code> all(shades.begin(), shades.end());
  EXPECT_EQ(all.size(), shades.size());
  constexpr int kSteps = 10000;
  for (int i = -kSteps; i <= kSteps; ++i) EXPECT_FALSE(all.contains(codeOf(divergingColor(double(i) / kSteps)))) << i;
}

TEST(HeatMap, ScaleBarRunsFromEndToEnd) {
  // Below the picture the bar goes through the whole map, ends and middle included, with ink under its ticks, whatever
  // the size of the picture.
  for (const glm::ivec2 size : {glm::ivec2{1, 1}, {200, 50}, {512, 512}, {1600, 900}}) {
    const Image zero = picture(size, std::vector<float>(static_cast<std::size_t>(size.x * size.y)));
    const Image heat = heatOf(zero, zero, 0.1);
    const ScaleBar bar = layOutScaleBar(size);
    EXPECT_EQ(heat.size, bar.canvas);
    ASSERT_GE(bar.low.y, size.y);
    const glm::ivec2 left = bar.low + glm::ivec2(0, bar.size.y / 2), right = left + glm::ivec2(bar.size.x - 1, 0);
    EXPECT_EQ(codeAt(heat, left), codeOf(divergingColor(-1)));
    EXPECT_EQ(codeAt(heat, right), codeOf(divergingColor(1)));
    const int middle = (bar.size.x - 1) / 2;  // half a column from 0 at most
    EXPECT_EQ(codeAt(heat, left + glm::ivec2(middle, 0)), codeOf(divergingColor(2.0 * middle / (bar.size.x - 1) - 1)));
    for (const int x : {left.x, left.x + middle, right.x})
      EXPECT_EQ(codeAt(heat, {x, bar.low.y + bar.size.y + bar.zoom}), kInkShade);
    EXPECT_EQ(codeAt(heat, heat.size - 1), kPageShade);
  }
}

/// The text that is drawn with its upper left at `low`; letters that are not of the font end it.
std::string textAt(const Image& heat, glm::ivec2 low, int zoom) {
  std::string text;
  for (;; low.x += kGlyphAdvance * zoom) {
    char found = 0;
    for (const char letter : std::string("0123456789+-.e")) {
      bool same = true;
      for (int y = 0; y < kGlyphHeight && same; ++y)
        for (int x = 0; x < kGlyphWidth && same; ++x) {
          const glm::ivec2 p = low + zoom * glm::ivec2(x, y);
          same = p.x < heat.size.x && (codeAt(heat, p) == kInkShade) == glyphInk(letter, x, y);
        }
      if (same) found = letter;
    }
    if (!found) return text;
    text += found;
  }
}

/// All texts in the row of numbers.
std::vector<std::string> labelsOf(const Image& heat, const ScaleBar& bar) {
  std::vector<std::string> labels;
  for (int x = 0; x < heat.size.x; ++x) {
    const std::string text = textAt(heat, {x, bar.textTop}, bar.zoom);
    if (text.empty()) continue;
    labels.push_back(text);
    x += textWidth(text) * bar.zoom;
  }
  return labels;
}

TEST(HeatMap, NumbersCanBeReadOff) {
  // The three numbers below the bar are -R, 0 and +R, for long numbers and for small and large pictures.
  for (const glm::ivec2 size : {glm::ivec2{1, 1}, {300, 20}, {900, 20}}) {
    const Image zero = picture(size, std::vector<float>(static_cast<std::size_t>(size.x * size.y)));
    const ScaleBar bar = layOutScaleBar(size);
    EXPECT_EQ(labelsOf(heatOf(zero, zero, 0.1), bar), (std::vector<std::string>{"-0.1", "0", "+0.1"}));
    EXPECT_EQ(labelsOf(heatOf(zero, zero, 1.234e-7), bar), (std::vector<std::string>{"-1.23e-07", "0", "+1.23e-07"}));
    EXPECT_EQ(labelsOf(heatOf(zero, zero, 6.78e9), bar), (std::vector<std::string>{"-6.78e+09", "0", "+6.78e+09"}));
    EXPECT_EQ(labelsOf(heatOf(zero, zero, 45), bar), (std::vector<std::string>{"-45", "0", "+45"}));
  }
}

TEST(HeatMap, RoundsUpToOneDigit) {
  // The smallest number of one digit that is not below: equal if it has one digit already.
  const std::pair<double, double> cases[] = {{0.3, 0.3},   {0.31, 0.4},    {0.0999, 0.1},  {0.0901, 0.1},
                                             {1, 1},       {1.0001, 2},    {94, 100},      {95.5, 100},
                                             {9e-7, 9e-7}, {9.1e-7, 1e-6}, {8.4e-5, 9e-5}, {8.6e-5, 9e-5}};
  for (const auto& [value, want] : cases) EXPECT_EQ(roundUpToOneDigit(value), want) << value;
}

TEST(HeatMap, DefaultRangeShowsNearlyEverything) {
  // The 99th percentile rounded up; where it is 0 the maximum; 1 for equal pictures.
  std::vector<float> values(200);
  const Image zero = picture({20, 10}, values);
  EXPECT_EQ(defaultHeatRange(shownDifference(pairOf(zero, zero))), 1);
  values[7] = -0.53f;
  EXPECT_EQ(defaultHeatRange(shownDifference(pairOf(picture({20, 10}, values), zero))), 0.6);
  values.assign(200, 0.021f);
  values[7] = values[99] = -0.53f;  // 1 % of the pixels is cut off, ...
  EXPECT_EQ(defaultHeatRange(shownDifference(pairOf(picture({20, 10}, values), zero))), 0.03);
  values[150] = 0.53f;  // ... more is not
  EXPECT_EQ(defaultHeatRange(shownDifference(pairOf(picture({20, 10}, values), zero))), 0.6);
}

}  // namespace
}  // namespace isolume::test
