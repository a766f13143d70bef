// How a job runs, as opposed to what it makes.
#pragma once

#include <string>

namespace isolume {

struct RunOptions {
  int threads = 0;  ///< 0: all cores
  bool quiet = false;
  bool verbose = false;
  std::string report;   ///< JSON file to write, or ""
  std::string command;  ///< the whole command line, for the record
};

/// Applies --threads to every library that starts threads of its own: oneTBB (and with it OpenVDB), software GL, image
/// and volume readers. To be called before any of them runs. Does nothing for 0.
void limitThreads(int threads);

}  // namespace isolume
