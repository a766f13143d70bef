// Openness from the screen on the command line: what the options come to, and what they refuse.
#include <gmock/gmock.h>

#include "cli/picture.h"
#include "cli/program.h"
#include "src/cli/command_line.h"
#include "src/errors.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

const std::string kBallFile = "ball_17x17x17_float32.raw";

RenderJob parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), {"isolume", "render", "in.vdb", "-o", "out.png"});
  return std::get<RenderJob>(parseCommandLine(static_cast<int>(arguments.size()), arguments.data()));
}

std::array<glm::dvec3, 8> box(glm::dvec3 size) { return boxCorners(glm::dmat4(1), glm::dvec3(0), size); }

TEST(ScreenOptions, EveryNameIsAnEstimator) {
  // --occlusion takes the name of each estimator; the last one counts, also against a sweep's.
  for (const ScreenEstimator each : screenEstimators())
    EXPECT_EQ(parse({"--occlusion", screenEstimatorName(each)}).screen.estimator, each);
  EXPECT_FALSE(parse({}).screen.estimator);
  EXPECT_FALSE(parse({"--occlusion", "octants"}).screen.estimator);
}

TEST(ScreenOptions, EveryOptionReachesTheSettings) {
  // Each value given differs from the default and is found in the settings.
  const RenderJob line = parse({"--occlusion",        "loos10-line", "--ao-radius",  "2.5", "--ao-samples",   "7",
                                "--surface",          "zbuffer",     "--interleave", "3",   "--ao-filter",    "off",
                                "--ao-normalisation", "exact",       "--ao-clamp",   "off", "--ao-thickness", "0.5",
                                "--ao-second-radius", "0.25",        "--indirect",   "on"});
  const ScreenOcclusion screen = chooseScreen(line.screen, box({1, 2, 3})).value();
  EXPECT_EQ(screen.estimator, ScreenEstimator::loosLine);
  EXPECT_EQ(screen.radiusWorld, 2.5);
  EXPECT_EQ(screen.samples, 7);
  EXPECT_EQ(screen.surface, Characteristic::zBuffer);
  EXPECT_EQ(screen.interleaving, 3);
  EXPECT_FALSE(screen.filter);
  EXPECT_FALSE(screen.normalisedBySamples);
  EXPECT_FALSE(screen.clampedToTangent);
  EXPECT_TRUE(screen.indirect);
  EXPECT_EQ(screen.thicknessWorld, 0.5);
  EXPECT_EQ(screen.secondRadius, 0.25);
  const RenderJob points =
      parse({"--occlusion", "gpu-importance", "--membership", "sqrt", "--surface", "implicit", "--interleave", "off"});
  const ScreenOcclusion other = chooseScreen(points.screen, box({1, 2, 3})).value();
  EXPECT_EQ(other.membership, Membership::squareRoot);
  EXPECT_EQ(other.surface, Characteristic::implicit);
  EXPECT_EQ(other.interleaving, 1);
}

TEST(ScreenOptions, BentOptionsReachTheSettings) {
  // Each value of klehm11 that differs from its default is found in the settings.
  const RenderJob line = parse({"--occlusion", "klehm11", "--bent", "cap", "--bent-term", "on", "--ao-steps", "1"});
  const ScreenOcclusion screen = chooseScreen(line.screen, box({1, 2, 3})).value();
  EXPECT_EQ(screen.estimator, ScreenEstimator::klehm11);
  EXPECT_EQ(screen.bentFrom, BentSource::crytek3d);
  EXPECT_EQ(screen.bent, BentLight::cap);
  EXPECT_TRUE(screen.geometricTerm);
  EXPECT_EQ(screen.steps, 1);
  for (const auto& [name, source] : {std::pair{"crytek-2d", BentSource::crytek2d},
                                     {"crytek-3d", BentSource::crytek3d},
                                     {"hbao", BentSource::hbao},
                                     {"sweep", BentSource::sweep}}) {
    const RenderJob job = parse({"--occlusion", "klehm11", "--bent-from", name, "--bent", "none"});
    EXPECT_EQ(chooseScreen(job.screen, box({1, 2, 3}))->bentFrom, source);
    EXPECT_EQ(chooseScreen(job.screen, box({1, 2, 3}))->bent, BentLight::none);
    EXPECT_EQ(sweepsBent(job.screen), source == BentSource::sweep);
  }
  // With sweeps go the options of sweeps.
  EXPECT_EQ(parse({"--occlusion", "klehm11", "--bent-from", "sweep", "--ordinates", "64"}).occlusion.ordinates, 64);
}

