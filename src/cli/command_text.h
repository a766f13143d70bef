// A command line as text that a shell takes back.
#pragma once

#include <string>

namespace isolume {

/// "isolume" and the arguments, each quoted where a POSIX shell would otherwise change it.
std::string commandText(int argc, const char* const* argv);

}  // namespace isolume
