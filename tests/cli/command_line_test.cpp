#include "src/cli/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/cli/command_text.h"
#include "src/cli/parse_value.h"

namespace isolume {
namespace {

using ::testing::HasSubstr;

Command parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "isolume");
  return parseCommandLine(static_cast<int>(arguments.size()), arguments.data());
}

TEST(CommandLine, EveryRenderOptionReachesTheJob) {
  // No option is read and dropped: each value given differs from the default and is found in the job.
  const Command command = parse({"render",
                                 "in.raw",
                                 "-o",
                                 "out.exr",
                                 "--isovalue",
                                 "-2.5",
                                 "--inside",
                                 "below",
                                 "--grid",
                                 "density[1]",
                                 "--dims",
                                 "3x4x5",
                                 "--type",
                                 "uint16",
                                 "--endian",
                                 "big",
                                 "--offset",
                                 "12",
                                 "--spacing",
                                 "1,2,3",
                                 "--origin",
                                 "-1,0,+1",
                                 "--azimuth",
                                 "-10",
                                 "--elevation",
                                 "5",
                                 "--up",
                                 "0,1,0",
                                 "--roll",
                                 "7",
                                 "--zoom",
                                 "2",
                                 "--fov",
                                 "45",
                                 "--occlusion",
                                 "singh10",
                                 "--normals",
                                 "distance",
                                 "--gamma",
                                 "2",
                                 "--albedo",
                                 "#ff0000",
                                 "--background",
                                 "black",
                                 "--size",
                                 "320x200",
                                 "--samples",
                                 "9",
                                 "--layers",
                                 "normal,depth",
                                 "--threads",
                                 "2",
                                 "--report",
                                 "r.json",
                                 "--backend",
                                 "osmesa",
                                 "--verbose",
                                 "--quiet",
                                 "--occlusion-offset",
                                 "0"});
  const RenderJob& job = std::get<RenderJob>(command);
  EXPECT_EQ(job.surface.input, "in.raw");
  EXPECT_EQ(job.output, "out.exr");
  EXPECT_EQ(job.surface.isovalue, -2.5);
  EXPECT_EQ(job.surface.inside, Inside::below);
  EXPECT_EQ(job.surface.read.grid, "density[1]");
  EXPECT_EQ(job.surface.read.raw.dims, glm::ivec3(3, 4, 5));
  EXPECT_EQ(job.surface.read.raw.type, "uint16");
  EXPECT_EQ(job.surface.read.raw.bigEndian, true);
  EXPECT_EQ(job.surface.read.raw.offset, std::size_t{12});
  EXPECT_EQ(job.surface.read.raw.spacing, glm::dvec3(1, 2, 3));
  EXPECT_EQ(job.surface.read.raw.origin, glm::dvec3(-1, 0, 1));
  EXPECT_EQ(job.camera.azimuth, -10);
  EXPECT_EQ(job.camera.elevation, 5);
  EXPECT_EQ(job.camera.up, glm::dvec3(0, 1, 0));
  EXPECT_EQ(job.camera.roll, 7);
  EXPECT_EQ(job.camera.zoom, 2);
  EXPECT_EQ(job.camera.fov, 45);
  EXPECT_EQ(job.occlusion.method, OcclusionMethod::singh10);
  EXPECT_EQ(job.normals, NormalSource::distance);
  EXPECT_EQ(job.occlusion.offset, 0);
  EXPECT_EQ(job.gamma, 2);
  EXPECT_EQ(job.albedo.linear, glm::vec3(1, 0, 0));
  EXPECT_EQ(job.background.linear, glm::vec3(0));
  EXPECT_EQ(job.size, glm::ivec2(320, 200));
  EXPECT_EQ(job.samples, 9);
  EXPECT_TRUE(job.layers.normal && job.layers.depth);
  EXPECT_FALSE(job.layers.ambient || job.layers.position || job.layers.all);
  EXPECT_EQ(job.run.threads, 2);
  EXPECT_EQ(job.run.report, "r.json");
  EXPECT_TRUE(job.run.verbose && job.run.quiet);
  EXPECT_EQ(job.backend, "osmesa");
}

