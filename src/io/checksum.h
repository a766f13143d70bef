// SHA-256 of a file, as `sha256sum` prints it.
#pragma once

#include <string>

namespace isolume {

std::string sha256OfFile(const std::string& path);  ///< 64 hex digits; InputError if it cannot be read

}  // namespace isolume
