// What the user sees while the program works.
#include <gmock/gmock.h>

#include "cli/program.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kBallFile = "ball_17x17x17_float32.raw";
const std::string kEraseLine = "\r\x1b[K";

class Terminal : public ProgramTest {
 protected:
  Terminal() { writeBall(path(kBallFile), 17, 6); }
  std::string errorOf(std::vector<std::string> more, bool terminal) {
    more.insert(more.begin(), {"render", kBallFile, "--isovalue", "0", "--size", "8x8", "-o", "out.png"});
    Surroundings surroundings;
    surroundings.terminal = terminal;
    return runWell(more, surroundings).err;
  }
};

TEST_F(Terminal, ShowsOneLineThatIsErasedAtTheEnd) {
  // On a terminal each stage is shown on the same line, and nothing of it stays.
  if (!hasPseudoTerminals()) GTEST_SKIP() << "no pseudo-terminals here, so no terminal to show progress on";
  const std::string shown = errorOf({}, true);
  for (const char* part : {"reading ", "sweeping distance over 17x17x17 voxels", "ordinates over 17x17x17 voxels",
                           "drawing", "writing out.png"})
    EXPECT_THAT(shown, HasSubstr(part));
  const std::size_t lastErased = shown.rfind(kEraseLine);
  ASSERT_NE(lastErased, std::string::npos);
  EXPECT_EQ(shown.find("...", lastErased), std::string::npos) << shown;
}

TEST_F(Terminal, ElsewhereAndWhenQuietNothingMovesAround) {
  // A log file gets no progress and no control characters, and --quiet silences the terminal as well.
  if (!hasPseudoTerminals()) GTEST_SKIP() << "no pseudo-terminals here, so no terminal to show progress on";
  const std::string logged = errorOf({}, false);
  EXPECT_THAT(logged, Not(HasSubstr("\x1b")));
  EXPECT_THAT(logged, Not(HasSubstr("sweeping")));
  EXPECT_EQ(errorOf({"--quiet"}, true), "");
  EXPECT_EQ(errorOf({"--quiet"}, false), "");
}

TEST_F(Terminal, VerbosePrintsEachStage) {
  // --verbose adds a table with every stage, also beside --quiet, which silences only notes and progress.
  const std::string table = errorOf({"--verbose", "--quiet"}, false);
  for (const char* stage : {"stage", "read", "distance", "visibility", "upload", "frame", "write", "peak resident"})
    EXPECT_THAT(table, HasSubstr(stage));
}

TEST_F(Terminal, VersionAndHelpGoToStandardOutput) {
  // Asking for the version or for help is no error.
  const Outcome version = runWell({"--version"});
  EXPECT_THAT(version.out, ::testing::MatchesRegex("isolume [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  EXPECT_EQ(version.err, "");
  const Outcome help = runWell({"render", "--help"});
  EXPECT_THAT(help.out, HasSubstr("--isovalue"));
  EXPECT_EQ(help.err, "");
}

}  // namespace
}  // namespace isolume::test
