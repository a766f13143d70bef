#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "src/errors.h"
#include "src/io/output_file.h"
#include "temporary_folder.h"

namespace isolume {
namespace {

using test::fileBytes;
using test::messageOf;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

class OutputFile : public test::TemporaryFolder {};

TEST_F(OutputFile, WritesAndReplaces) {
  // What was written is the whole content, an older file is replaced, and no temporary file stays.
  writeFileAtomically(at("a"), std::string(100000, 'x'));
  writeFileAtomically(at("a"), std::string_view("new\0bytes", 9));
  EXPECT_EQ(fileBytes(at("a")), std::string("new\0bytes", 9));
  EXPECT_THAT(entries(), ElementsAre("a"));
}

TEST_F(OutputFile, UmaskDecidesOnPermissions) {
  // A new file has the permissions 0666 less the umask, as any other program's output has.
  const mode_t before = umask(0027);
  writeFileAtomically(at("a"), "x");
  umask(before);
  struct stat status {};
  ASSERT_EQ(stat(at("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST_F(OutputFile, FollowsSymbolicLinks) {
  // Writing to a link replaces the file that it names and leaves the link a link.
  std::filesystem::create_directory(at("elsewhere"));
  writeFileAtomically(at("elsewhere/file"), "old");
  std::filesystem::create_symlink("elsewhere/file", at("link"));
  writeFileAtomically(at("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(at("link")));
  EXPECT_EQ(fileBytes(at("elsewhere/file")), "new");
}

TEST_F(OutputFile, LongestNameFits) {
  // The temporary name does not grow with the target's, which may have all 255 bytes that a name can have.
  const std::string name(NAME_MAX, 'n');
  writeFileAtomically(at(name), "x");
  EXPECT_EQ(fileBytes(at(name)), "x");
  EXPECT_EQ(messageOf<OutputError>([&] { writeFileAtomically(at(name + "n"), "x"); }),
            at(name + "n") + ": cannot write: File name too long");
}

TEST_F(OutputFile, ImpossibleTargetsAreNamed) {
  // Folder missing, a folder itself, a file in place of a folder: writing and the early check give the same message.
  writeFileAtomically(at("file"), "kept");
  const std::vector<std::pair<std::string, std::string>> cases{
      {at("none/a"), at("none/a") + ": cannot create a file in folder " + at("none") + ": No such file or directory"},
      {at("."), at(".") + ": cannot write: Is a directory"},
      {at("file/a"), at("file/a") + ": cannot write: Not a directory"},
      {"", "output: expected a file name, found an empty one"},
  };
  for (const auto& [path, message] : cases) {
    EXPECT_EQ(messageOf<OutputError>([&] { checkWritable(path); }), message);
    EXPECT_EQ(messageOf<OutputError>([&] { writeFileAtomically(path, "x"); }), message);
  }
  EXPECT_THAT(entries(), ElementsAre("file"));
}

TEST_F(OutputFile, CheckTouchesNothing) {
  // The early check passes for a new name and for an existing file, and neither creates nor changes anything.
  writeFileAtomically(at("old"), "kept");
  checkWritable(at("old"));
  checkWritable(at("new"));
  EXPECT_THAT(entries(), ElementsAre("old"));
  EXPECT_EQ(fileBytes(at("old")), "kept");
}

TEST_F(OutputFile, RelativeNameWithoutFolder) {
  // A bare name means the working folder.
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(at(""));
  writeFileAtomically("bare", "x");
  std::filesystem::current_path(before);
  EXPECT_EQ(fileBytes(at("bare")), "x");
}

TEST_F(OutputFile, PermissionsAreRespected) {
  // A folder without write permission and a write-protected file are refused, and the file keeps its content.
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  writeFileAtomically(at("protected"), "kept");
  std::filesystem::permissions(at("protected"), std::filesystem::perms::owner_read);
  EXPECT_EQ(messageOf<OutputError>([&] { writeFileAtomically(at("protected"), "x"); }),
            at("protected") + ": cannot write: Permission denied");
  EXPECT_EQ(fileBytes(at("protected")), "kept");
  std::filesystem::permissions(at(""), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THROW(checkWritable(at("new")), OutputError);
  EXPECT_THROW(writeFileAtomically(at("new"), "x"), OutputError);
}

TEST_F(OutputFile, FullDeviceIsReported) {
  // A device takes the bytes directly, and its "disk full" reaches the message.
  EXPECT_EQ(messageOf<OutputError>([] { writeFileAtomically("/dev/full", "abc"); }),
            "/dev/full: cannot write 3 bytes, wrote 0: No space left on device");
  EXPECT_NO_THROW(writeFileAtomically("/dev/null", "abc"));
}

TEST_F(OutputFile, DiskFullLeavesNothing) {
  // When the system refuses bytes half-way, the message says how far it came, and the older file is untouched.
  writeFileAtomically(at("a"), "old");
  const pid_t child = fork();
  if (child == 0) {  // the limit cannot be lifted again for unprivileged users, so a child takes it
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string message = messageOf<OutputError>([&] { writeFileAtomically(at("a"), std::string(5000, 'x')); });
    _exit(message == at("a") + ": cannot write 5000 bytes, wrote 1000: File too large" ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0) << "1: another message";
  EXPECT_THAT(entries(), ElementsAre("a"));
  EXPECT_EQ(fileBytes(at("a")), "old");
}

}  // namespace
}  // namespace isolume
