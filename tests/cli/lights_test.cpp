// Pictures by lights, as a user draws them.
#include <gmock/gmock.h>

#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#include "cli/picture.h"
#include "cli/program.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

constexpr int kBall = 17;
constexpr double kRadius = 6;
const std::string kBallFile = "ball_17x17x17_float32.raw";

// A ball in empty space.
class LitBall : public ProgramTest {
 protected:
  LitBall() { writeBall(path(kBallFile), kBall, kRadius); }

  static std::vector<std::string> command(std::vector<std::string> options, const std::string& output = "out.exr") {
    options.insert(options.begin(), {"render", kBallFile, "--isovalue", "0", "--size", "32x24", "-o", output});
    return options;
  }
  Image draw(const std::vector<std::string>& options) {
    runWell(command(options));
    return readImage(path("out.exr"));
  }

  /// An 8 x 4 map of one colour, with one pixel of another.
  void writeMap(const std::string& name, glm::vec3 color, glm::vec3 first, int channels = 3) {
    Image map;
    map.size = {8, 4};
    const char* const kNames[] = {"R", "G", "B"};
    for (int c = 0; c < channels; ++c) {
      map.channels.push_back({kNames[c], std::vector<float>(32, color[c])});
      map.channels.back().values[0] = first[c];
    }
    writeImage(path(name), map);
  }
};

template <class Visit>
void forEachHit(const Image& image, const Visit& visit) {
  const std::vector<float>& depth = channel(image, "Z");
  int hits = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (!std::isfinite(depth[i])) continue;
    ++hits;
    visit(i);
  }
  EXPECT_GT(hits, 100);
}

TEST_F(LitBall, AWhiteMapIsAWhiteSky) {
  // A ball in the open gets 1 from a white map, its colour from a map of one colour, turned or not, and twice as much
  // with an exposure of 1.
  writeMap("white.exr", glm::vec3(1), glm::vec3(1));
  writeMap("warm.exr", {1, 0.5, 0.25}, {1, 0.5, 0.25});
  constexpr float kTolerance = 0.02F;
  const Image white = draw({"--environment", "white.exr", "--layers", "irradiance,depth"});
  const Image warm = draw(
      {"--environment", "warm.exr", "--environment-rotation", "77", "--exposure", "1", "--layers", "irradiance,depth"});
  forEachHit(white, [&](std::size_t i) {
    EXPECT_NEAR(channel(white, "irradiance.R")[i], 1, kTolerance);
    EXPECT_NEAR(channel(warm, "irradiance.R")[i], 2, 2 * kTolerance);
    EXPECT_NEAR(channel(warm, "irradiance.G")[i], 1, kTolerance);
    EXPECT_NEAR(channel(warm, "irradiance.B")[i], 0.5, kTolerance);
  });
}

TEST_F(LitBall, ASunLightsItsOwnSide) {
  // A red sun of 2 degrees from a direction gives max(N . l, 0) on a ball, but for its own width at the rim.
  const Image image =
      draw({"--light", "sun:direction=1,-2,1:radius=2:color=red", "--layers", "irradiance,normal,depth"});
  const glm::dvec3 towards = glm::dvec3(1, -2, 1) / std::sqrt(6.0);
  const double width = std::sin(2 * M_PI / 180);
  forEachHit(image, [&](std::size_t i) {
    double cosine = 0;
    const char* const kNames[] = {"normal.X", "normal.Y", "normal.Z"};
    for (int c = 0; c < 3; ++c) cosine += towards[c] * static_cast<double>(channel(image, kNames[c])[i]);
    EXPECT_NEAR(channel(image, "irradiance.R")[i], std::max(cosine, 0.0),
                0.02 + (std::abs(cosine) < width ? width : 0));
    EXPECT_EQ(channel(image, "irradiance.G")[i], 0);
  });
}

TEST_F(LitBall, BrokenMapsAreInputErrors) {
  // Exit code 3 and one line that names the file and, where there is one, the pixel; nothing is written.
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  writeMap("nan.exr", glm::vec3(1), {1, kNan, 1});
  writeMap("negative.exr", glm::vec3(1), {1, 1, -0.5});
  writeMap("grey.exr", glm::vec3(1), glm::vec3(1), 1);
  writeBytes(path("text.exr"), "not a picture");
  for (const auto& [name, message] : {std::pair{"nan.exr", "nan.exr: pixel 0,0: expected radiance of 0 or more"},
                                      {"negative.exr",
                                       "negative.exr: pixel 0,0: expected radiance of 0 or more, "
                                       "found -0.5"},
                                      {"grey.exr", "grey.exr: expected the channels R, G and B, found no G"},
                                      {"missing.exr", "missing.exr: "},
                                      {"text.exr", "text.exr: "}}) {
    const Outcome outcome = run(command({"--environment", name}));
    EXPECT_EQ(outcome.exitCode, 3) << name << ": " << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message)) << name;
    EXPECT_THAT(files(), ::testing::Not(::testing::Contains("out.exr")));
  }
}

