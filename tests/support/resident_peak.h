// The peak of this process' resident memory, where the system tells it.
#pragma once

#include <cstddef>
#include <fstream>
#include <string>

namespace isolume::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kKeepsFreedMemory = true;
#else
inline constexpr bool kKeepsFreedMemory = false;
#endif

/// A line of /proc/self/status in bytes, 0 if there is none.
inline std::size_t statusBytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == name + ":") {
      std::size_t kilobytes = 0;
      status >> kilobytes;
      return kilobytes * 1024;
    }
  return 0;
}

/// Makes the peak of the resident memory what is resident now; false where that cannot be done.
inline bool resetPeak() {
  std::ofstream("/proc/self/clear_refs") << "5";
  const std::size_t now = statusBytes("VmRSS"), peak = statusBytes("VmHWM");
  constexpr std::size_t kSlack = 1 << 20;  // the two are counted a little apart
  return now != 0 && peak <= now + kSlack;
}

}  // namespace isolume::test
