// Wall time of something done several times, after one time that is not counted (caches, first-touch pages, threads).
#pragma once

#include <chrono>
#include <vector>

namespace isolume::bench {

template <class Work>
double secondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Work>
std::vector<double> timedRuns(int runs, const Work& work) {
  work();
  std::vector<double> seconds;
  for (int run = 0; run < runs; ++run) seconds.push_back(secondsOf(work));
  return seconds;
}

}  // namespace isolume::bench