TEST_F(LitBall, ContradictionsAreUsageErrors) {
  // Exit code 2 and nothing written for options that contradict each other.
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--environment-rotation", "3"},
                                                  {"--light", "head", "--occlusion", "octants"},
                                                  {"--opacity", "0.5", "--bounces", "1"},
                                                  {"--opacity", "0.5", "--light", "sun"},
                                                  {"--light", "sun", "--layers", "ambient"},
                                                  {"--layers", "bent", "--occlusion", "octants"}}) {
    const Outcome outcome = run(command(options));
    EXPECT_EQ(outcome.exitCode, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("expected"));
    EXPECT_THAT(files(), ::testing::Not(::testing::Contains("out.exr")));
  }
}

TEST_F(LitBall, MoreLightsThanAPictureHoldsAreAUsageError) {
  // Eight channels of light and four hard suns are drawn; one more of either is refused with both numbers.
  const auto lights = [](const std::vector<std::pair<std::string, int>>& kinds) {
    std::vector<std::string> options;
    for (const auto& [kind, count] : kinds)
      for (int i = 0; i < count; ++i) options.insert(options.end(), {"--light", kind});
    return options;
  };
  runWell(command(lights({{"gradient", 2}, {"sky", 2}, {"sun:shadow=hard", 4}, {"head", 3}})));
  std::vector<std::string> bounced = lights({{"gradient", 2}});
  bounced.insert(bounced.end(), {"--bounces", "1"});
  for (const auto& [options, message] :
       {std::pair{lights({{"gradient", 2}, {"sky", 3}}), "at most 8 swept channels of light"},
        {bounced, "coloured reflections have three), found 9"},
        {lights({{"sun:shadow=hard", 5}}), "at most 4 suns with hard shadows, found 5"}}) {
    const Outcome outcome = run(command(options, "more.exr"));
    EXPECT_EQ(outcome.exitCode, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_THAT(files(), ::testing::Not(::testing::Contains("more.exr")));
  }
}

TEST_F(LitBall, BentNormalsAndThicknessAreLayers) {
  // A ball in the open has its normal as bent normal, a cone of a hemisphere, and 4 r / 3 as thickness; what is not hit
  // has 0.
  const Image image = draw({"--layers", "bent,thickness,normal,depth"});
  EXPECT_THAT(channelNames(image),
              ::testing::UnorderedElementsAre("R", "G", "B", "A", "normal.X", "normal.Y", "normal.Z", "bent.X",
                                              "bent.Y", "bent.Z", "cone.Y", "thickness.Y", "Z"));
  forEachHit(image, [&](std::size_t i) {
    double cosine = 0;
    for (const char* axis : {".X", ".Y", ".Z"})
      cosine += static_cast<double>(channel(image, std::string("normal") + axis)[i]) *
                static_cast<double>(channel(image, std::string("bent") + axis)[i]);
    EXPECT_GT(cosine, 0.99);
    EXPECT_GT(channel(image, "cone.Y")[i], 0.9 * M_PI / 2);
    EXPECT_NEAR(channel(image, "thickness.Y")[i], 4 * kRadius / 3, 1);
  });
  for (const char* name : {"bent.X", "cone.Y", "thickness.Y"}) EXPECT_EQ(channel(image, name)[0], 0);
}

TEST_F(LitBall, OpacityLetsLightThrough) {
  // Without opacity a ball sees the sky on both sides, 2; with .5 less than that and more than 1.
  for (const auto& [opacity, low, high] : {std::tuple{"0", 1.98, 2.02}, {"0.5", 1.01, 1.3}, {"1", 0.99, 1.01}}) {
    const Image image = draw({"--opacity", opacity, "--layers", "irradiance,depth"});
    forEachHit(image, [&, low = low, high = high](std::size_t i) {
      EXPECT_GT(channel(image, "irradiance.G")[i], low);
      EXPECT_LT(channel(image, "irradiance.G")[i], high);
    });
  }
}

TEST_F(LitBall, MetadataDrawsThePictureAgain) {
  // Camera and settings taken from a picture by all kinds of lights, as options, give it again to the last bit.
  writeMap("map.exr", {0.1F, 0.2F, 0.3F}, {9, 8, 7});
  const std::vector<std::vector<std::string>> pictures = {
      {"--light", "sky:intensity=0.3:color=#8090ff", "--light", "sun:azimuth=30:elevation=50:radius=4:color=1,0.9,0.7",
       "--light", "head:intensity=0.125", "--light", "gradient:zenith=blue:ground=0.5,0.25,0.125", "--bounces", "2",
       "--albedo", "0.8,0.5,0.2", "--exposure", "-0.75"},
      {"--environment", "map.exr", "--environment-rotation", "-33.3", "--light", "sun:from=camera:azimuth=-40",
       "--bounces", "all"},
      {"--environment", "map.exr", "--opacity", "0.3"}};
  for (std::vector<std::string> options : pictures) {
    const bool translucent = std::find(options.begin(), options.end(), "--opacity") != options.end();
    options.insert(options.end(), {"--layers", "irradiance,depth", "--ordinates", "40"});
    options.insert(options.end(), {"--refinement", translucent ? "1" : "2"});
    const Image first = draw(options);
    std::vector<std::string> again{"render", metadata(first, "isolume:input"), "--isovalue", "0", "-o", "again.exr"};
    for (const char* key : {"isolume:camera", "isolume:settings"})
      for (const std::string& word : words(metadata(first, key))) again.push_back(word);
    runWell(again);
    EXPECT_TRUE(sameBits(first, readImage(path("again.exr")))) << metadata(first, "isolume:settings");
  }
}

}  // namespace
}  // namespace isolume::test
