// Bad input: one line on standard error that names file, expected and found; the exit code; nothing written.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "cli/program.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

constexpr int kBall = 9;  // samples along each axis of the ball
constexpr double kRadius = 3;

struct BadCase {
  std::string name;
  std::vector<std::string> arguments;
  int exitCode;
  std::vector<std::string> told;  ///< parts of the one line
};

std::ostream& operator<<(std::ostream& out, const BadCase& bad) { return out << bad.name; }

std::vector<std::string> render(std::vector<std::string> more, const std::string& input = "ball_9x9x9_float32.raw") {
  more.insert(more.begin(), {"render", input, "--size", "8x8"});
  if (std::find(more.begin(), more.end(), "-o") == more.end()) more.insert(more.end(), {"-o", "out.png"});
  return more;
}

std::vector<BadCase> badUsage() {
  const std::string ball = "ball_9x9x9_float32.raw";
  return {
      {"NoCommand", {}, 2, {"expected a command", "render, info, fields"}},
      {"UnknownCommand", {"rendre", ball}, 2, {"unknown command 'rendre'", "did you mean render?"}},
      {"UnknownOption", render({"--isovlaue", "0"}), 2, {"--isovlaue", "did you mean --isovalue?"}},
      {"UnknownOptionWithValue", render({"--gama=2"}), 2, {"--gama", "did you mean --gamma?"}},
      {"UnknownFirstOption", {"--verison"}, 2, {"--verison", "did you mean --version?"}},
      {"NoInput", {"render", "-o", "out.png"}, 2, {"render", "expected an input"}},
      {"NoOutput", {"render", ball}, 2, {"-o FILE"}},
      {"TwoInputs", render({"other.raw"}), 2, {"other.raw"}},
      {"OptionWithoutValue",
       {"render", ball, "-o", "out.png", "--isovalue"},
       2,
       {"--isovalue: expected a value, found none"}},
      {"OptionTwice", render({"--gamma", "1", "--gamma", "2"}), 2, {"--gamma: expected once"}},
      {"SizeZero", {"render", ball, "-o", "out.png", "--size", "0x8"}, 2, {"--size", "WxH", "'0x8'"}},
      {"SizeOneNumber", {"render", ball, "-o", "out.png", "--size", "8"}, 2, {"--size", "'8'"}},
      {"SamplesZero", render({"--samples", "0"}), 2, {"--samples", "'0'"}},
      {"IsovalueNan", render({"--isovalue", "nan"}), 2, {"--isovalue", "finite", "'nan'"}},
      {"IsovalueText", render({"--isovalue", "bone"}), 2, {"--isovalue", "'bone'"}},
      {"OcclusionOffsetNegative",
       render({"--occlusion", "octants", "--occlusion-offset", "-1"}),
       2,
       {"--occlusion-offset", "from 0 to", "'-1'"}},
      {"OcclusionOffsetOfOrdinates", render({"--occlusion-offset", "1"}), 2, {"--occlusion-offset", "octants"}},
      {"OrdinatesOfOctants",
       render({"--occlusion", "octants", "--ordinates", "64"}),
       2,
       {"--ordinates", "--occlusion ordinates", "octants"}},
      {"TwoKnobs", render({"--ordinates", "64", "--quality", "good"}), 2, {"--ordinates", "--quality", "one of"}},
      {"RefinementAlone", render({"--refinement", "2"}), 2, {"--refinement", "--ordinates"}},
      {"TooFewOrdinates", render({"--ordinates", "7"}), 2, {"--ordinates", "8", "'7'"}},
      {"ErrorTooSmall", render({"--error", "1e-9"}), 2, {"--error", "at least", "1e-09"}},
      {"ErrorZero", render({"--error", "0"}), 2, {"--error", "'0'"}},
      {"OcclusionOffsetNan",
       render({"--occlusion", "octants", "--occlusion-offset", "nan"}),
       2,
       {"--occlusion-offset", "'nan'"}},
      {"GammaZero", render({"--gamma", "0"}), 2, {"--gamma", "above 0", "'0'"}},
      {"InsideUnknown", render({"--inside", "abov"}), 2, {"--inside", "above, below, auto", "did you mean above?"}},
      {"DimsZero", render({"--dims", "0,9,9"}), 2, {"--dims", "'0,9,9'"}},
      {"TypeUnknown", render({"--type", "int12"}), 2, {"--type", "uint8", "float64", "'int12'"}},
      {"EndianUnknown", render({"--endian", "middle"}), 2, {"--endian", "little, big", "'middle'"}},
      {"OffsetNegative", render({"--offset", "-1"}), 2, {"--offset", "'-1'"}},
      {"SpacingZero", render({"--spacing", "1,0,1"}), 2, {"--spacing", "above 0", "'1,0,1'"}},
      {"SpacingNan", render({"--spacing", "1,nan,1"}), 2, {"--spacing", "'1,nan,1'"}},
      {"BackgroundUnknown", render({"--background", "mauve"}), 2, {"--background", "white", "#rrggbb", "'mauve'"}},
      {"FovFlat", render({"--fov", "180"}), 2, {"--fov", "between 0 and 180"}},
      {"ZoomNegative", render({"--zoom", "-1"}), 2, {"--zoom", "'-1'"}},
      {"BackendUnknown", render({"--backend", "vulkan"}), 2, {"--backend", "auto", "osmesa", "egl", "'vulkan'"}},
      {"ThreadsZero", render({"--threads", "0"}), 2, {"--threads", "'0'"}},
      {"CameraTwice", render({"--azimuth", "1", "--eye", "9,9,9", "--target", "0,0,0"}), 2, {"--azimuth", "--eye"}},
      {"EyeAlone", render({"--eye", "9,9,9"}), 2, {"--eye", "--target"}},
      {"EyeIsTarget", render({"--eye", "1,1,1", "--target", "1,1,1"}), 2, {"--target", "1,1,1"}},
      {"UpAlongView", render({"--eye", "0,0,9", "--target", "0,0,0"}), 2, {"--up", "0,0,1", "default"}},
      {"UpZero", render({"--up", "0,0,0"}), 2, {"--up"}},
      {"HeightMissing",
       render({"--eye", "9,9,9", "--target", "0,0,0", "--projection", "orthographic"}),
       2,
       {"--height"}},
      {"HeightInPerspective", render({"--height", "2"}), 2, {"--height", "orthographic"}},
      {"FovInOrthographic", render({"--fov", "20", "--projection", "orthographic"}), 2, {"--fov", "perspective"}},
      {"LayersInPng", render({"--layers", "all"}), 2, {"--layers", ".exr", "out.png"}},
      {"LayerUnknown", render({"-o", "out.exr", "--layers", "normal,depht"}), 2, {"--layers", "did you mean depth?"}},
      {"BitDepthOdd", render({"--bit-depth", "12"}), 2, {"--bit-depth", "8, 16", "'12'"}},
      {"BitDepthInExr", render({"-o", "out.exr", "--bit-depth", "16"}), 2, {"--bit-depth", ".png", "out.exr"}},
      {"AmbientWithoutOcclusion",
       render({"-o", "out.exr", "--layers", "ambient", "--occlusion", "none"}),
       2,
       {"--layers", "ambient", "--occlusion none"}},
      {"FormatUnknown", render({"-o", "out.jpg"}), 2, {"--output", ".png or .exr", "out.jpg"}},
      {"OutputIsInput", {"fields", "ball.vdb", "-o", "./ball.vdb"}, 2, {"--output", "input", "ball.vdb"}},
      {"OutputIsReport", render({"--report", "out.png"}), 2, {"--output", "report"}},
      {"FieldsNotVdb", {"fields", ball, "-o", "out.png"}, 2, {"--output", ".vdb", "out.png"}},
      {"GridOfRaw", render({"--grid", "density"}), 3, {"--grid", "raw", "VDB"}},
      {"SceneUnknown", {"sample", "gyriod", "-o", "x.raw"}, 2, {"gyriod", "capillaries", "did you mean gyroid?"}},
      {"SceneTooSmall", {"sample", "gyroid", "--size", "1", "-o", "x.raw"}, 2, {"--size", "'1'"}},
      {"SceneFormat", {"sample", "gyroid", "-o", "x.nrrd"}, 2, {"--output", ".vdb or .raw", "x.nrrd"}},
      {"InfoOfNothing", {"info"}, 2, {"info", "expected an input"}},
  };
}

