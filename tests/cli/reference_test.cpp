// `isolume reference` from outside, and its options.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "cli/picture.h"
#include "cli/program.h"
#include "src/cli/command_line.h"
#include "src/errors.h"
#include "src/io/image.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

const std::string kBallFile = "ball_17x17x17_float32.raw";

class ReferencePicture : public ProgramTest {
 protected:
  ReferencePicture() { writeBall(path(kBallFile), 17, 5); }

  Image draw(const std::string& command, std::vector<std::string> options, const std::string& output = "out.exr") {
    options.insert(options.begin(), {command, kBallFile, "--isovalue", "0", "--size", "32x24", "-o", output});
    runWell(options);
    return readImage(path(output));
  }
  Image trace(std::vector<std::string> options, const std::string& output = "out.exr") {
    return draw("reference", std::move(options), output);
  }
};

TEST_F(ReferencePicture, HasThePlacementOfRender) {
  // Both see the same solid through the same pixels: the same pixels are hit, in the same places with the same normals
  // and depths, up to the float arithmetic of the renderer; where nothing is hit, all layers of render agree to the
  // bit.
  for (const std::string projection : {"perspective", "orthographic"}) {
    const std::vector<std::string> options{"--projection", projection, "--roll", "20", "--background", "red"};
    std::vector<std::string> renderOptions = options;
    renderOptions.insert(renderOptions.end(), {"--layers", "all"});
    const Image want = draw("render", renderOptions, "want.exr"), got = trace(options);
    int hits = 0, misses = 0;
    for (const char* name : {"position.X", "position.Y", "position.Z", "normal.X", "normal.Y", "normal.Z", "Z"}) {
      const std::vector<float>&a = channel(got, name), &b = channel(want, name);
      for (std::size_t i = 0; i < a.size(); ++i) {
        const bool hit = std::isfinite(channel(want, "Z")[i]);
        if (!hit) {
          EXPECT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) << name << " " << i;
          ++misses;
        } else {
          EXPECT_NEAR(a[i], b[i], 1e-4) << name << " " << i;  // voxels: ten times what the renderer refines hits to
          ++hits;
        }
      }
    }
    EXPECT_GT(hits, 500);
    EXPECT_GT(misses, 500);
    for (const char* name : {"R", "G", "B", "A", "ambient.Y"}) EXPECT_EQ(channel(got, name)[0], channel(want, name)[0]);
  }
}

TEST_F(ReferencePicture, LayersFollowTheIntegrand) {
  // Every integrand writes the placement, its own layers and their errors, and no NaN where something is hit.
  const std::vector<std::string> common{"R",        "G",          "B",          "A",          "normal.X", "normal.Y",
                                        "normal.Z", "position.X", "position.Y", "position.Z", "Z"};
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> cases{
      {{"--integrand", "ambient"}, {"ambient.Y"}},
      {{"--integrand", "shadow", "--light-direction", "1,-1,1"}, {"shadow.Y", "direct.Y"}},
      {{"--integrand", "light", "--light-direction", "1,-1,1", "--light-radius", "5"}, {"shadow.Y", "direct.Y"}},
      {{"--integrand", "bounce"}, {"irradiance.R", "irradiance.G", "irradiance.B"}},
      {{"--integrand", "bent"}, {"bent.X", "bent.Y", "bent.Z", "cone.Y"}},
      {{"--integrand", "translucent", "--opacity", "0.3"}, {"translucent.Y", "thickness.Y"}}};
  for (const auto& [options, layers] : cases) {
    const Image image = trace(options);
    std::vector<std::string> names = common;
    for (const std::string& layer : layers) names.insert(names.end(), {layer, "stderr." + layer});
    EXPECT_THAT(channelNames(image), ::testing::UnorderedElementsAreArray(names));
    for (const ImageChannel& each : image.channels)
      for (std::size_t i = 0; i < each.values.size(); ++i)
        EXPECT_TRUE(std::isfinite(each.values[i]) || !std::isfinite(channel(image, "Z")[i])) << each.name << " " << i;
  }
}

TEST_F(ReferencePicture, ColourIsAlbedoTimesLight) {
  // A ball is open in every direction above its surface: ambient 1 with error 0, up to the few rays that meet the
  // facets of its interpolant, and the colour is the albedo times it.
  const Image image = trace({"--albedo", "red", "--normals", "exact"});
  const std::size_t middle = 12 * 32 + 16;
  const float ambient = channel(image, "ambient.Y")[middle];
  EXPECT_GT(ambient, 0.98);
  EXPECT_EQ(channel(image, "R")[middle], ambient);
  EXPECT_EQ(channel(image, "G")[middle], 0);
  EXPECT_EQ(channel(image, "A")[middle], 1);
}