TEST(ScreenOptions, LightsThatEstimatorsRead) {
  // klehm11 takes skies, gradients, a map and an exposure, beside the layer that shows their light.
  const RenderJob job = parse({"--occlusion", "klehm11", "--light", "sky:intensity=.5", "--light", "gradient",
                               "--environment", "map.exr", "--environment-rotation", "30", "--exposure", "1"});
  EXPECT_EQ(job.light.lights.size(), 2U);
  EXPECT_EQ(job.light.environment, "map.exr");
  std::vector<const char*> arguments{"isolume",       "render",      "in.vdb",  "-o",       "out.exr",   "--light",
                                     "sky:color=red", "--occlusion", "klehm11", "--layers", "irradiance"};
  EXPECT_NO_THROW(parseCommandLine(static_cast<int>(arguments.size()), arguments.data()));
}

TEST(ScreenOptions, RadiusIsATenthOfTheSolid) {
  // Without --ao-radius occluders count within a tenth of the longest side of the box around the solid.
  EXPECT_NEAR(chooseScreen(parse({"--occlusion", "hbao"}).screen, box({10, 40, 20}))->radiusWorld, 4, 1e-12);
  EXPECT_FALSE(chooseScreen(parse({}).screen, box({10, 40, 20})));
}

TEST(ScreenOptions, RefusedInOneLine) {
  // Values that are none, options that the estimator does not read, and options without an estimator.
  const std::vector<std::pair<std::vector<const char*>, const char*>> refused{
      {{"--occlusion", "szirmay10-volume"}, "did you mean szirmay10-volumetric?"},
      {{"--occlusion", "magic"},
       "--occlusion: expected one of singh10, octants, combined, ordinates, none, crytek, hbao"},
      {{"--occlusion", "hbao", "--ao-radius", "0"}, "--ao-radius: expected"},
      {{"--occlusion", "hbao", "--ao-samples", "257"}, "--ao-samples: expected"},
      {{"--occlusion", "hbao", "--interleave", "9"}, "--interleave: expected"},
      {{"--occlusion", "hbao", "--ao-filter", "yes"}, "--ao-filter: expected one of on, off, found 'yes'"},
      {{"--occlusion", "hbao", "--ao-filter", "on", "--interleave", "off"}, "--ao-filter: expected off with"},
      {{"--occlusion", "hbao", "--membership", "linear"}, "--membership: expected none, since hbao has its own"},
      {{"--occlusion", "gpu-sphere", "--membership", "classical"}, "--membership: expected one of sqrt, linear"},
      {{"--occlusion", "gtao", "--surface", "implicit"}, "--surface: expected an estimator of points or lines"},
      {{"--occlusion", "hbao", "--ao-thickness", "1"}, "--ao-thickness: expected"},
      {{"--occlusion", "crytek", "--surface", "implicit", "--ao-thickness", "1"}, "--ao-thickness: expected"},
      {{"--occlusion", "gpu-disk", "--ao-clamp", "off"},
       "--ao-clamp: expected loos10-point, loos10-line or loos10-area"},
      {{"--occlusion", "crytek", "--ao-second-radius", "2"}, "--ao-second-radius: expected loos10-point"},
      {{"--occlusion", "crytek", "--ao-normalisation", "exact"}, "--ao-normalisation: expected"},
      {{"--occlusion", "hbao", "--quality", "best"}, "--quality: expected with openness by sweeps, found --occlusion"},
      {{"--occlusion", "hbao", "--light", "sky"},
       "--light: expected with openness by sweeps, klehm11, ssdo or env-importance, found --occlusion hbao"},
      {{"--occlusion", "crytek", "--exposure", "1"}, "--exposure: expected with openness by sweeps, klehm11"},
      {{"--occlusion", "klehm11", "--light", "sun"},
       "--light sun: expected skies, gradients and a map as lights beside --occlusion klehm11, found it"},
      {{"--occlusion", "klehm11", "--light", "sky", "--light", "head"}, "--light head: expected skies"},
      {{"--occlusion", "ssdo", "--light", "sun"}, "beside --occlusion ssdo, found it"},
      {{"--occlusion", "env-importance", "--bounces", "all"}, "--bounces: expected skies"},
      {{"--occlusion", "klehm11", "--light", "octants"}, "--light octants: expected skies"},
      {{"--occlusion", "klehm11", "--bounces", "1"}, "--bounces: expected skies"},
      {{"--occlusion", "klehm11", "--opacity", ".5"}, "--opacity: expected skies"},
      {{"--preset", "translucent", "--occlusion", "klehm11"}, "--preset translucent: expected skies"},
      {{"--preset", "studio", "--occlusion", "klehm11"}, "--light sun: expected skies"},
      {{"--occlusion", "klehm11", "--environment-rotation", "1"}, "--environment-rotation: expected --environment"},
      {{"--occlusion", "hbao", "--bent-from", "hbao"}, "--bent-from: expected klehm11, found --occlusion hbao"},
      {{"--occlusion", "hbao", "--bent", "cone"}, "--bent: expected klehm11"},
      {{"--occlusion", "klehm11", "--bent", "normal", "--bent-term", "on"}, "--bent-term: expected klehm11 with"},
      {{"--occlusion", "klehm11", "--bent-from", "hbao", "--ao-steps", "1"},
       "--ao-steps: expected env-importance, or klehm11 with"},
      {{"--occlusion", "klehm11", "--ao-steps", "4"}, "--ao-steps: expected"},
      {{"--occlusion", "klehm11", "--bent-from", "sweep", "--ao-radius", "1"},
       "--ao-radius: expected --bent-from crytek-2d, crytek-3d or hbao, found sweep"},
      {{"--occlusion", "klehm11", "--bent-from", "sweep", "--indirect", "on"}, "--indirect: expected --bent-from"},
      {{"--occlusion", "klehm11", "--bent-from", "hbao", "--ordinates", "64"}, "--ordinates: expected with openness"},
      {{"--occlusion", "klehm11", "--bent-from", "sweep", "--occlusion-offset", "1"}, "--occlusion-offset: expected"},
      {{"--occlusion", "klehm11", "--layers", "bent"}, "--layers: expected"},
      {{"--ao-radius", "1"}, "--ao-radius: expected a screen-space --occlusion beside it"},
      {{"--occlusion", "octants", "--surface", "implicit"}, "--surface: expected a screen-space --occlusion"}};
  for (const auto& [arguments, text] : refused) {
    try {
      parse(arguments);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const UsageError& error) {
      EXPECT_THAT(error.what(), HasSubstr(text));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

class ScreenPicture : public ProgramTest {
 protected:
  ScreenPicture() { writeBall(path(kBallFile), 17, 6); }
};

TEST_F(ScreenPicture, SettingsDrawThePictureAgain) {
  // The settings in a picture's metadata, as options, give it to the last bit; a ball occludes nothing of itself.
  runWell({"render", kBallFile, "--isovalue", "0", "--size", "48x48", "--occlusion", "szirmay10-volumetric", "--layers",
           "ambient", "-o", "first.exr"});
  const Image first = readImage(path("first.exr"));
  EXPECT_THAT(metadata(first, "isolume:settings"), HasSubstr("--occlusion szirmay10-volumetric --ao-radius "));
  std::vector<std::string> again{"render", kBallFile, "--isovalue", "0", "-o", "second.exr"};
  for (const std::string& word : words(metadata(first, "isolume:settings"))) again.push_back(word);
  runWell(again);
  EXPECT_TRUE(sameBits(first, readImage(path("second.exr"))));
  // Smooth normals lean where samples are few: a ball of six voxels is open to a few percent.
  for (const float ambient : channel(first, "ambient.Y")) EXPECT_NEAR(ambient, 1, 0.05);
}

TEST_F(ScreenPicture, BentSettingsDrawThePictureAgain) {
  // So do those of klehm11 by the screen and by sweeps, under a gradient, with the light as a layer.
  for (const char* source : {"crytek-2d", "sweep"}) {
    runWell({"render", kBallFile, "--isovalue", "0", "--size", "48x48", "--occlusion", "klehm11", "--bent-from", source,
             "--light", "gradient:zenith=red", "--layers", "irradiance", "-o", "first.exr"});
    const Image first = readImage(path("first.exr"));
    const std::string settings = metadata(first, "isolume:settings");
    EXPECT_THAT(settings, HasSubstr(std::string("--bent-from ") + source + " --bent cone --bent-term off"));
    EXPECT_EQ(settings.find("--ordinates") != std::string::npos, std::string(source) == "sweep");
    std::vector<std::string> again{"render", kBallFile, "--isovalue", "0", "-o", "second.exr"};
    for (const std::string& word : words(settings)) again.push_back(word);
    runWell(again);
    EXPECT_TRUE(sameBits(first, readImage(path("second.exr"))));
    // The top of the ball sees red above, and none below.
    const std::vector<float>&red = channel(first, "irradiance.R"), &green = channel(first, "irradiance.G");
    const std::size_t top = 14 * 48 + 24;
    EXPECT_GT(red[top], green[top] + 0.1f);
  }
}

}  // namespace
}  // namespace isolume::test
