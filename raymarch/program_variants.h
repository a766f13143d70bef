// Every shader program that exists, in one table: a test compiles them all.
#pragma once

#include <string>
#include <vector>

namespace isolume {

struct ProgramVariant {
  std::string name;
  std::string vertex;
  std::string fragment;
};
const std::vector<ProgramVariant>& programVariants();
/// The entry of that name; asserts that it exists.
const ProgramVariant& programVariant(const std::string& name);

}  // namespace isolume
