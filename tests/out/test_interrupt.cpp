#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "src/io/output_file.h"
#include "src/io/unfinished_file.h"
#include "temporary_folder.h"

namespace isolume {
namespace {

using test::fileBytes;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::StartsWith;

struct Ended {
  int exitCode = -1;
  std::string said;
};

class Interrupt : public test::TemporaryFolder {
 protected:
  // Runs `act` in a child whose standard error is a file; `act` is expected not to return.
  template <class Act>
  Ended runChild(const Act& act) {
    const pid_t child = fork();
    if (child == 0) {
      if (std::freopen(said_.c_str(), "w", stderr) == nullptr) _exit(99);
      installInterruptHandler();
      act();
      _exit(98);
    }
    int status = -1;
    waitpid(child, &status, 0);
    Ended ended{WIFEXITED(status) ? WEXITSTATUS(status) : -1, fileBytes(said_)};
    std::filesystem::remove(said_);
    return ended;
  }

 private:
  std::string said_ = at("stderr");
};

TEST_F(Interrupt, UnfinishedFileIsRemoved) {
  // SIGINT and SIGTERM while a file is half-written remove it, print one line, and exit with 130 and 143.
  for (const int signalNumber : {SIGINT, SIGTERM}) {
    const Ended ended = runChild([&] {
      UnfinishedFile file(at("temporary"));
      if (write(file.descriptor(), "half", 4) != 4 || !std::filesystem::exists(at("temporary"))) _exit(97);
      raise(signalNumber);
    });
    EXPECT_EQ(ended.exitCode, 128 + signalNumber);
    EXPECT_EQ(ended.said, "isolume: interrupted, nothing written\n");
    EXPECT_THAT(entries(), IsEmpty());
  }
}

TEST_F(Interrupt, SignalFromOutsideDuringWriting) {
  // A signal that arrives while writeFileAtomically is busy, at whatever moment, leaves no part of a file behind.
  constexpr int kTrials = 20;
  const std::string old = "old", large(std::size_t{1} << 22, 'x');
  for (int trial = 0; trial < kTrials; ++trial) {
    writeFileAtomically(at("out"), old);
    const Ended ended = runChild([&] {
      const pid_t self = getpid();
      if (fork() == 0) {
        usleep(static_cast<useconds_t>(500 * trial));  // spreads the signals over the phases of writing
        kill(self, SIGINT);
        _exit(0);
      }
      for (;;) writeFileAtomically(at("out"), large);
    });
    EXPECT_EQ(ended.exitCode, 130);
    EXPECT_THAT(ended.said, StartsWith("isolume: interrupted, "));
    EXPECT_THAT(entries(), ElementsAre("out"));
    const std::string now = fileBytes(at("out"));
    EXPECT_TRUE(now == old || now == large) << now.size() << " bytes";
  }
}

TEST_F(Interrupt, AnotherThreadTakesTheSignal) {
  // The file is removed as well when the signal is delivered to a thread that is not the one that writes.
  const Ended ended = runChild([&] {
    UnfinishedFile file(at("temporary"));
    std::thread([] { pthread_kill(pthread_self(), SIGTERM); }).join();
  });
  EXPECT_EQ(ended.exitCode, 143);
  EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(Interrupt, FinishedFilesStay) {
  // What was complete before the interrupt stays, and the line does not claim otherwise.
  const Ended ended = runChild([&] {
    writeFileAtomically(at("out"), "whole");
    raise(SIGINT);
  });
  EXPECT_EQ(ended.exitCode, 130);
  EXPECT_EQ(ended.said, "isolume: interrupted, only files finished before were written\n");
  EXPECT_EQ(fileBytes(at("out")), "whole");
}

TEST_F(Interrupt, DiscardedFileDisappears) {
  // A file that is neither published nor interrupted goes with its owner, and a name that exists is not taken.
  {
    const UnfinishedFile file(at("temporary"));
    ASSERT_TRUE(std::filesystem::exists(at("temporary")));
    EXPECT_EQ(UnfinishedFile(at("temporary")).descriptor(), -1);
  }
  EXPECT_THAT(entries(), IsEmpty());
}

}  // namespace
}  // namespace isolume
