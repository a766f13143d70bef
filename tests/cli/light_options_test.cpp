// --light and what belongs to it: what is taken, and what is refused and how.
#include "src/cli/light_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/cli/command_line.h"
#include "src/errors.h"

namespace isolume {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

LightRequest light(const char* text) { return parseLight("--light", text); }

/// The message of the UsageError; the case fails if there is none.
template <class Body>
std::string refusal(const Body& body) {
  try {
    body();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    return error.what();
  }
  ADD_FAILURE() << "expected a UsageError";
  return {};
}
std::string lightRefusal(const char* text) {
  return refusal([text] { light(text); });
}

RenderJob parse(std::vector<const char*> options) {
  std::vector<const char*> arguments{"isolume", "render", "in.vdb", "-o", "out.exr"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return std::get<RenderJob>(parseCommandLine(static_cast<int>(arguments.size()), arguments.data()));
}

TEST(LightOption, KindsHaveTheirDefaults) {
  // A kind alone: white, intensity 1; a sun of one degree at azimuth 0 and elevation 45 in the world.
  for (const auto& [text, kind] : {std::pair{"sky", LightKind::sky},
                                   {"gradient", LightKind::gradient},
                                   {"sun", LightKind::sun},
                                   {"head", LightKind::head}}) {
    const LightRequest request = light(text);
    EXPECT_EQ(request.kind, kind);
    EXPECT_EQ(request.text, text);
    EXPECT_EQ(request.color, glm::vec3(1));
  }
  const LightRequest sun = light("sun");
  EXPECT_EQ(sun.azimuthDegrees, 0);
  EXPECT_EQ(sun.elevationDegrees, 45);
  EXPECT_FALSE(sun.radiusDegrees);
  EXPECT_FALSE(sun.direction || sun.fromCamera);
}

TEST(LightOption, EveryKeyReachesTheLight) {
  // No key is read and dropped: each differs from its default; colour times intensity, in either order.
  for (const char* text : {"sky:color=#ff0000:intensity=2.5", "head:intensity=2.5:color=red"})
    EXPECT_EQ(light(text).color, glm::vec3(2.5F, 0, 0)) << text;
  const LightRequest bands = light("gradient:zenith=blue:horizon=white:ground=black:intensity=3");
  EXPECT_EQ(bands.bands[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(bands.bands[1], glm::vec3(1));
  EXPECT_EQ(bands.bands[2], glm::vec3(0));
  EXPECT_EQ(bands.color, glm::vec3(3));
  const LightRequest sun = light("sun:azimuth=-30:elevation=12.5:radius=0.5:shadow=soft:from=camera");
  EXPECT_EQ(sun.azimuthDegrees, -30);
  EXPECT_EQ(sun.elevationDegrees, 12.5);
  EXPECT_EQ(sun.radiusDegrees, 0.5);
  EXPECT_EQ(sun.shadow, SunShadow::soft);
  EXPECT_EQ(light("sun:shadow=hard").shadow, SunShadow::hard);
  EXPECT_EQ(light("sun:shadow=turned").shadow, SunShadow::turned);
  EXPECT_TRUE(sun.fromCamera);
  EXPECT_FALSE(light("sun:from=world").fromCamera);
  EXPECT_EQ(light("sun:direction=1,-2,0.5").direction, glm::dvec3(1, -2, 0.5));
  EXPECT_EQ(light("sun:radius=90").radiusDegrees, 90);
}

TEST(LightOption, UnknownWordsAreRefusedWithASuggestion) {
  // A kind or key that there is not is named with those that there are, and with the one that is meant.
  EXPECT_THAT(lightRefusal("sunn"),
              HasSubstr("--light: expected one of sky, gradient, sun, head, octants, found 'sunn'"));
  EXPECT_THAT(lightRefusal("sunn"), HasSubstr("did you mean sun?"));
  EXPECT_THAT(lightRefusal(""), HasSubstr("found ''"));
  EXPECT_THAT(lightRefusal("Sky"), HasSubstr("sky"));
  EXPECT_THAT(lightRefusal("sun:radus=3"), HasSubstr("--light sun: expected one of color, intensity, azimuth"));
  EXPECT_THAT(lightRefusal("sun:radus=3"), HasSubstr("did you mean radius?"));
  // A key of another kind is none of this one's.
  for (const char* text : {"sky:radius=3", "sky:zenith=red", "head:direction=1,0,0", "gradient:azimuth=3"})
    EXPECT_THAT(lightRefusal(text), HasSubstr("expected one of color, intensity")) << text;
  EXPECT_THAT(lightRefusal("sun:from=behind"), HasSubstr("--light sun:from: expected one of world, camera"));
}

TEST(LightOption, BrokenKeysAreRefused) {
  // A key without a value, one given twice, an empty one: the message names light and key.
  EXPECT_EQ(lightRefusal("sun:radius"), "--light sun: expected KEY=VALUE after each colon, found 'radius'");
  EXPECT_EQ(lightRefusal("sky:"), "--light sky: expected KEY=VALUE after each colon, found ''");
  EXPECT_EQ(lightRefusal("sun:radius=1:radius=2"), "--light sun: expected each key once, found radius again");
  EXPECT_THAT(lightRefusal("sun:radius="), HasSubstr("--light sun:radius: expected a number above 0"));
  EXPECT_THAT(lightRefusal("sun:=3"), HasSubstr("expected one of"));
  EXPECT_THAT(lightRefusal("sky:color=mauve"), HasSubstr("--light sky:color: "));
}

TEST(LightOption, ValuesOutOfRangeAreRefused) {
  // Numbers must be finite and within what a light can be; a direction must have a length.
  for (const char* text :
       {"sun:radius=-1", "sun:radius=90.1", "sun:radius=nan", "sun:elevation=91", "sun:elevation=-91",
        "sun:azimuth=inf", "sky:intensity=inf", "sky:intensity=-1", "sky:intensity=nan", "sky:intensity=1e7",
        "sky:intensity=1x", "sun:direction=1,2", "sun:direction=1,2,inf"})
    EXPECT_THAT(lightRefusal(text), HasSubstr("expected")) << text;
  EXPECT_EQ(lightRefusal("sun:direction=0,0,0"),
            "--light sun:direction: expected a direction that is not 0, found 0,0,0");
}

TEST(LightOption, ASunHasADirectionOrAngles) {
  // Both are a contradiction, in any order.
  for (const char* text :
       {"sun:direction=1,0,0:azimuth=3", "sun:elevation=3:direction=1,0,0", "sun:direction=1,0,0:from=world"})
    EXPECT_EQ(lightRefusal(text), "--light sun: expected either a direction or angles, found both") << text;
}

TEST(LightOption, HardShadowsHaveNoRadius) {
  // A radius is that of a soft shadow; beside another it is refused, in any order.
  EXPECT_EQ(lightRefusal("sun:radius=1:shadow=hard"),
            "--light sun: expected a radius with a soft shadow alone, found a hard one");
  EXPECT_EQ(lightRefusal("sun:shadow=turned:radius=1"),
            "--light sun: expected a radius with a soft shadow alone, found a turned one");
}

TEST(LightOption, LightsAreTakenInTheOrderGiven) {
  // --light may be repeated, and takes one word each time; the other options of light reach the job.
  const RenderJob job =
      parse({"--light", "sky:intensity=0.25", "--light", "sun:radius=3", "--light=head", "--environment", "map.exr",
             "--environment-rotation", "-90", "--exposure", "1.5", "--bounces", "all"});
  ASSERT_EQ(job.light.lights.size(), 3U);
  EXPECT_EQ(job.light.lights[0].kind, LightKind::sky);
  EXPECT_EQ(job.light.lights[1].text, "sun:radius=3");
  EXPECT_EQ(job.light.lights[2].kind, LightKind::head);
  EXPECT_EQ(job.light.environment, "map.exr");
  EXPECT_EQ(job.light.rotationDegrees, -90);
  EXPECT_EQ(job.light.exposure, 1.5);
  EXPECT_EQ(job.light.bounces, kAllBounces);
  EXPECT_EQ(parse({"--bounces", "3"}).light.bounces, 3);
  EXPECT_EQ(parse({"--opacity", "0.25"}).light.opacity, 0.25);
  EXPECT_TRUE(isPlain(parse({}).light));
  EXPECT_FALSE(isPlain(job.light));
}

TEST(LightOption, OtherOptionsRefuseWhatTheyCannotTake) {
  // Opacity, exposure and reflections out of range.
  const auto refused = [](const char* option, const char* text) { return refusal([=] { parse({option, text}); }); };
  for (const char* text : {"-0.1", "1.1", "nan", "half"})
    EXPECT_THAT(refused("--opacity", text), HasSubstr("--opacity: expected a number from 0 to 1")) << text;
  for (const char* text : {"-1", "1.5", "many", "1025"})
    EXPECT_THAT(refused("--bounces", text), HasSubstr("--bounces: expected a whole number")) << text;
  for (const char* text : {"65", "inf"})
    EXPECT_THAT(refused("--exposure", text), HasSubstr("--exposure: expected a number from -64 to 64")) << text;
  EXPECT_THAT(refused("--environment-rotation", "left"), HasSubstr("--environment-rotation: expected a finite number"));
}

TEST(LightOption, AmbientIsNotALayerOfOtherLights) {
  // Beside any light but the white sky `ambient` is refused with the name of the layer that there is.
  for (const std::vector<const char*>& options :
       {std::vector<const char*>{"--light", "sun"}, {"--exposure", "1"}, {"--bounces", "2"}, {"--opacity", "0.5"}}) {
    std::vector<const char*> all = options;
    all.insert(all.end(), {"--layers", "ambient"});
    const std::string message = refusal([&] { parse(all); });
    EXPECT_THAT(message, HasSubstr("--layers: expected 'irradiance' in place of 'ambient'"));
    EXPECT_THAT(message, HasSubstr(options[0]));
    all.back() = "irradiance,bent,thickness";
    EXPECT_TRUE(parse(all).layers.irradiance && parse(all).layers.bent && parse(all).layers.thickness);
  }
}

LightingRequest lightingOf(std::vector<const char*> options) { return parse(std::move(options)).light; }

TEST(LightOption, ContradictionsAreRefused) {
  // A rotation without a map, light beside octants, and an opacity beside reflections or a sun.
  const auto refused = [](std::vector<const char*> options, OcclusionMethod method = OcclusionMethod::ordinates) {
    return refusal([&] { checkLighting(lightingOf(options), method); });
  };
  EXPECT_EQ(refused({"--environment-rotation", "3"}), "--environment-rotation: expected --environment beside it");
  for (const OcclusionMethod method : {OcclusionMethod::octants, OcclusionMethod::singh10, OcclusionMethod::combined}) {
    for (const char* light : {"head", "gradient", "sun:shadow=hard", "sun:shadow=turned"})
      EXPECT_THAT(refused({"--light", light}, method), HasSubstr("expected --occlusion ordinates beside it")) << light;
    EXPECT_THAT(refused({"--bounces", "1"}, method), HasSubstr("--bounces: expected --occlusion ordinates"));
    EXPECT_THAT(refused({"--environment", "a.exr"}, method),
                HasSubstr("--environment: expected --occlusion ordinates"));
    for (const char* light : {"sky", "octants:top=only"})
      EXPECT_NO_THROW(
          lightingOf({"--light", light, "--opacity", "0.5", "--occlusion", std::string(occlusionName(method)).c_str()}))
          << light;
    EXPECT_THAT(refused({"--light", "sun:radius=5"}, method), HasSubstr("--light sun with a radius: expected"));
  }
  for (const char* light : {"sun", "sun:from=camera", "sky:color=red"}) {
    EXPECT_NO_THROW(checkLighting(lightingOf({"--light", light}), OcclusionMethod::octants)) << light;
    EXPECT_EQ(refused({"--light", light}, OcclusionMethod::combined),
              "--light: expected grey octants or skies with --occlusion combined, found '" + std::string(light) + "'");
  }
  for (const char* light : {"sky:intensity=0", "octants:intensities=0,0,0,0,0,0,0,0"})
    EXPECT_EQ(refused({"--light", light, "--occlusion", "combined"}, OcclusionMethod::combined),
              "--light: expected light from one octant at least with --occlusion combined, found none");
  EXPECT_NO_THROW(checkLighting(lightingOf({"--light", "octants:top=only"}), OcclusionMethod::ordinates));
  for (const char* option : {"--exposure", "--opacity", "--bounces"})
    EXPECT_EQ(refused({option, "1"}, OcclusionMethod::none),
              std::string(option) + ": expected a method of occlusion beside it, found none");
  EXPECT_EQ(refused({"--opacity", "0.5", "--bounces", "1"}),
            "--bounces: expected an opaque solid, found --opacity below 1");
  EXPECT_THAT(refused({"--opacity", "0.5", "--light", "sky", "--light", "sun"}), HasSubstr("found a sun"));
  EXPECT_EQ(refused({"--opacity", "0.5", "--ordinates", "64", "--refinement", "2"}),
            "--refinement: expected 1 beside a translucent solid, found 2");
  EXPECT_THAT(refused({"--preset", "translucent", "--occlusion", "octants"}), HasSubstr("without --opacity"));
  for (const std::vector<const char*>& options : {std::vector<const char*>{"--opacity", "1", "--bounces", "1"},
                                                  {"--opacity", "0", "--bounces", "0"},
                                                  {"--opacity", "0.5", "--light", "head"},
                                                  {"--environment", "a.exr", "--environment-rotation", "3"}})
    EXPECT_NO_THROW(checkLighting(lightingOf(options), OcclusionMethod::ordinates));
}

TEST(LightOption, SettingsAreTheOptionsAgain) {
  // What is written of a request, taken as options, is the request: its settings are the same.
  const LightingRequest request =
      lightingOf({"--light", "sun:radius=3", "--light", "sky:intensity=0.5", "--environment", "a.exr",
                  "--environment-rotation", "-12.5", "--exposure", "-0.5", "--bounces", "all"});
  const nlohmann::ordered_json settings = lightingSettings(request);
  EXPECT_EQ(settings.dump(), R"({"light":["sun:radius=3","sky:intensity=0.5"],"environment":"a.exr",)"
                             R"("environment-rotation":-12.5,"exposure":-0.5,"bounces":"all"})");
  EXPECT_EQ(lightingSettings(lightingOf({"--opacity", "0.5"})).dump(), R"({"opacity":0.5})");
  EXPECT_EQ(lightingSettings(lightingOf({})).dump(), "{}");
}

TEST(LightOption, OctantsAreLitOneByOne) {
  // Intensities go to the octants in their order, `top` to those above, a sun to the octant that it stands in, turned
  // with the grid; several lights add up, times the exposure.
  const auto octants = [](std::vector<const char*> options, glm::dmat3 worldFromAxes = glm::dmat3(1)) {
    options.insert(options.end(), {"--occlusion", "octants"});
    // It looks along -z, with its head towards +x.
    const CameraAxes camera{.right = {0, -1, 0}, .up = {1, 0, 0}, .forward = {0, 0, -1}};
    return octantLights(lightingOf(std::move(options)), worldFromAxes, camera);
  };
  const auto numbered = octants({"--light", "octants:intensities=0,1,2,3,4,5,6,7:color=1,0,0", "--exposure", "1"});
  const auto top = octants({"--light", "octants:top=only"}), white = octants({});
  const auto sun = octants({"--light", "sun:direction=1,-2,3:intensity=0.5", "--light", "sky:intensity=0.25"});
  // The grid's x axis lies along the world's y: the light along world (1, -2, 3) is along (-2, -1, 3) of the grid.
  const glm::dmat3 turned(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
  const auto turnedSun = octants({"--light", "sun:direction=1,-2,3"}, turned);
  // Behind the eye, to its right and above it.
  const auto eyeSun = octants({"--light", "sun:from=camera:azimuth=30:elevation=20"});
  for (std::size_t s = 0; s < kOctants.size(); ++s) {
    const glm::ivec3 towards = kOctants[s].towardsLight();
    EXPECT_EQ(numbered[s], glm::vec3(2.0F * static_cast<float>(s), 0, 0)) << s;
    EXPECT_EQ(top[s], glm::vec3(towards.z > 0 ? 1 : 0)) << s;
    EXPECT_EQ(white[s], glm::vec3(1)) << s;
    EXPECT_EQ(sun[s], glm::vec3(towards == glm::ivec3(1, -1, 1) ? 0.75F : 0.25F)) << s;
    EXPECT_EQ(eyeSun[s], glm::vec3(towards == glm::ivec3(1, -1, 1) ? 1 : 0)) << s;
    EXPECT_EQ(turnedSun[s], glm::vec3(towards == glm::ivec3(-1, -1, 1) ? 1 : 0)) << s;
  }
  EXPECT_THAT(lightRefusal("octants:intensities=1,2"), HasSubstr("expected 8 numbers, found 2"));
  EXPECT_THAT(lightRefusal("octants:intensities=1,1,1,1,1,1,1,-1"), HasSubstr("--light octants:intensities"));
}

TEST(LightOption, PresetsGiveWayToWhatStandsBesideThem) {
  // A preset sets lights, albedo, reflections and gamma; each option replaces its own part, wherever it stands; the
  // published look is the octants with gamma 2.
  const RenderJob clay = parse({"--preset", "clay"}), own = parse({"--light", "sky", "--preset", "clay"});
  EXPECT_EQ(clay.light.lights.size(), 2U);
  EXPECT_EQ(clay.light.bounces, kAllBounces);
  ASSERT_EQ(own.light.lights.size(), 1U);
  EXPECT_EQ(own.light.lights[0].kind, LightKind::sky);
  EXPECT_EQ(own.albedo.text, clay.albedo.text);
  EXPECT_NE(clay.albedo.text, RenderJob().albedo.text);
  EXPECT_EQ(parse({"--bounces", "3", "--preset", "clay"}).light.bounces, 3);
  const RenderJob published = parse({"--preset", "singh10"});
  EXPECT_EQ(published.occlusion.method, OcclusionMethod::singh10);
  EXPECT_EQ(published.gamma, 2);
  EXPECT_FALSE(isPlain(parse({"--preset", "translucent"}).light));
  for (const char* name : {"studio", "cloudy"}) EXPECT_FALSE(parse({"--preset", name}).light.lights.empty()) << name;
  EXPECT_THAT(refusal([] { parse({"--preset", "studoi"}); }), HasSubstr("did you mean studio?"));
}

}  // namespace
}  // namespace isolume
