// Wall time of something done several times, after one time that is not counted (caches, first-touch pages, threads).
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "sweep/large_array.h"

namespace isolume::bench {

/// Touches and frees 16 bytes for each of `voxels`, so that what comes next finds them. A virtual machine's host takes
/// back what was free for a second or two and is slow to give it again: 187 MB were touched in .03 s where they had
/// just been freed, in .6 s after three seconds of rest. A run would pay for what ran before it. Runs of the same thing
/// one after the other need none of it: each leaves to the next what it takes.
inline void readyMemory(std::size_t voxels) {
  constexpr std::size_t kBytesPerVoxel = 16, kPageBytes = 4096;
  const std::size_t bytes = kBytesPerVoxel * voxels;
  const LargeArray<char> memory = makeLargeArray<char>(bytes);
  for (std::size_t at = 0; at < bytes; at += kPageBytes) static_cast<volatile char*>(memory.get())[at] = 1;
}

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
