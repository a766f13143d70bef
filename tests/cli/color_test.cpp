// --color-by: from files and options to a coloured picture.
#include <gmock/gmock.h>

#include <cmath>
#include <tuple>

#include "cli/picture.h"
#include "cli/program.h"
#include "src/compare/color_map.h"
#include "src/errors.h"
#include "src/jobs/color_by.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

// writeBall(): value = radius - distance from the middle (7, 7, 7), x first.
constexpr int kBall = 15;
constexpr double kRadius = 5;
constexpr const char* kBallFile = "ball_15x15x15_float32.raw";

class ColoredBall : public ProgramTest {
 protected:
  ColoredBall() { writeBall(path(kBallFile), kBall, kRadius); }

  static std::vector<std::string> command(std::vector<std::string> options, const std::string& output = "out.exr") {
    options.insert(options.begin(), {"render", kBallFile, "--isovalue", "0", "--size", "40x30", "--occlusion", "none",
                                     "--layers", "position,normal,depth", "-o", output});
    return options;
  }
  Image draw(const std::vector<std::string>& options) {
    runWell(command(options));
    return readImage(path("out.exr"));
  }
};

/// Visits pixels that are hit with their colour over that of a grey picture of the same light: the albedo.
template <class Visit>
void forEachAlbedo(const Image& image, const Image& white, const Visit& visit) {
  int hits = 0;
  for (std::size_t i = 0; i < channel(image, "Z").size(); ++i) {
    const float light = channel(white, "G")[i];
    if (!std::isfinite(channel(image, "Z")[i]) || light < 0.1F) continue;
    ++hits;
    visit(i, glm::vec3(channel(image, "R")[i], channel(image, "G")[i], channel(image, "B")[i]) / light);
  }
  EXPECT_GT(hits, 100);
}

TEST_F(ColoredBall, ACoordinateColorsAcrossTheSolid) {
  // x, y and z run over the solid's box, from one end of the map to the other, or over the range that is given. Float
  // colours: 1e-4 of them.
  const Image white = draw({"--albedo", "white"});
  for (const auto& [axis, name] : {std::tuple{"x", "position.X"}, {"y", "position.Y"}, {"z", "position.Z"}}) {
    // Samples inside: 3 to 11 (one at the isovalue is outside); one voxel more on each side.
    const Image image = draw({"--color-by", axis});
    forEachAlbedo(image, white, [&, name = name](std::size_t i, glm::vec3 albedo) {
      const glm::vec3 expected = sequentialColor((channel(image, name)[i] - 2) / 10);
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(albedo[c], expected[c], 2e-4);
    });
  }
  const Image range = draw({"--color-by", "z", "--color-range", "-4.5,11.25", "--color-map", "diverging"});
  forEachAlbedo(range, white, [&](std::size_t i, glm::vec3 albedo) {
    const glm::vec3 expected = divergingColor(2 * (channel(range, "position.Z")[i] + 4.5) / 15.75 - 1);
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(albedo[c], expected[c], 1e-3);  // its steepest part is ten times steeper
  });
}

TEST_F(ColoredBall, AnotherFileColorsWhereItLies) {
  // A second volume is read where its own file puts it: a ball of the same size moved by its origin is brightest, on a
  // grey map, where its middle is next.
  const Image white = draw({"--albedo", "white"});
  std::string header =
      "ObjectType = Image\nNDims = 3\nDimSize = 15 15 15\nElementType = MET_FLOAT\nElementSpacing = 2 2 2\n"
      "Offset = 0 -4 1\nElementDataFile = other.raw\n";
  writeBytes(path("other.mhd"), header);
  writeBall(path("other.raw"), kBall, 30);  // 30 - distance in voxels of 2 from world (14, 10, 15)
  const Image image = draw({"--color-by", "other.mhd", "--color-map", "grey", "--color-range", "20,30"});
  forEachAlbedo(image, white, [&](std::size_t i, glm::vec3 albedo) {
    const double distance = std::hypot(channel(image, "position.X")[i] - 14, channel(image, "position.Y")[i] - 10,
                                       channel(image, "position.Z")[i] - 15) /
                            2;
    const double share = (10 - distance) / 10, linear = std::pow((share + 0.055) / 1.055, 2.4);
    // Distances bend between samples: by at most 1 / (8 distance) voxel per axis.
    ASSERT_NEAR(albedo.g, linear, 0.03) << distance;
  });
  EXPECT_THAT(metadata(image, "isolume:settings"),
              HasSubstr("--color-by other.mhd --color-range 20,30 --color-map grey"));
  EXPECT_THAT(metadata(image, "isolume:input_sha256"), HasSubstr("other.raw"));
}

TEST_F(ColoredBall, MetadataDrawsThePictureAgain) {
  // A range that was found in the data is written as it was used: the options give the picture to the last bit.
  const Image first = draw({"--color-by", kBallFile, "--color-map", "diverging"});
  std::vector<std::string> again{"render", kBallFile, "--isovalue", "0", "-o", "again.exr"};
  for (const char* key : {"isolume:camera", "isolume:settings"})
    for (const std::string& word : words(metadata(first, key))) again.push_back(word);
  runWell(again);
  EXPECT_TRUE(sameBits(first, readImage(path("again.exr")))) << metadata(first, "isolume:settings");
}

TEST_F(ColoredBall, WhatCannotColorIsRefused) {
  // One line, the right exit code, and nothing is written.
  std::string flat(15 * 15 * 15 * sizeof(float), '\0');
  writeBytes(path("flat_15x15x15_float32.raw"), flat);
  writeBytes(path("far.mhd"),
             "ObjectType = Image\nNDims = 3\nDimSize = 15 15 15\nElementType = MET_FLOAT\nElementSpacing = 1 1 1\n"
             "Offset = 100 0 0\nElementDataFile = " +
                 std::string(kBallFile) + "\n");
  for (const auto& [options, code, message] :
       {std::tuple{std::vector<std::string>{"--color-range", "0,1"}, 2, "--color-range: expected --color-by beside it"},
        {{"--color-map", "grey"}, 2, "--color-map: expected --color-by beside it"},
        {{"--color-grid", "a"}, 2, "--color-grid: expected --color-by beside it"},
        {{"--color-by", "x", "--color-grid", "a"}, 2, "--color-grid: expected a file to colour by"},
        {{"--color-by", "x", "--color-range", "1,1"}, 2, "--color-range: expected LOW below HIGH, found 1,1"},
        {{"--color-by", "x", "--color-range", "1"}, 2, "--color-range: expected two numbers"},
        {{"--color-by", "x", "--color-range", "nan,1"}, 2, "--color-range"},
        {{"--color-by", "x", "--color-map", "rainbow"}, 2, "expected one of sequential, diverging, grey"},
        {{"--color-by", "missing.nrrd"}, 3, "missing.nrrd"},
        {{"--color-by", "flat_15x15x15_float32.raw"}, 3, "expected values that differ, or a --color-range"},
        {{"--color-by", "far.mhd"}, 3, "far.mhd: expected a field that reaches the surface"}}) {
    const Outcome outcome = run(command(options, "none.exr"));
    EXPECT_EQ(outcome.exitCode, code) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_THAT(files(), ::testing::Not(::testing::Contains("none.exr")));
  }
  const Outcome bounces =
      run({"render", kBallFile, "--isovalue", "0", "-o", "none.exr", "--color-by", "x", "--bounces", "1"});
  EXPECT_EQ(bounces.exitCode, 2);
  EXPECT_THAT(bounces.err, HasSubstr("--bounces: expected a surface of one albedo, found --color-by"));
}

}  // namespace
}  // namespace isolume::test
