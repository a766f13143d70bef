// Stored samples for the tests, made without the code under test.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace isolume::test {

/// The bytes of `values`, most significant byte first on request.
template <class T>
std::string bytesOf(const std::vector<T>& values, bool bigEndian = false) {
  std::string bytes;
  for (const T value : values) {
    char one[sizeof(T)];
    std::memcpy(one, &value, sizeof(T));
    // The tests run on little-endian machines only, as all supported ones are.
    if (bigEndian) std::reverse(one, one + sizeof(T));
    bytes.append(one, sizeof(T));
  }
  return bytes;
}

}  // namespace isolume::test