TEST_F(ReferencePicture, OpacityIsInThePictureAndItsProvenance) {
  // At opacity 0 light comes from both sides, 2 in all, times the albedo; the setting is recorded as an option.
  const Image clear =
      trace({"--integrand", "translucent", "--opacity", "0", "--rays", "16", "--albedo", "red"}, "clear.exr");
  const std::size_t middle = 12 * 32 + 16;
  EXPECT_EQ(channel(clear, "translucent.Y")[middle], 2);
  EXPECT_EQ(channel(clear, "R")[middle], 2);
  EXPECT_EQ(channel(clear, "translucent.Y")[0], 1);
  EXPECT_EQ(channel(clear, "thickness.Y")[0], 0);
  EXPECT_NEAR(channel(clear, "thickness.Y")[middle], 4 * 5 / 3.0, 0.5);  // a ball of radius 5, 16 rays
  EXPECT_THAT(metadata(clear, "isolume:settings"), HasSubstr("--opacity 0"));
}

TEST_F(ReferencePicture, ThreadsChangeNoBit) {
  // One thread and two write the same pixels.
  EXPECT_TRUE(sameBits(trace({"--threads", "1"}, "one.exr"), trace({"--threads", "2"}, "two.exr")));
}

TEST_F(ReferencePicture, ProvenanceDrawsItAgain) {
  // The camera and the settings in the metadata are options that give the same picture, bit for bit.
  const Image image = trace({"--rays", "32", "--seed", "5", "--radius", "3", "--membership", "sqrt", "--azimuth", "77",
                             "--normals", "exact"});
  EXPECT_THAT(metadata(image, "isolume:settings"), HasSubstr("--rays 32"));
  std::vector<std::string> options{"reference",  metadata(image, "isolume:input"),
                                   "--isovalue", metadata(image, "isolume:isovalue"),
                                   "-o",         "again.exr"};
  for (const char* key : {"isolume:camera", "isolume:settings"}) {
    const std::vector<std::string> more = words(metadata(image, key));
    options.insert(options.end(), more.begin(), more.end());
  }
  runWell(options);
  EXPECT_TRUE(sameBits(image, readImage(path("again.exr"))));
}

TEST_F(ReferencePicture, WhiteEnvironmentGivesTheOpenness) {
  // A white map, as EXR and as PNG, lights every pixel as much as it is open; its checksum is recorded.
  Image white;
  white.size = {4, 2};
  for (const char* name : {"R", "G", "B"}) white.channels.push_back({name, std::vector<float>(8, 1.0f)});
  writeImage(path("white.exr"), white);
  writeImage(path("white.png"), white);
  const Image open = trace({}, "open.exr");
  for (const std::string map : {"white.exr", "white.png"}) {
    const Image light = trace({"--integrand", "environment", "--environment", map}, "light.exr");
    for (std::size_t i = 0; i < channel(open, "Z").size(); ++i) {
      const bool hit = std::isfinite(channel(open, "Z")[i]);
      EXPECT_EQ(channel(light, "irradiance.G")[i], hit ? channel(open, "ambient.Y")[i] : 0) << i;
    }
    EXPECT_THAT(metadata(light, "isolume:environment_sha256"), HasSubstr(map));
  }
}

TEST_F(ReferencePicture, TellsWhatItCouldNotReach) {
  // A target beyond the cap is a warning with the number of pixels, and the picture is written all the same.
  const Outcome outcome = runWell({"reference", kBallFile, "--isovalue", "0", "--size", "16x16", "--integrand", "bent",
                                   "--stderr", "0.0001", "--max-rays", "64", "-o", "out.exr"});
  EXPECT_THAT(outcome.err, HasSubstr("warning: --stderr 0.0001: "));
  EXPECT_THAT(outcome.err, HasSubstr("with 64 rays"));
}

