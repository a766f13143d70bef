// SHA-256 ([FIPS 180-4]) of a file, as `sha256sum` prints it. Streams in constant memory. Thread-safe.
#pragma once

#include <string>
#include <string_view>

namespace isolume {

std::string sha256OfFile(const std::string& path);  ///< 64 hex digits; InputError if it cannot be read
std::string sha256OfBytes(std::string_view bytes);  ///< the same of bytes in memory

}  // namespace isolume
