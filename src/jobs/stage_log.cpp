#include "src/jobs/stage_log.h"

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>

namespace isolume {
namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;

}  // namespace

StageLog::StageLog(const RunOptions& options)
    : quiet_(options.quiet), verbose_(options.verbose), progress_(!options.quiet && isatty(STDERR_FILENO) != 0) {}

StageLog::~StageLog() { clearLine(); }

double StageLog::secondsSinceStart() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

void StageLog::clearLine() {
  if (!lineShown_) return;
  std::fputs("\r\x1b[K", stderr);  // carriage return, erase to the end of the line
  std::fflush(stderr);
  lineShown_ = false;
}

void StageLog::begin(const std::string& name, const std::string& doing) {
  running_ = name;
  progress(doing);
  stageStart_ = Clock::now();
}

void StageLog::progress(const std::string& doing) {
  if (!progress_) return;
  clearLine();
  fmt::print(stderr, "isolume: {} ({:.1f} s) ...", doing, secondsSinceStart());
  std::fflush(stderr);
  lineShown_ = true;
}

void StageLog::end(std::size_t bytes) {
  stages_.push_back({running_, std::chrono::duration<double>(Clock::now() - stageStart_).count(), bytes});
  clearLine();
}

void StageLog::tell(const std::string& kind, const std::string& line) {
  told_.push_back(fmt::format("isolume: {}: {}\n", kind, line));
}

void StageLog::finish() {
  clearLine();
  if (!quiet_)
    for (const std::string& line : told_) fmt::print(stderr, "{}", line);
  told_.clear();
  if (verbose_) printTable();
}

void StageLog::printTable() const {
  fmt::print(stderr, "{:<12}{:>10}{:>12}\n", "stage", "seconds", "MiB");
  for (const StageRecord& stage : stages_) {
    const double mebibytes = static_cast<double>(stage.bytes) / kMebibyte;
    fmt::print(stderr, "{:<12}{:>10.3f}{:>12.1f}\n", stage.name, stage.seconds, mebibytes);
  }
  fmt::print(stderr, "{:<12}{:>10.3f}{:>12.1f}  peak resident\n", "whole job", secondsSinceStart(),
             static_cast<double>(peakResidentBytes()) / kMebibyte);
}

std::size_t peakResidentBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  constexpr std::size_t kUnit = 1024;  // ru_maxrss counts KiB on Linux
  return static_cast<std::size_t>(usage.ru_maxrss) * kUnit;
}

}  // namespace isolume
