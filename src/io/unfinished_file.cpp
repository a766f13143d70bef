#include "unfinished_file.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>

#include "output_file.h"

namespace isolume {
namespace {

// What the handler may look at: lock-free and never freed. `kChanging` marks the moments when the name on the disk and
// the record of it may disagree; the thread that changes them has the signals blocked, so the handler can wait for it.
enum State : int { kNone, kChanging, kUnfinished };
std::atomic<int> recordState{kNone};
std::atomic<bool> anyPublished{false};
char recordedPath[PATH_MAX];
static_assert(std::atomic<int>::is_always_lock_free);

class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &set, &before_);
  }
  ~SignalsBlocked() {
    const int keep = errno;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = keep;
  }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

// Only async-signal-safe calls from here on: poll, unlink, write, _exit.
void onInterrupt(int signalNumber) {
  constexpr int kMillisecond = 1;
  constexpr int kPatienceMilliseconds = 500;  // a rename on a dead network drive must not block Ctrl-C for ever
  for (int waited = 0; recordState.load() == kChanging && waited < kPatienceMilliseconds; ++waited)
    poll(nullptr, 0, kMillisecond);
  if (recordState.load() != kNone) unlink(recordedPath);
  static constexpr char kNothing[] = "isolume: interrupted, nothing written\n";
  static constexpr char kEarlier[] = "isolume: interrupted, only files finished before were written\n";
  const bool earlier = anyPublished.load();
  const ssize_t told =
      write(STDERR_FILENO, earlier ? kEarlier : kNothing, (earlier ? sizeof kEarlier : sizeof kNothing) - 1);
  (void)told;                         // there is nobody left to tell
  constexpr int kExitBySignal = 128;  // the shells' convention
  _exit(kExitBySignal + signalNumber);
}

}  // namespace

void installInterruptHandler() {
  anyPublished = false;  // what the handler tells is about the time from now on
  struct sigaction action {};
  action.sa_handler = onInterrupt;
  sigemptyset(&action.sa_mask);
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

UnfinishedFile::UnfinishedFile(const std::string& path) : path_(path) {
  if (path.size() >= sizeof recordedPath) {
    errno = ENAMETOOLONG;
    return;
  }
  const SignalsBlocked blocked;
  recordState = kChanging;
  std::memcpy(recordedPath, path.c_str(), path.size() + 1);
  constexpr mode_t kReadWriteForAll = 0666;  // less the umask
  descriptor_ = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kReadWriteForAll);
  exists_ = descriptor_ >= 0;
  recordState = exists_ ? kUnfinished : kNone;
}

UnfinishedFile::~UnfinishedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!exists_) return;
  const SignalsBlocked blocked;
  unlink(path_.c_str());
  recordState = kNone;
}

bool UnfinishedFile::close() {
  const int descriptor = descriptor_;
  descriptor_ = -1;
  return ::close(descriptor) == 0;
}

bool UnfinishedFile::publish(const std::string& finalPath) {
  const SignalsBlocked blocked;
  recordState = kChanging;
  const bool renamed = rename(path_.c_str(), finalPath.c_str()) == 0;
  if (renamed) {
    exists_ = false;
    anyPublished = true;
  }
  recordState = renamed ? kNone : kUnfinished;
  return renamed;
}

}  // namespace isolume
