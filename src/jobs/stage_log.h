// Time and memory of the stages of a job, and what the user sees of them while it runs.
//
// Stages: read (file to levels, with the choice of the isovalue), distance, visibility, upload (context, shaders,
// textures), frame (drawing and reading back), write (encoding and writing). `bytes` is the memory that a stage's
// result takes while the job runs, for `write` the size of the file. On a terminal one line on standard error is
// updated per stage; else nothing is printed, nor with --quiet. Not thread-safe.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "src/jobs/run_options.h"

namespace isolume {

struct StageRecord {
  std::string name;
  double seconds = 0;
  std::size_t bytes = 0;
};

class StageLog {
 public:
  explicit StageLog(const RunOptions& options);
  ~StageLog();  ///< clears the progress line
  StageLog(const StageLog&) = delete;
  StageLog& operator=(const StageLog&) = delete;

  /// A stage begins; `doing` is shown on a terminal.
  void begin(const std::string& name, const std::string& doing);
  /// The stage that runs has got further: replaces what is shown on a terminal.
  void progress(const std::string& doing);
  /// The stage that runs ends, with what its result takes.
  void end(std::size_t bytes);
  /// One line for the user, unless --quiet: "isolume: warning: ...". Held back until finish(), so that a job that fails
  /// says one line alone: its error.
  void tell(const std::string& kind, const std::string& line);
  /// The job is done: what was told and, with --verbose, the table of stages, on standard error.
  void finish();

  const std::vector<StageRecord>& stages() const { return stages_; }
  double secondsSinceStart() const;

 private:
  using Clock = std::chrono::steady_clock;
  void clearLine();
  void printTable() const;

  bool quiet_, verbose_, progress_;
  bool lineShown_ = false;
  Clock::time_point start_ = Clock::now(), stageStart_ = start_;
  std::string running_;
  std::vector<StageRecord> stages_;
  std::vector<std::string> told_;
};

/// Largest resident size of this process so far.
std::size_t peakResidentBytes();

}  // namespace isolume