std::vector<BadCase> badFiles() {
  return {
      {"Missing", render({}, "absent.vdb"), 3, {"absent.vdb", "No such file"}},
      {"MissingInfo", {"info", "absent.raw"}, 3, {"absent.raw", "No such file"}},
      {"Truncated", render({}, "short_9x9x9_float32.raw"), 3, {"short_9x9x9_float32.raw", "2916", "2915"}},
      {"Oversized", render({}, "long_9x9x9_float32.raw"), 3, {"long_9x9x9_float32.raw", "2916", "2917"}},
      {"Empty", render({}, "empty_9x9x9_float32.raw"), 3, {"empty_9x9x9_float32.raw", "found"}},
      {"Folder", render({}, "folder"), 3, {"folder"}},
      {"WrongType", render({}, "text.txt"), 3, {"text.txt"}},
      {"DamagedVdb", render({}, "damaged.vdb"), 3, {"damaged.vdb"}},
      {"NoSuchGrid", render({"--grid", "density"}, "ball.vdb"), 3, {"ball.vdb", "density", "found"}},
      {"IsovalueAbove", render({"--isovalue", "7.5"}), 3, {"no surface at isovalue 7.5", "values span -3.9", "to 3"}},
      {"IsovalueBelow", render({"--isovalue", "-99"}), 3, {"no surface at isovalue -99", "values span"}},
      {"NothingInside", render({"--isovalue", "3", "--inside", "above"}), 3, {"no surface at isovalue 3"}},
      {"AllNan", render({"--isovalue", "0"}, "nan_2x2x2_float32.raw"), 3, {"nan_2x2x2_float32.raw", "NaN"}},
      {"DimsAgainstSize", render({"--dims", "9x9x8"}), 3, {"ball_9x9x9_float32.raw", "2592", "2916"}},
  };
}