TEST_F(ReferencePicture, RefusesAMapThatIsNoLight) {
  // A missing map, one without colours and one with a negative texel end with exit code 3, one line, and no output.
  Image map;
  map.size = {2, 1};
  for (const char* name : {"R", "G", "B"}) map.channels.push_back({name, {1.0f, -2.0f}});
  writeImage(path("negative.exr"), map);
  map.channels = {{"Y", {1.0f, 1.0f}}};
  writeImage(path("grey.exr"), map);
  const std::vector<std::pair<std::string, std::string>> cases{
      {"absent.exr", "absent.exr"}, {"negative.exr", "pixel 1,0"}, {"grey.exr", "found no R"}};
  for (const auto& [file, told] : cases) {
    const Outcome outcome = run({"reference", kBallFile, "--isovalue", "0", "--integrand", "environment",
                                 "--environment", file, "-o", "out.exr"});
    EXPECT_EQ(outcome.exitCode, 3) << file;
    EXPECT_THAT(outcome.err, HasSubstr(told));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_THAT(files(), ::testing::Not(::testing::Contains("out.exr")));
}

TEST_F(ReferencePicture, NeedsNoOpenGl) {
  // Where no library of OpenGL can be loaded, the reference is drawn all the same.
  const std::string broken = path("broken");
  std::filesystem::create_directory(broken);
  for (const char* library : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libEGL.so.1", "libEGL.so"})
    writeBytes(broken + "/" + library, "not a library");
  runWell({"reference", kBallFile, "--isovalue", "0", "--size", "8x8", "-o", "out.exr"},
          {.environment = {{"LD_LIBRARY_PATH", broken}}});
}

Command parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), {"isolume", "reference", "in.raw"});
  return parseCommandLine(static_cast<int>(arguments.size()), arguments.data());
}

TEST(ReferenceOptions, ReachTheJob) {
  // No option is read and dropped: each value given differs from the default and is found in the job.
  const ReferenceJob job = std::get<ReferenceJob>(
      parse({"-o",           "out.exr",     "--isovalue",    "2",       "--azimuth", "9",      "--size",   "8x4",
             "--integrand",  "bounce",      "--environment", "sky.exr", "--bounces", "7",      "--stderr", "0.01",
             "--max-rays",   "320",         "--seed",        "11",      "--normals", "exact",  "--albedo", "black",
             "--background", "transparent", "--threads",     "2",       "--report",  "r.json", "--quiet"}));
  EXPECT_EQ(job.surface.input, "in.raw");
  EXPECT_EQ(job.surface.isovalue, 2);
  EXPECT_EQ(job.camera.azimuth, 9);
  EXPECT_EQ(job.size, glm::ivec2(8, 4));
  EXPECT_EQ(job.integrand, Integrand::bounce);
  EXPECT_EQ(job.environment, "sky.exr");
  EXPECT_EQ(job.bounces, 7);
  EXPECT_EQ(job.targetError, 0.01);
  EXPECT_EQ(job.maxRays, 320);
  EXPECT_EQ(job.seed, 11u);
  EXPECT_EQ(job.normals, ReferenceNormals::exact);
  EXPECT_EQ(job.albedo.linear, glm::vec3(0));
  EXPECT_TRUE(job.transparent);
  EXPECT_EQ(job.run.threads, 2);
  EXPECT_EQ(job.run.report, "r.json");
  EXPECT_TRUE(job.run.quiet);
  const ReferenceJob near =
      std::get<ReferenceJob>(parse({"-o", "out.exr", "--radius", "0.5", "--membership", "volumetric", "--rays", "48"}));
  EXPECT_EQ(near.radius, 0.5);
  EXPECT_EQ(near.membership, Membership::volumetric);
  EXPECT_EQ(near.rays, 48);
  const ReferenceJob sun = std::get<ReferenceJob>(
      parse({"-o", "out.exr", "--integrand", "light", "--light-direction", "1,2,3", "--light-radius", "0.25"}));
  EXPECT_EQ(sun.lightDirection, glm::dvec3(1, 2, 3));
  EXPECT_EQ(sun.lightRadius, 0.25);
  EXPECT_EQ(std::get<ReferenceJob>(parse({"-o", "out.exr", "--integrand", "translucent", "--opacity", "0.4"})).opacity,
            0.4);
}

