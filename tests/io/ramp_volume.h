// The volume that the tests of headers read: 2x3x4 samples 0, 1, 2, ...
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/volume.h"
#include "sample_bytes.h"

namespace isolume::test {

/// 2x3x4 samples 0, 1, 2, ...
template <class T>
std::string ramp(bool bigEndian = false) {
  std::vector<T> values;
  for (int i = 0; i < 24; ++i) values.push_back(static_cast<T>(i));
  return bytesOf(values, bigEndian);
}

inline void expectRamp(const Volume& volume) {
  ASSERT_EQ(volume.values.size(), glm::ivec3(2, 3, 4));
  for (std::size_t i = 0; i < 24; ++i) ASSERT_EQ(volume.values.data()[i], static_cast<float>(i));
}

inline void expectSame(const Volume& a, const Volume& b) {
  ASSERT_EQ(a.values.size(), b.values.size());
  // Both compute direction times spacing in double; ITK normalises directions first, which costs a few last bits.
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(a.worldFromGrid[c][r], b.worldFromGrid[c][r], 1e-12) << c << " " << r;
  for (std::size_t i = 0; i < a.values.count(); ++i) ASSERT_EQ(a.values.data()[i], b.values.data()[i]);
}

/// A NRRD header for that volume; `rest` are further lines.
inline std::string nrrdHeader(const std::string& type, const std::string& rest) {
  return "NRRD0004\n# comment\ntype: " + type + "\ndimension: 3\nsizes: 2 3 4\nencoding: raw\nkey:=value\n" + rest;
}

}  // namespace isolume::test
