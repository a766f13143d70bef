// The program's version, from the project() line of the top CMakeLists.txt.
#pragma once

#include <string_view>

namespace isolume {

inline constexpr std::string_view kVersion = ISOLUME_VERSION;

}  // namespace isolume
