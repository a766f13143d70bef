// What the picture of a known solid holds.
#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "cli/picture.h"
#include "cli/program.h"

namespace isolume::test {
namespace {

using ::testing::ElementsAre;

// A ball of radius 10 voxels about the middle sample of an odd grid, seen along an axis of the grid by a picture with a
// pixel in its very middle: that pixel's ray runs through samples, where the ball's values are linear along it.
constexpr int kBall = 33;
constexpr double kRadius = 10;
constexpr double kCentre = (kBall - 1) / 2.0;
constexpr int kSide = 33;
constexpr std::size_t kMiddle = kSide * kSide / 2;
const std::string kBallFile = "ball_33x33x33_float32.raw";
constexpr double kHitTolerance = 1e-3;  // voxels: what a hit is refined to

class BallPicture : public ProgramTest {
 protected:
  BallPicture() { writeBall(path(kBallFile), kBall, kRadius); }

  /// Seen from -y, 100 voxels in front of the centre, 30 voxels high.
  Image draw(std::vector<std::string> options, const std::string& output = "out.exr") {
    options.insert(options.begin(),
                   {"render", kBallFile, "--isovalue", "0", "--eye", "16,-84,16", "--target", "16,16,16",
                    "--projection", "orthographic", "--height", "30", "--size", "33x33", "-o", output});
    runWell(options);
    return readImage(path(output));
  }
};

TEST_F(BallPicture, LayersHoldTheHitInWorldUnits) {
  // Position, normal and depth at the middle pixel are those of the ball's foremost point, to the hit's tolerance; the
  // corner sees nothing: depth +inf, normal 0, openness 1.
  const Image image = draw({"--layers", "all"});
  EXPECT_THAT(channelNames(image),
              ::testing::UnorderedElementsAre("R", "G", "B", "A", "ambient.Y", "normal.X", "normal.Y", "normal.Z",
                                              "position.X", "position.Y", "position.Z", "Z"));
  EXPECT_NEAR(channel(image, "position.X")[kMiddle], kCentre, kHitTolerance);
  EXPECT_NEAR(channel(image, "position.Y")[kMiddle], kCentre - kRadius, kHitTolerance);
  EXPECT_NEAR(channel(image, "position.Z")[kMiddle], kCentre, kHitTolerance);
  EXPECT_NEAR(channel(image, "Z")[kMiddle], 100 - kRadius, kHitTolerance);
  EXPECT_NEAR(channel(image, "normal.Y")[kMiddle], -1, kHitTolerance);
  EXPECT_EQ(channel(image, "Z")[0], INFINITY);
  EXPECT_EQ(channel(image, "normal.Y")[0], 0);
  EXPECT_EQ(channel(image, "ambient.Y")[0], 1);
}

TEST_F(BallPicture, LayersComeOnlyOnRequest) {
  // Without --layers an EXR holds its colour alone; a list gives those of the list.
  EXPECT_THAT(channelNames(draw({})), ::testing::UnorderedElementsAre("R", "G", "B", "A"));
  EXPECT_THAT(channelNames(draw({"--layers", "depth"})), ::testing::UnorderedElementsAre("R", "G", "B", "A", "Z"));
}

TEST_F(BallPicture, BackgroundIsTheColourAsked) {
  // A corner pixel holds the background: white by default, the sRGB colour asked for, or nothing where transparent.
  constexpr float kStep = 1.0f / 255;  // of an 8-bit picture; linear values differ by no more near these colours
  EXPECT_EQ(channel(draw({}, "out.png"), "G")[0], 1);
  const Image blue = draw({"--background", "#0000ff"}, "out.png");
  EXPECT_THAT(channelNames(blue), ElementsAre("R", "G", "B"));
  EXPECT_EQ(channel(blue, "R")[0], 0);
  EXPECT_EQ(channel(blue, "B")[0], 1);
  const Image gray = draw({"--background", "0.5,0.5,0.5", "--bit-depth", "16"}, "out.png");
  EXPECT_NEAR(channel(gray, "R")[0], 0.2140411, kStep);  // linear light of sRGB 0.5
  const Image clear = draw({"--background", "transparent"}, "out.png");
  EXPECT_EQ(channel(clear, "A")[0], 0);
  EXPECT_EQ(channel(clear, "A")[kMiddle], 1);
}

TEST_F(BallPicture, AlbedoScalesTheSurfaceAlone) {
  // A red solid has no green, and its background stays as it is.
  const Image image = draw({"--albedo", "red"});
  EXPECT_GT(channel(image, "R")[kMiddle], 0);
  EXPECT_EQ(channel(image, "G")[kMiddle], 0);
  EXPECT_EQ(channel(image, "G")[0], 1);
}

TEST_F(BallPicture, ColourIsOpennessToTheGamma) {
  // With one sample per pixel, colour = openness^(1/gamma) of the same point: 2e-6 allows for the GPU's pow.
  const Image image =
      draw({"--occlusion", "singh10", "--layers", "ambient", "--gamma", "2", "--albedo", "white", "--samples", "1"});
  const float openness = channel(image, "ambient.Y")[kMiddle];
  EXPECT_GT(openness, 0);
  EXPECT_LT(openness, 1);
  EXPECT_NEAR(channel(image, "R")[kMiddle], std::sqrt(openness), 2e-6);
}

TEST_F(BallPicture, DefaultsSumOrdinatesOfGoodQualityInLightGrey) {
  // Without options the picture is the one of --occlusion ordinates --quality good --albedo #cccccc, and not a draft
  // (which shows the same of a ball: all of it is open).
  const Image plain = draw({});
  EXPECT_TRUE(sameBits(plain, draw({"--occlusion", "ordinates", "--quality", "good", "--albedo", "#cccccc"})));
  const auto settings = [](const Image& image) { return metadata(image, "isolume:settings"); };
  EXPECT_EQ(settings(plain), settings(draw({"--quality", "good"})));
  EXPECT_NE(settings(plain), settings(draw({"--quality", "draft"})));
}

TEST_F(BallPicture, OctantsAreReadTwoVoxelsAboveAndSingh10AtTheHit) {
  // --occlusion octants differs from singh10 by where it reads.
  const Image above = draw({"--occlusion", "octants"}), published = draw({"--occlusion", "singh10"});
  EXPECT_TRUE(sameBits(above, draw({"--occlusion", "singh10", "--occlusion-offset", "2"})));
  EXPECT_TRUE(sameBits(published, draw({"--occlusion", "octants", "--occlusion-offset", "0"})));
  EXPECT_FALSE(sameBits(above, published));
}

TEST_F(BallPicture, WithoutOcclusionAHeadLightShades) {
  // --occlusion none: brightness is the cosine between normal and view, 1 in the middle, less towards the rim, and no
  // layer of openness is written.
  const Image image = draw({"--occlusion", "none", "--layers", "all", "--albedo", "white", "--samples", "1"});
  EXPECT_THAT(channelNames(image), ::testing::Not(::testing::Contains("ambient.Y")));
  const std::size_t off = kMiddle + 8;  // 8 pixels of 30/33 voxels beside the middle: 47 degrees on the ball
  EXPECT_NEAR(channel(image, "R")[kMiddle], 1, kHitTolerance);
  EXPECT_NEAR(channel(image, "R")[off], -channel(image, "normal.Y")[off], kHitTolerance);
  EXPECT_LT(channel(image, "R")[off], 0.75f);
}

TEST_F(BallPicture, InsideBelowTurnsTheSolidInsideOut) {
  // The other side of the same isovalue is a block with a hole: the view meets its flat cap at the border of the grid.
  const Image image = draw({"--inside", "below", "--layers", "position,normal"});
  EXPECT_NEAR(channel(image, "position.Y")[kMiddle], 0, kHitTolerance);
}

TEST_F(BallPicture, SpacingAndOriginPlaceTheSolid) {
  // --spacing and --origin of a raw file move the hit accordingly: y = 5 + 2 * 6.
  const std::string file = "ball.bin.raw";
  writeBall(path(file), kBall, kRadius);
  runWell({"render",   file,    "--dims",     "33x33x33", "--type", "float32",   "--spacing", "2,2,2",
           "--origin", "0,5,0", "--isovalue", "0",        "--eye",  "32,-99,32", "--target",  "32,0,32",
           "--size",   "33x33", "--layers",   "position", "-o",     "out.exr"});
  EXPECT_NEAR(channel(readImage(path("out.exr")), "position.Y")[kMiddle], 5 + 2 * (kCentre - kRadius),
              2 * kHitTolerance);
}

TEST_F(BallPicture, SizeAndBitDepthAreThoseAsked) {
  // --size is width by height; 16 bits hold more shades than the 256 of 8 bits.
  const auto draw = [this](const char* bits) {
    runWell({"render", kBallFile, "--isovalue", "0", "--size", "90x60", "--occlusion", "none", "--bit-depth", bits,
             "-o", "out.png"});
    const Image image = readImage(path("out.png"));
    EXPECT_EQ(image.size, glm::ivec2(90, 60));
    const std::vector<float>& red = channel(image, "R");
    return std::set<float>(red.begin(), red.end()).size();
  };
  EXPECT_LE(draw("8"), 256u);
  EXPECT_GT(draw("16"), 256u);
}

TEST_F(BallPicture, FramingShowsTheWholeSolid) {
  // Without a camera the solid fills the picture and touches no edge of it, from any side.
  for (const char* azimuth : {"0", "77", "200"})
    for (const char* projection : {"perspective", "orthographic"}) {
      runWell({"render", kBallFile, "--isovalue", "0", "--azimuth", azimuth, "--elevation", "-35", "--projection",
               projection, "--size", "40x60", "--background", "transparent", "-o", "out.exr"});
      const Image image = readImage(path("out.exr"));
      const std::vector<float>& alpha = channel(image, "A");
      double covered = 0, edge = 0;
      for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 40; ++x) {
          const float a = alpha[static_cast<std::size_t>(y * 40 + x)];
          covered += a;
          if (x == 0 || y == 0 || x == 39 || y == 59) edge += a;
        }
      EXPECT_EQ(edge, 0);
      EXPECT_GT(covered, 40 * 40 / 8.0);  // a ball in a box seen from a corner: above an eighth of the width squared
    }
}

}  // namespace
}  // namespace isolume::test
