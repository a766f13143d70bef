// Starts the program as a user does, in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/temp_folder.h"

namespace isolume::test {

struct Outcome {
  int exitCode = -1;  ///< -1 if it was ended by a signal
  int signal = 0;
  std::string out, err;
};

/// Whether Surroundings::terminal can be had: not in a bare chroot.
bool hasPseudoTerminals();

struct Surroundings {
  std::vector<std::pair<std::string, std::string>> environment = {};  ///< added to that of the test
  std::optional<std::size_t> largestFile = {};                        ///< bytes; more is refused, as on a full disk
  bool terminal = false;                                              ///< standard error is a terminal
};

/// A running program with its streams going to files.
class Process {
 public:
  Process(const std::string& folder, const std::vector<std::string>& arguments, const Surroundings& surroundings = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t id() const { return id_; }
  /// Ended, without waiting.
  bool ended();
  Outcome wait();

 private:
  std::string folder_;
  pid_t id_ = -1;
  int terminal_ = -1;  ///< our end of the pseudo-terminal
  std::optional<int> status_;
};

/// A folder that is empty at the start of a case and gone after it; commands run in it.
class ProgramTest : public ::testing::Test {
 protected:
  ~ProgramTest() override;

  Outcome run(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});
  /// As run(), and the case fails unless the exit code is 0.
  Outcome runWell(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  /// Names in the folder, sorted; also hidden ones.
  std::vector<std::string> files() const;

  TempFolder temporary_;
  std::string folder_ = temporary_.path();
};

void writeBytes(const std::string& path, const std::string& bytes);

/// A raw float32 ball: value = radius - |p - centre| in voxels, centre at (n - 1) / 2. Solid above 0.
void writeBall(const std::string& path, int n, double radius);
/// The same as bytes.
std::string ballBytes(int n, double radius);

}  // namespace isolume::test
