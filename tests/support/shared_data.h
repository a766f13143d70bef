// Real volumes that some tests read: never copied into the project, so a machine may not have them.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace isolume::test {

inline std::string sharedData(const std::string& name) {
  const char* fromEnvironment = std::getenv("ISOLUME_SHARED_DATA");
  return (std::filesystem::path(fromEnvironment ? fromEnvironment : ISOLUME_SHARED_DATA) / name).string();
}

}  // namespace isolume::test

/// Defines `path`; skips the test where that volume is absent, since nothing of it may live in the project.
#define ISOLUME_NEED_SHARED(path, name)                                          \
  const std::string path = ::isolume::test::sharedData(name);                    \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no such volume here: " << path
