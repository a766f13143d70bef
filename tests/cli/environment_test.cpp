// What surrounds the program: OpenGL libraries, signals, threads.
#include <gmock/gmock.h>
#include <signal.h>
#include <time.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "cli/picture.h"
#include "cli/program.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

constexpr int kBall = 17;
constexpr double kRadius = 6;
const std::string kBallFile = "ball_17x17x17_float32.raw";

/// A line of /proc/ID/status that lists signals: whether SIGINT is caught.
bool catchesInterrupt(pid_t id) {
  const std::string status = fileBytes("/proc/" + std::to_string(id) + "/status");
  const std::string key = "SigCgt:\t";
  const std::size_t at = status.find(key);
  if (at == std::string::npos) return false;
  const unsigned long long mask = std::stoull(status.substr(at + key.size()), nullptr, 16);  // hexadecimal
  return (mask >> (SIGINT - 1)) & 1;
}

bool hasLoaded(pid_t id, std::string_view library) {
  return fileBytes("/proc/" + std::to_string(id) + "/maps").find(library) != std::string::npos;
}

/// Polls until `condition` holds or the process has ended.
template <class Condition>
bool waitFor(Process& process, Condition condition) {
  constexpr timespec kPause{0, 1'000'000};  // 1 ms
  while (!condition()) {
    if (process.ended()) return false;
    nanosleep(&kPause, nullptr);
  }
  return true;
}

std::vector<std::string> endlessRender() {
  // 64 million pixels with 1024 samples each: no machine ends this before the signal comes.
  return {"render", kBallFile,   "--isovalue", "0",    "--backend", "osmesa",
          "--size", "8000x8000", "--samples",  "1024", "-o",        "out.png"};
}

TEST_F(ProgramTest, InterruptWhileDrawingEndsWith130AndLeavesNothing) {
  // SIGINT in the middle of drawing ends the program with 130 and without a file, SIGTERM with 143.
  writeBall(path(kBallFile), kBall, kRadius);
  const std::vector<std::string> before = files();
  for (const auto& [signalNumber, exitCode] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
    Process process(folder_, endlessRender());
    ASSERT_TRUE(waitFor(process, [&] { return hasLoaded(process.id(), "libOSMesa"); })) << process.wait().err;
    ASSERT_TRUE(catchesInterrupt(process.id()));
    kill(process.id(), signalNumber);
    const Outcome outcome = process.wait();
    EXPECT_EQ(outcome.exitCode, exitCode);
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_EQ(files(), before);
  }
}

TEST_F(ProgramTest, OsmesaDrawsWithoutADisplay) {
  // --backend osmesa gives a picture with no display at hand and records itself in it.
  writeBall(path(kBallFile), kBall, kRadius);
  runWell({"render", kBallFile, "--isovalue", "0", "--backend", "osmesa", "--size", "16x16", "-o", "out.png"},
          {.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}});
  EXPECT_EQ(metadata(readImage(path("out.png")), "isolume:backend"), "osmesa");
}

TEST_F(ProgramTest, MissingOpenGlIsExitCode4AndSaysWhatWasTried) {
  // Libraries that cannot be loaded are a GPU error: a backend asked for by name is told alone and never replaced by
  // another, auto tells what each said.
  writeBall(path(kBallFile), kBall, kRadius);
  const std::string broken = path("broken");
  std::filesystem::create_directory(broken);
  for (const char* library : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
    writeBytes(broken + "/" + library, "not a library");
  const Surroundings noOsmesa{.environment = {{"LD_LIBRARY_PATH", broken}}};
  const Outcome named = run({"render", kBallFile, "--isovalue", "0", "--backend", "osmesa", "-o", "out.png"}, noOsmesa);
  EXPECT_EQ(named.exitCode, 4) << named.err;
  EXPECT_THAT(named.err, HasSubstr("isolume: error: "));
  EXPECT_THAT(named.err, HasSubstr("osmesa"));

  for (const char* library : {"libEGL.so.1", "libEGL.so"}) writeBytes(broken + "/" + library, "not a library");
  const Outcome any = run({"render", kBallFile, "--isovalue", "0", "-o", "out.png"}, noOsmesa);
  EXPECT_EQ(any.exitCode, 4) << any.err;
  for (const char* name : {"osmesa", "egl"}) EXPECT_THAT(any.err, HasSubstr(name));
  EXPECT_EQ(std::count(any.err.begin(), any.err.end(), '\n'), 1) << any.err;
  EXPECT_FALSE(std::filesystem::exists(path("out.png")));
}

TEST_F(ProgramTest, EglDrawsOrSaysWhyNot) {
  // --backend egl either draws with EGL or ends with 4 and its name: never a silent fall-back.
  writeBall(path(kBallFile), kBall, kRadius);
  const Outcome outcome =
      run({"render", kBallFile, "--isovalue", "0", "--backend", "egl", "--size", "16x16", "-o", "out.png"});
  if (outcome.exitCode == 0) {
    EXPECT_EQ(metadata(readImage(path("out.png")), "isolume:backend"), "egl");
  } else {
    EXPECT_EQ(outcome.exitCode, 4) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("egl"));
  }
}

TEST_F(ProgramTest, ThreadsChangeNoBit) {
  // One and two threads give the same bits in every layer, and so does the same command twice in every byte.
  runWell({"sample", "capsules", "--size", "40", "--quiet", "-o", "capsules.vdb"});
  const auto draw = [&](const char* threads, const std::string& output) {
    runWell({"render", "capsules.vdb", "--isovalue", "0", "--inside", "below", "--size", "70x50", "--layers", "all",
             "--threads", threads, "-o", output});
  };
  draw("1", "one.exr");
  draw("2", "two.exr");
  const Image one = readImage(path("one.exr"));
  EXPECT_TRUE(sameBits(one, readImage(path("two.exr"))));
  const std::string bytes = fileBytes(path("two.exr"));
  draw("2", "two.exr");
  EXPECT_TRUE(bytes == fileBytes(path("two.exr"))) << "the same command wrote different bytes";
}

}  // namespace
}  // namespace isolume::test