std::vector<BadCase> badOutputs() {
  return {
      {"FolderMissing", render({"-o", "absent/out.png"}), 5, {"absent/out.png", "No such file"}},
      {"OutputIsFolder", render({"-o", "folder.png"}), 5, {"folder.png", "directory"}},
      {"ReportFolderMissing", render({"--report", "absent/r.json"}), 5, {"absent/r.json", "No such file"}},
      {"FieldsFolderMissing", {"fields", "ball.vdb", "-o", "absent/f.vdb"}, 5, {"absent/f.vdb"}},
      {"SampleFolderMissing", {"sample", "gyroid", "--size", "8", "-o", "absent/g.raw"}, 5, {"absent/g.raw"}},
      {"DiskFull", render({"-o", "full.png"}), 5, {"full.png", "No space left"}},
  };
}

class BadInput : public ProgramTest, public ::testing::WithParamInterface<BadCase> {
 protected:
  BadInput() {
    const std::string ball = ballBytes(kBall, kRadius);
    writeBytes(path("ball_9x9x9_float32.raw"), ball);
    writeBytes(path("short_9x9x9_float32.raw"), ball.substr(1));
    writeBytes(path("long_9x9x9_float32.raw"), ball + "x");
    writeBytes(path("empty_9x9x9_float32.raw"), "");
    writeBytes(path("text.txt"), "not a volume\n");
    std::string nan;
    for (int i = 0; i < 8; ++i) {  // 2x2x2 samples
      const float value = std::numeric_limits<float>::quiet_NaN();
      nan.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    writeBytes(path("nan_2x2x2_float32.raw"), nan);
    std::filesystem::create_directory(path("folder"));
    std::filesystem::create_directory(path("folder.png"));
    std::filesystem::create_symlink("/dev/full", path("full.png"));
    runWell({"sample", "spheres", "--size", "8", "--quiet", "-o", "ball.vdb"});
    const std::string vdb = fileBytes(path("ball.vdb"));
    writeBytes(path("damaged.vdb"), vdb.substr(0, vdb.size() / 2));
  }
};

TEST_P(BadInput, IsToldInOneLineAndWritesNothing) {
  // Wrong usage, bad files and outputs that cannot be written give their exit code, one line, and no file.
  const std::vector<std::string> before = files();
  const Outcome outcome = run(GetParam().arguments);
  EXPECT_EQ(outcome.exitCode, GetParam().exitCode) << outcome.err;
  EXPECT_THAT(outcome.err, ::testing::StartsWith("isolume: error: "));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_THAT(outcome.err, ::testing::EndsWith("\n"));
  for (const std::string& part : GetParam().told) EXPECT_THAT(outcome.err, HasSubstr(part));
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(files(), before);
}

const auto kCaseName = [](const auto& each) { return each.param.name; };
INSTANTIATE_TEST_SUITE_P(Usage, BadInput, ::testing::ValuesIn(badUsage()), kCaseName);
INSTANTIATE_TEST_SUITE_P(File, BadInput, ::testing::ValuesIn(badFiles()), kCaseName);
INSTANTIATE_TEST_SUITE_P(Output, BadInput, ::testing::ValuesIn(badOutputs()), kCaseName);

TEST_F(ProgramTest, UnreadableFileIsNamed) {
  // A file without read permission is an input error that says so.
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  writeBall(path("ball_9x9x9_float32.raw"), kBall, kRadius);
  chmod(path("ball_9x9x9_float32.raw").c_str(), 0);
  const Outcome outcome = run({"info", "ball_9x9x9_float32.raw"});
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_THAT(outcome.err, HasSubstr("Permission denied"));
}

TEST_F(ProgramTest, FileThatOutgrowsItsLimitLeavesNothing) {
  // When writing stops half-way, the exit code is 5 and neither the file nor a part of it is left.
  constexpr std::size_t kLimit = 1000;  // bytes; the volume takes 16384
  const Outcome outcome =
      run({"sample", "gyroid", "--size", "16", "-o", "gyroid_16x16x16_float32.raw"}, {.largestFile = kLimit});
  EXPECT_EQ(outcome.exitCode, 5) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("gyroid_16x16x16_float32.raw: cannot write 16384 bytes, wrote 1000"));
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(ProgramTest, OldFileSurvivesAFailure) {
  // An output that exists keeps its bytes when the command fails.
  writeBytes(path("out.png"), "old");
  writeBall(path("ball_9x9x9_float32.raw"), kBall, kRadius);
  EXPECT_EQ(run(render({"--isovalue", "100"})).exitCode, 3);
  EXPECT_EQ(fileBytes(path("out.png")), "old");
}

}  // namespace
}  // namespace isolume::test