TEST(CommandLine, PlacedOrthographicCameraIsComplete) {
  // --eye, --target and --height stand for a whole orthographic camera; --occlusion none asks for local shading.
  const Command command =
      parse({"render", "in.vdb", "-o", "out.png", "--eye=1,2,3", "--target", "0,0,0", "--projection", "orthographic",
             "--height", "2", "--occlusion", "none", "--bit-depth", "16", "--background", "transparent"});
  const RenderJob& job = std::get<RenderJob>(command);
  EXPECT_EQ(job.camera.eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(job.camera.target, glm::dvec3(0));
  EXPECT_EQ(job.camera.height, 2);
  EXPECT_EQ(job.camera.projection, Projection::orthographic);
  EXPECT_EQ(job.occlusion.method, OcclusionMethod::none);
  EXPECT_EQ(job.bitDepth, 16);
  EXPECT_TRUE(job.transparent);
}

TEST(CommandLine, HelpTellsEveryOptionItsDefaultAndTheExitCodes) {
  // The page of a command lists its options in groups, the first page the commands and exit codes.
  const std::string render = std::get<PrintedText>(parse({"render", "--help"})).text;
  for (const char* part : {"--isovalue",  "--inside",     "--grid",        "--dims",       "--type",
                           "--endian",    "--offset",     "--spacing",     "--origin",     "--azimuth",
                           "--elevation", "--roll",       "--zoom",        "--fov",        "--quality",
                           "--error",     "--ordinates",  "--refinement",  "--eye",        "--target",
                           "--up",        "--projection", "--height",      "--occlusion",  "--occlusion-offset",
                           "--normals",   "--gamma",      "--albedo",      "--background", "--size",
                           "--samples",   "--bit-depth",  "--layers",      "--threads",    "--report",
                           "--verbose",   "--quiet",      "--backend",     "Camera",       "Shading",
                           "Output",      "1024x1024",    "(default: 30)", "osmesa",       "egl"})
    EXPECT_THAT(render, HasSubstr(part));
  const std::string first = std::get<PrintedText>(parse({"--help"})).text;
  for (const char* part : {"render", "info", "fields", "sample", "--version", "Exit codes"})
    EXPECT_THAT(first, HasSubstr(part));
}

TEST(CommandLine, HelpFitsATerminal) {
  // No line of any page is longer than 100 columns.
  for (const std::vector<const char*>& page : {std::vector<const char*>{"--help"},
                                               {"render", "--help"},
                                               {"info", "--help"},
                                               {"fields", "--help"},
                                               {"sample", "--help"}}) {
    std::string text = std::get<PrintedText>(parse(page)).text;
    for (const std::string& line : splitList(text, "\n")) EXPECT_LE(line.size(), 100u) << line;
  }
}

TEST(CommandText, QuotesWhatAShellWouldChange) {
  // The text can be pasted into a shell: plain words stay, others are quoted.
  const std::vector<const char*> argv{"/usr/bin/isolume", "info", "a b.raw", "--grid", "it's", "", "x,y=1:2"};
  EXPECT_EQ(commandText(static_cast<int>(argv.size()), argv.data()),
            "isolume info 'a b.raw' --grid 'it'\\''s' '' x,y=1:2");
}

TEST(ParseColor, TakesNamesHexAndFractionsOfSrgb) {
  // The three spellings of mid grey agree with IEC 61966-2-1: sRGB 128/255 is 0.2158605 in linear light.
  constexpr float kLinear = 0.2158605f;
  constexpr float kTolerance = 1e-6f;  // the constant above has seven digits
  EXPECT_NEAR(parseColor("--albedo", "gray").linear.r, kLinear, kTolerance);
  EXPECT_NEAR(parseColor("--albedo", "#808080").linear.g, kLinear, kTolerance);
  EXPECT_NEAR(parseColor("--albedo", "0,0.501960784,1").linear.g, kLinear, kTolerance);
  EXPECT_EQ(parseColor("--albedo", "0,0.501960784,1").linear.b, 1.0f);
  EXPECT_EQ(parseColor("--albedo", "#0000ff").linear, glm::vec3(0, 0, 1));
}

TEST(ParseValue, RefusesWhatIsNotWhollyAValue) {
  // Trailing letters, missing parts, infinities and numbers out of range are refused, never read in part.
  for (const char* text : {"", " 1", "1 ", "1x", "nan", "inf", "-inf", "1e999", "+-1", "0x10", "1,5"})
    EXPECT_THROW(parseNumber("--isovalue", text), UsageError) << text;
  for (const char* text : {"10", "10x", "x10", "10x10x10", "0x10", "10x-1", "1.5x2", "65536x1", "10X10"})
    EXPECT_THROW(parseSize("--size", text), UsageError) << text;
  for (const char* text : {"1,2", "1,2,3,4", "1,2,", "1x2,3", "1,0,3", "1.0,2,3"})
    EXPECT_THROW(parseDims("--dims", text), UsageError) << text;
  for (const char* text : {"#12345", "#12345g", "#1234567", "1,1", "2,0,0", "-0.1,0,0", "nan,0,0", "Mauve", ""})
    EXPECT_THROW(parseColor("--albedo", text), UsageError) << text;
  EXPECT_THROW(parsePositive("--gamma", "0"), UsageError);
  EXPECT_THROW(parsePositiveVector("--spacing", "1,1,-1"), UsageError);
  EXPECT_THROW(parseBytes("--offset", "-1"), UsageError);
  EXPECT_THROW(parseBytes("--offset", "18446744073709551616"), UsageError);  // 2^64
}

}  // namespace
}  // namespace isolume