TEST(ReferenceOptions, RefuseWhatMakesNoSense) {
  // An option that its integrand does not read, one that it lacks, and values out of range are usage errors that name
  // the option.
  const std::vector<std::pair<std::vector<const char*>, const char*>> cases{
      {{}, "expected an output"},
      {{"-o", "out.png"}, "--output: expected a name that ends in .exr"},
      {{"-o", "o.exr", "--membership", "linear"}, "--membership: expected with --radius"},
      {{"-o", "o.exr", "--radius", "0"}, "--radius: expected a number above 0"},
      {{"-o", "o.exr", "--integrand", "bent", "--radius", "1"}, "--radius: expected --integrand ambient, found bent"},
      {{"-o", "o.exr", "--integrand", "shadow"}, "--light-direction: expected with --integrand shadow"},
      {{"-o", "o.exr", "--integrand", "shadow", "--light-direction", "0,0,0"},
       "--light-direction: expected a direction"},
      {{"-o", "o.exr", "--integrand", "shadow", "--light-direction", "0,0,1", "--rays", "32"}, "--rays: expected"},
      {{"-o", "o.exr", "--integrand", "light", "--light-direction", "0,0,1"}, "--light-radius: expected with"},
      {{"-o", "o.exr", "--integrand", "light", "--light-direction", "0,0,1", "--light-radius", "0"}, "--light-radius"},
      {{"-o", "o.exr", "--integrand", "light", "--light-direction", "0,0,1", "--light-radius", "91"}, "--light-radius"},
      {{"-o", "o.exr", "--light-direction", "0,0,1"}, "--light-direction: expected --integrand shadow or light"},
      {{"-o", "o.exr", "--integrand", "environment"}, "--environment: expected with"},
      {{"-o", "o.exr", "--environment", "sky.exr"}, "--environment: expected --integrand environment or bounce"},
      {{"-o", "sky.exr", "--integrand", "bounce", "--environment", "sky.exr"}, "other than the environment"},
      {{"-o", "o.exr", "--bounces", "2"}, "--bounces: expected --integrand bounce"},
      {{"-o", "o.exr", "--integrand", "bounce", "--bounces", "-1"}, "--bounces"},
      {{"-o", "o.exr", "--opacity", "0.5"}, "--opacity: expected --integrand translucent, found ambient"},
      {{"-o", "o.exr", "--integrand", "translucent"}, "--opacity: expected with --integrand translucent"},
      {{"-o", "o.exr", "--integrand", "translucent", "--opacity", "1.01"}, "--opacity: expected a number from 0 to 1"},
      {{"-o", "o.exr", "--integrand", "translucent", "--opacity", "-0.1"}, "--opacity: expected a number from 0 to 1"},
      {{"-o", "o.exr", "--integrand", "translucent", "--opacity", "nan"}, "--opacity: expected a number from 0 to 1"},
      {{"-o", "o.exr", "--rays", "100"}, "--rays: expected a multiple of 16"},
      {{"-o", "o.exr", "--rays", "0"}, "--rays"},
      {{"-o", "o.exr", "--rays", "32", "--stderr", "0.1"}, "--rays: expected either"},
      {{"-o", "o.exr", "--stderr", "0"}, "--stderr: expected a number above 0"},
      {{"-o", "o.exr", "--max-rays", "64"}, "--max-rays: expected with --stderr"},
      {{"-o", "o.exr", "--seed", "-1"}, "--seed"},
      {{"-o", "o.exr", "--integrand", "ambiant"}, "did you mean ambient?"},
      {{"-o", "o.exr", "--membership", "cube", "--radius", "1"}, "--membership: expected one of"},
      {{"-o", "o.exr", "--backend", "egl"}, "unknown option --backend"},
      {{"-o", "o.exr", "--gamma", "2"}, "unknown option --gamma"},
  };
  for (const auto& [arguments, told] : cases)
    EXPECT_THAT(messageOf<UsageError>([&arguments = arguments] { parse(arguments); }), HasSubstr(told));
}

TEST(ReferenceOptions, HelpFitsATerminal) {
  // No line of the page is longer than 100 columns, and every option stands on it.
  const std::string text = std::get<PrintedText>(parse({"--help"})).text;
  for (std::size_t start = 0, end; (end = text.find('\n', start)) != std::string::npos; start = end + 1)
    EXPECT_LE(end - start, 100u) << text.substr(start, end - start);
  for (const char* option :
       {"--integrand", "--radius", "--membership", "--light-direction", "--light-radius", "--environment", "--bounces",
        "--opacity", "--rays", "--stderr", "--max-rays", "--seed", "--normals"})
    EXPECT_THAT(text, HasSubstr(option));
}

}  // namespace
}  // namespace isolume::test
