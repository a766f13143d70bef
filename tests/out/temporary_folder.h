// A fixture with a folder of its own for each test.
#pragma once

#include <string>
#include <vector>

#include "support/temp_folder.h"

namespace isolume::test {

class TemporaryFolder : public ::testing::Test {
 protected:
  std::string at(const std::string& name) const { return folder_.path(name); }
  /// Names of all entries, hidden ones too.
  std::vector<std::string> entries() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename());
    }
    return names;
  }

 private:
  TempFolder folder_;
};

}  // namespace isolume::test
