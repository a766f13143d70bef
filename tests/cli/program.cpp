#include "cli/program.h"

#include <fcntl.h>
#include <pty.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace isolume::test {
namespace {

/// Where the streams go: beside the folder, so that a listing of it shows only what the program wrote.
std::string streamPath(const std::string& folder, const char* stream) { return folder + "." + stream; }

/// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void becomeProgram(const std::string& folder, std::vector<char*>& argv, const Surroundings& surroundings,
                                const std::string& outPath, const std::string& errPath, int terminal) {
  const int out = open(outPath.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
  const int err = terminal >= 0 ? terminal : open(errPath.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  if (chdir(folder.c_str()) != 0) _exit(126);
  if (surroundings.largestFile) {
    const rlimit limit{*surroundings.largestFile, *surroundings.largestFile};
    setrlimit(RLIMIT_FSIZE, &limit);
    signal(SIGXFSZ, SIG_IGN);  // so that write() reports it, as it does on a full disk
  }
  for (const auto& [name, value] : surroundings.environment) setenv(name.c_str(), value.c_str(), 1);
  execv(argv[0], argv.data());
  _exit(127);
}

}  // namespace

bool hasPseudoTerminals() {
  int ours = -1, theirs = -1;
  if (openpty(&ours, &theirs, nullptr, nullptr, nullptr) != 0) return false;
  close(ours);
  close(theirs);
  return true;
}

Process::Process(const std::string& folder, const std::vector<std::string>& arguments, const Surroundings& surroundings)
    : folder_(folder) {
  std::vector<std::string> words{ISOLUME_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  int programEnd = -1;
  if (surroundings.terminal && openpty(&terminal_, &programEnd, nullptr, nullptr, nullptr) != 0) std::abort();
  const std::string out = streamPath(folder, "out"), err = streamPath(folder, "err");
  writeBytes(err, "");
  id_ = fork();
  if (id_ == 0) becomeProgram(folder, argv, surroundings, out, err, programEnd);
  if (programEnd >= 0) close(programEnd);
}

Process::~Process() {
  if (!status_) {
    kill(id_, SIGKILL);
    wait();
  }
  if (terminal_ >= 0) close(terminal_);
}

bool Process::ended() {
  int status = 0;
  if (!status_ && waitpid(id_, &status, WNOHANG) == id_) status_ = status;
  return status_.has_value();
}

Outcome Process::wait() {
  std::string shown;
  if (terminal_ >= 0) {  // reading ends with an error once the program has closed its end
    char buffer[4096];
    for (ssize_t count; (count = read(terminal_, buffer, sizeof buffer)) > 0;) shown.append(buffer, count);
  }
  int status = 0;
  if (!status_) {
    waitpid(id_, &status, 0);
    status_ = status;
  }
  Outcome outcome;
  if (WIFEXITED(*status_)) outcome.exitCode = WEXITSTATUS(*status_);
  if (WIFSIGNALED(*status_)) outcome.signal = WTERMSIG(*status_);
  outcome.out = fileBytes(streamPath(folder_, "out"));
  outcome.err = terminal_ >= 0 ? shown : fileBytes(streamPath(folder_, "err"));
  return outcome;
}

ProgramTest::~ProgramTest() {
  std::error_code ignored;
  for (const char* stream : {"out", "err"}) std::filesystem::remove(streamPath(folder_, stream), ignored);
}

Outcome ProgramTest::run(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  return Process(folder_, arguments, surroundings).wait();
}

Outcome ProgramTest::runWell(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  const Outcome outcome = run(arguments, surroundings);
  EXPECT_EQ(outcome.exitCode, 0) << "signal " << outcome.signal << ", " << outcome.err;
  return outcome;
}

std::vector<std::string> ProgramTest::files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void writeBytes(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  if (!file.flush()) std::abort();
}

std::string ballBytes(int n, double radius) {
  std::string bytes;
  const double centre = (n - 1) / 2.0;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const float value = static_cast<float>(radius - std::hypot(x - centre, y - centre, z - centre));
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
      }
  return bytes;
}

void writeBall(const std::string& path, int n, double radius) { writeBytes(path, ballBytes(n, radius)); }

}  // namespace isolume::test
